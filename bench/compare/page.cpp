// Titles, facts of the machine, and the paragraph on the method.

#include "bench/compare/page.h"

#include <spdlog/fmt/fmt.h>

#include <utility>

namespace spoke::compare {
namespace {

std::string load_text(const Loads& loads) {
  if (loads.before < 0.0) return "not known";
  return fmt::format("{:.2f} before, {:.2f} after", loads.before, loads.after);
}

}  // namespace

report::Page make_page(const Scenario& scenario, std::string subtitle) {
  return report::Page(scenario.title.empty() ? scenario.name : scenario.title, std::move(subtitle));
}

void add_facts(report::Page& page, std::vector<report::Fact> own, const Machine& machine,
               const Loads& loads) {
  own.insert(own.end(), {{"processor", machine.cpu},
                         {"processors available", std::to_string(machine.cores)},
                         {"load average", load_text(loads)},
                         {"system", machine.os},
                         {"compiler", machine.compiler},
                         {"spoke", SPOKE_VERSION}});
  page.add_facts(own);
}

void add_method(report::Page& page, std::string_view heading, std::string_view text) {
  page.add_heading(heading);
  page.add_paragraph(text);
}

}  // namespace spoke::compare
