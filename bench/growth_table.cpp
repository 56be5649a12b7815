// An exponent comes from ratios within a round, memory from the pages that a process gets.

#include "bench/growth_table.h"

#include <malloc.h>
#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <utility>

#include "bench/progress.h"
#include "graph/machine/duration_text.h"

namespace spoke::bench {
namespace {

const SimulationOptions kSerial{Formulation::structured, ExecutorKind::serial, 1};

std::string kilobytes(double bytes) { return fmt::format("{:.1f} kB", bytes / 1e3); }

}  // namespace

double resident_memory() {
  malloc_trim(0);
  double size = 0.0, resident = 0.0;
  std::ifstream("/proc/self/statm") >> size >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

void Growth::add(int size, Alternative alternative) {
  alternative.name = std::to_string(size);
  alternative.reference = std::max(0, static_cast<int>(sizes.size()) - 1);
  sizes.push_back(size);
  alternatives.push_back(std::move(alternative));
}

void Growth::add(int size, const Scenario& scenario, int steps, Unit unit) {
  show_progress(fmt::format("{}: building {}", title, size));
  const double before = resident_memory();
  const auto made = std::make_shared<RepeatedSteps>(scenario, kSerial, 0.0, steps);
  memory.push_back(resident_memory() - before);
  Alternative alternative = RepeatedSteps::alternative("", made, 0);
  if (unit == Unit::evaluation) alternative.scale /= made->evaluations_per_step();
  add(size, std::move(alternative));
}

void Growth::add_start(int size, const Scenario& scenario) {
  add(size, {"", [scenario] { const Simulation simulation(scenario, kSerial); }, {}, 1.0, 0});
}

void Growth::add_clone(int size, const Scenario& scenario) {
  const auto original = std::make_shared<const Simulation>(scenario, kSerial);
  add(size, {"", [original] { const Simulation clone = original->clone(); }, {}, 1.0, 0});
}

Exponents measure_growth(const Growth& growth, const Effort& effort, Report& report) {
  Table table{growth.title + "; all sizes in turns",
              {growth.items, "time", "of it each", "/ size before", "exponent", "rounds"},
              {}};
  if (!growth.memory.empty()) table.columns.push_back("memory each");
  Exponents exponents;
  const std::vector<Timing> timings = measure(growth.alternatives, effort);
  for (std::size_t k = 0; k < timings.size(); ++k) {
    const double size = growth.sizes[k];
    if (k > 0) {
      const double larger = size / growth.sizes[k - 1];
      exponents.steps.push_back(std::log(timings[k].ratio) / std::log(larger));
      exponents.per_item *= timings[k].ratio / larger;
    }
    table.rows.push_back({timings[k].name, graph::duration_text(timings[k].least),
                          graph::duration_text(timings[k].least / size),
                          k == 0 ? "" : ratio_with_spread(timings[k]),
                          k == 0 ? "" : fmt::format("{:.2f}", exponents.steps.back()),
                          std::to_string(timings[k].rounds)});
    if (!growth.memory.empty()) table.rows.back().push_back(kilobytes(growth.memory[k] / size));
    report.add_timing(growth.title, timings[k]);
  }
  report.add_table(table);
  return exponents;
}

}  // namespace spoke::bench
