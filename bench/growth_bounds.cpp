// Costs of nodes are medians over some rounds of steps, and schedules those of the flow graph.

#include "bench/growth_bounds.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <limits>
#include <memory>
#include <utility>

#include "bench/growth_table.h"
#include "bench/progress.h"
#include "engine/simulation.h"
#include "engine/simulation/node_measurement.h"
#include "graph/calibrate/quantiles.h"
#include "graph/machine/duration_text.h"
#include "graph/tune/run_prediction.h"

namespace spoke::bench {
namespace {

constexpr std::array kProcessors{16, 64, 256};
constexpr int kRounds = 3, kSteps = 4;

/// Returns how long `work` takes [s].
template <class Work>
double seconds_of(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::string count_text(double count) { return fmt::format("{:.0f}", count); }

/// Returns the costs of the nodes of a run: medians over some rounds [s].
std::vector<double> measure_costs(Simulation& simulation) {
  std::vector<std::vector<double>> rounds;
  for (int round = 0; round < kRounds; ++round)
    rounds.push_back(measure_nodes(simulation, kSteps).costs);
  std::vector<double> costs;
  for (std::size_t node = 0; node < rounds.front().size(); ++node) {
    std::vector<double> samples;
    for (const std::vector<double>& round : rounds) samples.push_back(round[node]);
    costs.push_back(graph::median(std::move(samples)));
  }
  return costs;
}

std::vector<std::string> measure_bounds(const LargeModel& model, Report& report) {
  show_progress(model.name + ": building");
  const double before = resident_memory();
  std::unique_ptr<Simulation> simulation;
  const double start = seconds_of([&] {
    simulation = std::make_unique<Simulation>(
        model.scenario, SimulationOptions{Formulation::structured, ExecutorKind::serial, 1, 1});
  });
  const double memory = resident_memory() - before;
  double clone = std::numeric_limits<double>::infinity();
  for (int round = 0; round < kRounds; ++round)
    clone = std::min(clone, seconds_of([&] { const Simulation made = simulation->clone(); }));
  show_progress(model.name + ": measuring nodes");
  const graph::RunPredictor predictor(simulation->run_graph(), measure_costs(*simulation));
  const double work = predictor.work(), span = predictor.span();
  const ModelSize size = simulation->size();
  std::vector<std::string> row{model.name,
                               count_text(size.bodies),
                               count_text(size.loops),
                               fmt::format("{:.2f} GB", memory / 1e9),
                               graph::duration_text(start),
                               graph::duration_text(clone),
                               graph::duration_text(work),
                               graph::duration_text(span),
                               figure(work / span)};
  Json result = {{"model", model.name},    {"bodies", size.bodies}, {"loops", size.loops},
                 {"memory_bytes", memory}, {"start_s", start},      {"clone_s", clone},
                 {"work_s", work},         {"span_s", span}};
  for (const int processors : kProcessors) {
    const double expected = predictor.schedule(processors, graph::Overheads{});
    const double bound = work / processors + span;
    row.push_back(fmt::format("{} [{}]", figure(work / expected), figure(work / bound)));
    result.set(fmt::format("speedup_{}", processors), work / expected);
    result.set(fmt::format("speedup_by_bound_{}", processors), work / bound);
  }
  report.add_result(std::move(result));
  return row;
}

}  // namespace

void measure_bounds(const std::vector<LargeModel>& models, Report& report) {
  Table table{
      "Large models, an evaluation; on so many processors, times as fast [by the bound]",
      {"model", "bodies", "loops", "memory", "start", "clone", "work", "span", "work / span"},
      {}};
  for (const int processors : kProcessors) table.columns.push_back(std::to_string(processors));
  for (const LargeModel& model : models) table.rows.push_back(measure_bounds(model, report));
  report.add_table(table);
  report.add_remark(
      "Work and span are those of a run of one pass, by node costs measured here. Processors are "
      "as fast as this one, and share neither caches nor memory's bandwidth: the first figure is "
      "by a schedule of flow_graph with what tasks cost, the one in brackets by the time that any "
      "greedy schedule keeps to if tasks cost nothing, work/P + span.");
}

}  // namespace spoke::bench
