// The page reproduce.html: a part for each table and figure of the paper.

#include <spdlog/fmt/fmt.h>

#include "bench/compare/page.h"
#include "bench/reproduce/charts.h"
#include "bench/reproduce/claims.h"
#include "bench/reproduce/files.h"
#include "bench/reproduce/paper.h"
#include "bench/reproduce/tables.h"

namespace spoke::reproduce {
namespace {

using report::Page;

std::vector<report::Fact> facts_of(const Reproduction& all) {
  const Integration& integration = all.scenario.integration;
  return {{"steps timed", fmt::format("{}, step {:.6g} s, from t = 0", name_of(integration.method),
                                      integration.step)},
          {"rounds", std::to_string(all.rounds)},
          {"the paper's machine", std::string(paper::kMachine)}};
}

/// Adds claims on times, and a note if this build lacks OpenMP and so cannot measure all of them.
void add_claims(Page& page, const std::vector<Claim>& claims) {
  if (!has_schemes())
    page.add_paragraph("This build is without OpenMP: the paper's two schemes were not measured.");
  if (!claims.empty()) page.add_table(claim_table(claims));
}

void add_model(Page& page, const Reproduction& all) {
  page.add_heading("Table 2: operation counts");
  page.add_table(claim_table(claims_on_counts()));
  page.add_table(paper_counts());
  page.add_table(our_counts());
  page.add_heading("Fig. 8: motion of the hub");
  page.add_table(claim_table(claims_on_drive(all)));
  page.add_figure(render(speed_chart(all)));
  page.add_figure(render(angle_chart(all)));
  page.add_figure(render(acceleration_chart(all)));
  page.add_heading("Fig. 9: deflection of the tip");
  page.add_figure(render(deflection_chart(all)));
  page.add_table(deflection_table(all));
}

void add_threads(Page& page, const Reproduction& all) {
  page.add_heading("Fig. 10: threads for the subsystems");
  add_claims(page, claims_on_subsystem_threads(all));
  if (has_schemes()) {
    const report::LineChart chart = subsystem_chart(all);
    page.add_figure(render(chart), chart.y.kind == report::ScaleKind::log
                                       ? "The axis is logarithmic. Bands: quartiles of the rounds."
                                       : "Bands: quartiles of the rounds.");
    page.add_table(subsystem_table(all));
  }
  page.add_heading("Fig. 11: two layers of threads, the whole step");
  add_claims(page, claims_on_layers(all));
  if (has_schemes()) {
    page.add_figure(render(layered_chart(all, Work::steps)),
                    "The axis is logarithmic. Whiskers: quartiles of the rounds.");
    page.add_table(layered_table(all, Work::steps));
  }
  page.add_heading("Fig. 12: two layers of threads, the inverse part");
  add_claims(page, claims_on_inverse(all));
  if (has_schemes()) {
    page.add_figure(render(layered_chart(all, Work::inverse)),
                    "The axis is logarithmic. Whiskers: quartiles of the rounds.");
    page.add_table(layered_table(all, Work::inverse));
  }
}

void add_methods(Page& page, const Reproduction& all) {
  page.add_heading("Fig. 13 and Table 3: the methods");
  add_claims(page, claims_on_methods(all));
  page.add_figure(render(method_chart(all)),
                  "The axis is logarithmic: compare ends, not lengths. The implicit step is of "
                  "another size than the others.");
  page.add_table(method_table(all));
}

void add_method_of_measurement(Page& page) {
  page.add_heading("How this was measured");
  page.add_paragraph(fmt::format(
      "Every configuration runs in a process of its own. After {} trials of a quarter of a batch "
      "and {} untimed batches, or fewer of what is slow, come rounds; in each, every process runs "
      "one batch of steps while "
      "all others are halted. Times are medians over the rounds, speedups and ratios are medians "
      "of ratios within a round, so that a quotient of two medians may differ from them. The "
      "thread figures use the formulation subsystem, whose dense blocks are the paper's. The paper "
      "does not print its integrator or its step; an explicit one is what its small steps suggest, "
      "here rk4 with four evaluations a step, so compare ratios, not milliseconds. A number of the "
      "paper holds if ours, with both quartiles over three rounds or more, meets the condition; "
      "open "
      "is where they lie on both sides of it, and where threads were timed on a busy machine.",
      compare::kTrials, compare::kWarmUpBatches));
  page.add_paragraph(
      "The paper: J.-B. Han, H. Song and S.-S. Kim, Study on Parallel Processing for Efficient "
      "Flexible Multibody Analysis based on Subsystem Synthesis Method, Trans. Korean Soc. Mech. "
      "Eng. A 41(6), 2017, 507-515, doi 10.3795/KSME-A.2017.41.6.507.");
}

}  // namespace

std::string make_html(const Reproduction& all) {
  Page page("The paper's evaluation, on this machine",
            "Han, Song and Kim 2017: three blades of four bodies of four elements");
  if (is_disturbed(all)) page.add_note(kDisturbed, report::Tone::warning);
  compare::add_facts(page, facts_of(all), all.machine, all.loads);
  add_model(page, all);
  add_threads(page, all);
  add_methods(page, all);
  add_method_of_measurement(page);
  return page.html();
}

}  // namespace spoke::reproduce
