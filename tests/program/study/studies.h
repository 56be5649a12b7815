#pragma once

// Studies made in code, whose runs are functions of the parameters.

#include <functional>
#include <vector>

#include "program/study/analysis.h"
#include "program/study/sampling.h"
#include "program/study/study.h"

namespace spoke::test {

/// Makes a study of uniform parameters "x1", "x2", ... from low to high, and one response "y".
study::Study make_study(study::DesignKind kind, int parameters, double low, double high,
                        std::int64_t runs_or_points);

/// Analyses a study whose only response is a function of the parameters.
study::Analysis analyse_function(const study::Study& study,
                                 const std::function<double(const std::vector<double>&)>& function);

}  // namespace spoke::test
