// How do costs grow with size? Each from one size to the next as an exponent, 1 where twice as much
// costs twice as much; sizes take turns, and an exponent comes from ratios within a round. Serial:
//
//   four-bar linkages in a row, those of models/four_bar.toml, in one subsystem: a step, and the
//   start of a simulation, which closes the loops and finds redundant rows;
//
//   chains in space, a straight blade of models/spatial_wu_haug.toml in so many bodies: an
//   evaluation.

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bench/four_bars.h"
#include "bench/paper_rotor.h"
#include "bench/progress.h"
#include "bench/questions.h"
#include "bench/repeated_steps.h"
#include "graph/machine/duration_text.h"

namespace spoke::bench {
namespace {

constexpr std::array kRows{2, 10, 40, 160};
constexpr std::array kChains{50, 200, 1000};
constexpr int kLoopSteps = 50, kChainSteps = 3, kElements = 4;
constexpr double kMostExponentOfLoops = 1.2;

SimulationOptions serial() { return {Formulation::structured, ExecutorKind::serial, 1}; }

/// Sizes of one kind, and how long each takes.
struct Growth {
  std::string title, items;
  std::vector<int> sizes{};
  std::vector<Alternative> alternatives{};  ///< by size

  void add(int size, Alternative alternative) {
    alternative.name = std::to_string(size);
    alternative.reference = std::max(0, static_cast<int>(sizes.size()) - 1);
    sizes.push_back(size);
    alternatives.push_back(std::move(alternative));
  }
};

/// Measures, prints and returns the exponents, from the second size on.
std::vector<double> measure_growth(const Growth& growth, const Effort& effort, Report& report) {
  Table table{growth.title + "; all sizes in turns",
              {growth.items, "time", "of it each", "/ size before", "exponent", "rounds"},
              {}};
  std::vector<double> exponents;
  const std::vector<Timing> timings = measure(growth.alternatives, effort);
  for (std::size_t k = 0; k < timings.size(); ++k) {
    const double size = growth.sizes[k];
    if (k > 0)
      exponents.push_back(std::log(timings[k].ratio) / std::log(size / growth.sizes[k - 1]));
    table.rows.push_back(
        {timings[k].name, graph::duration_text(timings[k].least),
         graph::duration_text(timings[k].least / size), k == 0 ? "" : ratio_with_spread(timings[k]),
         k == 0 ? "" : fmt::format("{:.2f}", exponents.back()), std::to_string(timings[k].rounds)});
    report.add_timing(growth.title, timings[k]);
  }
  report.add_table(table);
  return exponents;
}

void measure_rows(const Effort& effort, bool quick, Report& report) {
  Growth steps{"Four-bar linkages in a row, a step", "linkages"};
  Growth starts{"Four-bar linkages in a row, the start", "linkages"};
  for (const int count : kRows) {
    show_progress(fmt::format("{} four-bars: building", count));
    const Scenario scenario = row_of_four_bars(count);
    steps.add(count,
              RepeatedSteps::alternative(
                  "", std::make_shared<RepeatedSteps>(scenario, serial(), 0.0, kLoopSteps), 0));
    if (quick && count == kRows.back()) continue;
    starts.add(count,
               {"", [scenario] { const Simulation simulation(scenario, serial()); }, {}, 1.0, 0});
  }
  const std::vector<double> exponents = measure_growth(steps, effort, report);
  for (std::size_t k = 0; k < exponents.size(); ++k)
    report.add_target(at_most(fmt::format("a step of four-bars in a row, from {} to {}, exponent",
                                          kRows[k], kRows[k + 1]),
                              exponents[k], kMostExponentOfLoops));
  // Small ones many times a turn: the first pays for pages that large ones have given back.
  measure_growth(starts, {effort.rounds, 20.0 * effort.batch_seconds, effort.most_seconds}, report);
}

void measure_chains(const Effort& effort, bool quick, Report& report) {
  Growth growth{"Chains in space, an evaluation", "bodies"};
  for (const int bodies : kChains) {
    if (quick && bodies == kChains.back()) continue;
    show_progress(fmt::format("chain of {} bodies: building", bodies));
    Scenario scenario = sized_rotor("spatial_wu_haug.toml", {1, bodies, kElements}, false);
    scenario.sensors.clear();
    const auto steps = std::make_shared<RepeatedSteps>(scenario, serial(), 0.0, kChainSteps);
    Alternative alternative = RepeatedSteps::alternative("", steps, 0);
    alternative.scale /= steps->evaluations_per_step();
    growth.add(bodies, std::move(alternative));
  }
  measure_growth(growth, effort, report);
}

}  // namespace

void measure_growth(const QuestionOptions& options, Report& report) {
  const Effort effort = options.quick ? Effort{3, 1e-3, 1.0} : Effort{31, 1e-3, 8.0};
  measure_rows(effort, options.quick, report);
  measure_chains(effort, options.quick, report);
}

}  // namespace spoke::bench
