#pragma once

// Writes the runs as the page's script reads them.

#include <cstdint>
#include <string>

#include "program/study/analysis.h"

namespace spoke::study_report {

/// Returns the stride between runs that are drawn: 1 if all are.
std::int64_t drawn_stride(const study::Study& study);

/// Returns the drawn runs in JSON: their numbers, values and responses by column, and the data of a
/// command that repeats one.
std::string make_run_data(const study::Study& study, const study::Sampling& sampling,
                          const study::ForEachRun& for_each);

}  // namespace spoke::study_report
