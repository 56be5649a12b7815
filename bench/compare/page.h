#pragma once

// Common parts of the pages of compare and reproduce.

#include <string_view>
#include <vector>

#include "bench/compare/comparison.h"
#include "program/report/page.h"

namespace spoke::compare {

/// Makes the page of a scenario that was measured, under its title or name and the subtitle.
report::Page make_page(const Scenario& scenario, std::string subtitle);

/// Adds a list of facts: the page's own, then the machine, its load and this version of Spoke.
void add_facts(report::Page& page, std::vector<report::Fact> own, const Machine& machine,
               const Loads& loads);

/// Adds the last section of the page: the method of measurement.
void add_method(report::Page& page, std::string_view heading, std::string_view text);

}  // namespace spoke::compare
