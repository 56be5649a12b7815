#pragma once

// compare.json, compare.csv and compare.html; docs/compare.md documents every field.

#include <string>

#include "bench/compare/comparison.h"

namespace spoke::compare {

/// Returns everything: scenario, machine, models, and the figures and all samples of each
/// configuration.
std::string make_json(const Comparison& comparison);
/// Returns a row of figures for each configuration.
std::string make_csv(const Comparison& comparison);
/// Returns conclusion, charts and tables as a page.
std::string make_html(const Comparison& comparison);

}  // namespace spoke::compare
