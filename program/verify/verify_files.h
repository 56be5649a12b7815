#pragma once

// What `spoke verify` writes: verify.csv, verify.json, verify.html, and the table of the docs.

#include <string>
#include <vector>

#include "program/report/page.h"
#include "program/verify/run_cases.h"

namespace spoke::verify {

/// Returns one row per figure.
std::string make_csv(const std::vector<CaseResult>& results);
std::string make_json(const std::vector<CaseResult>& results);
std::string make_html(const std::vector<CaseResult>& results);
/// Returns the page of the documentation, in Markdown.
std::string make_markdown(const std::vector<CaseResult>& results);

/// Returns "41 cases, 90 figures, all within their stated errors".
std::string describe(const Tally& tally);
/// Returns the figures as a table; `only_off`: those that do not hold.
report::Table make_table(const std::vector<CaseResult>& results, bool only_off);

}  // namespace spoke::verify
