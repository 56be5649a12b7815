#pragma once

// compare.json, compare.csv and compare.html; docs/compare.md documents every field.

#include <string>

#include "bench/compare/comparison.h"

namespace spoke::compare {

/// Everything: scenario, machine, models, and per configuration its figures and all samples.
std::string make_json(const Comparison& comparison);
/// A row of figures per configuration.
std::string make_csv(const Comparison& comparison);
/// Conclusion, charts and tables as a page.
std::string make_html(const Comparison& comparison);

}  // namespace spoke::compare
