#pragma once

// The table of a comparison.

#include "bench/compare/comparison.h"
#include "program/report/page.h"

namespace spoke::compare {

/// Returns the results of one formulation as a table for people, with the best row marked as good.
report::Table make_table(const Comparison& comparison, const Model& model);

}  // namespace spoke::compare
