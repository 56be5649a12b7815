#pragma once

// The runs as the page's script reads them.

#include <cstdint>
#include <string>

#include "engine/study/analysis.h"

namespace spoke::study_report {

/// Between runs that are drawn: 1 if all are.
std::int64_t drawn_stride(const study::Study& study);

/// The drawn runs in JSON: their numbers, values and responses by column, and what a command needs
/// to make one again.
std::string make_run_data(const study::Study& study, const study::Sampling& sampling,
                          const study::ForEachRun& for_each);

}  // namespace spoke::study_report
