#pragma once

// What the pages of compare, predict and reproduce have in common.

#include <string_view>
#include <vector>

#include "bench/compare/comparison.h"
#include "program/report/page.h"

namespace spoke::compare {

/// The page of a scenario that was measured: its title or name, and what it is about.
report::Page make_page(const Scenario& scenario, std::string subtitle);

/// A list of facts: those of its own, then the machine, its load and this version of Spoke.
void add_facts(report::Page& page, std::vector<report::Fact> own, const Machine& machine,
               const Loads& loads);

/// The end of the page: how all this came about.
void add_method(report::Page& page, std::string_view heading, std::string_view text);

}  // namespace spoke::compare
