// How do costs grow with size? Each from one size to the next as an exponent, 1 where twice as much
// costs twice as much; sizes take turns, and an exponent comes from ratios within a round. Serial:
//
//   four-bar linkages in a row, those of models/four_bar.toml, in one subsystem: a step, and the
//   start of a simulation, which closes the loops and finds redundant rows;
//
//   chains, a straight blade in so many bodies, in space and in the plane: an evaluation, the
//   start, and the memory of a simulation;
//
//   rotors in space, by blades: the same;
//
//   solids in the coordinates of their nodes, by coordinates: the same; and of all these kinds what
//   a clone takes;
//
//   the largest of each kind, rotors of 1,000 blades of 64 bodies, with and without 100 springs
//   from each blade to its hub, and two shipped models: memory, work, span, and what many
//   processors could make of them.

#include <spdlog/fmt/fmt.h>

#include <array>
#include <string>
#include <vector>

#include "bench/four_bars.h"
#include "bench/growth_bounds.h"
#include "bench/growth_models.h"
#include "bench/growth_table.h"
#include "bench/questions.h"

namespace spoke::bench {
namespace {

constexpr std::array kRows{2, 10, 40, 160};
constexpr std::array kChains{50, 200, 1000, 4000};
constexpr std::array kBlades{3, 30, 300};
constexpr std::array kCells{8, 16, 32, 64};
constexpr int kLoopSteps = 50, kSteps = 3;
constexpr int kManyBlades = 1000, kSpringsPerBlade = 100;
constexpr double kMostExponentOfLoops = 1.2, kMostPerBody = 1.5;

/// Small ones many times a turn: the first pays for pages that large ones have given back.
Effort effort_of_starts(const Effort& effort) {
  return {effort.rounds, 20.0 * effort.batch_seconds, effort.most_seconds};
}

void measure_rows(const Effort& effort, bool quick, Report& report) {
  Growth steps{"Four-bar linkages in a row, a step", "linkages"};
  Growth starts{"Four-bar linkages in a row, the start", "linkages"};
  for (const int count : kRows) {
    const Scenario scenario = row_of_four_bars(count);
    steps.add(count, scenario, kLoopSteps, Growth::Unit::step);
    if (!quick || count != kRows.back()) starts.add_start(count, scenario);
  }
  const std::vector<double> exponents = measure_growth(steps, effort, report).steps;
  for (std::size_t k = 0; k < exponents.size(); ++k)
    report.add_target(at_most(fmt::format("a step of four-bars in a row, from {} to {}, exponent",
                                          kRows[k], kRows[k + 1]),
                              exponents[k], kMostExponentOfLoops));
  measure_growth(starts, effort_of_starts(effort), report);
}

/// Measures evaluations and starts of a kind by `sizes`, of which a smoke run leaves out the last
/// two. Returns the cost of an item of the largest size by that of one of the smallest.
template <std::size_t n>
double measure_kind(const std::string& kind, const std::string& items,
                    const std::array<int, n>& sizes, Scenario (*make)(int), int (*count)(int),
                    const Effort& effort, bool quick, Report& report) {
  Growth evaluations{kind + ", an evaluation", items}, starts{kind + ", the start", items};
  Growth clones{kind + ", a clone", items};
  for (std::size_t k = 0; k < (quick ? n - 2 : n); ++k) {
    const Scenario scenario = make(sizes[k]);
    evaluations.add(count(sizes[k]), scenario, kSteps, Growth::Unit::evaluation);
    starts.add_start(count(sizes[k]), scenario);
    clones.add_clone(count(sizes[k]), scenario);
  }
  const double per_item = measure_growth(evaluations, effort, report).per_item;
  measure_growth(starts, effort_of_starts(effort), report);
  measure_growth(clones, effort_of_starts(effort), report);
  return per_item;
}

int same(int size) { return size; }

void measure_chains(const Effort& effort, bool quick, Report& report) {
  const double in_space = measure_kind("Chains in space", "bodies", kChains, chain_in_space, same,
                                       effort, quick, report);
  const double in_plane = measure_kind("Chains in the plane", "bodies", kChains, chain_in_plane,
                                       same, effort, quick, report);
  const std::string name = fmt::format(", a body of {} by one of {}",
                                       quick ? kChains[1] : kChains.back(), kChains.front());
  report.add_target(at_most("chains in space" + name, in_space, kMostPerBody));
  report.add_target(at_most("chains in the plane" + name, in_plane, kMostPerBody));
}

/// Measures what many processors could make of large models; a smoke run of small ones.
void measure_large(bool quick, Report& report) {
  const auto name = [](const char* text, int count) {
    return fmt::format(fmt::runtime(text), count);
  };
  std::vector<LargeModel> models;
  const int row = quick ? kRows[0] : kRows.back(), chain = quick ? kChains[0] : kChains.back(),
            blades = quick ? kBlades[0] : kBlades.back(), cells = quick ? kCells[0] : kCells.back();
  models.push_back({name("{} four-bars in a row", row), row_of_four_bars(row)});
  models.push_back({name("chain of {} bodies in space", chain), chain_in_space(chain)});
  models.push_back({name("chain of {} bodies in the plane", chain), chain_in_plane(chain)});
  models.push_back({name("rotor of {} blades", blades), rotor_in_space(blades)});
  models.push_back(
      {name("nodal solid of {} coordinates", count_unknowns(cells)), nodal_bar(cells)});
  const int many = quick ? 3 : kManyBlades;
  models.push_back({name("rotor of {} blades of 64 bodies", many), sprung_rotor(many, 64, 0)});
  models.push_back(
      {name("the same, 100 springs a blade", many), sprung_rotor(many, 64, kSpringsPerBlade)});
  for (const std::string file : {"nrel_5mw_in_wind.toml", "solid_blade_rotor.toml"})
    models.push_back({file, read_scenario(SPOKE_MODELS_DIR "/" + file)});
  measure_bounds(models, report);
}

}  // namespace

void measure_growth(const QuestionOptions& options, Report& report) {
  const bool quick = options.quick;
  const Effort effort = quick ? Effort{3, 1e-3, 1.0} : Effort{31, 1e-3, 8.0};
  measure_rows(effort, quick, report);
  measure_chains(effort, quick, report);
  measure_kind("Rotors in space", "blades", kBlades, rotor_in_space, same, effort, quick, report);
  measure_kind("Solids in the coordinates of their nodes", "coordinates", kCells, nodal_bar,
               count_unknowns, effort, quick, report);
  measure_large(quick, report);
}

}  // namespace spoke::bench
