// Calibrates the operations of busy nodes per second, and builds graphs of such nodes.

#include "bench/busy_graph.h"

#include <algorithm>
#include <chrono>
#include <vector>

namespace spoke::bench {
namespace {

using graph::PartId;
using graph::reads;
using graph::StepGraphBuilder;
using graph::writes;

// Operations that each wait for the one before.
struct Busy {
  long operations = 0;
  void operator()() const noexcept {
    volatile double sink = 1.0;
    double value = sink;
    for (long k = 0; k < operations; ++k) value = value * 0.999 + 0.001;
    sink = value;
  }
};

// Returns the least of many short measurements: the time on an undisturbed processor.
double seconds_per_operation() {
  using Clock = std::chrono::steady_clock;
  constexpr Busy sample{20000};
  double least = 1.0;
  for (int k = 0; k < 100; ++k) {
    const auto begin = Clock::now();
    sample();
    least = std::min(least, std::chrono::duration<double>(Clock::now() - begin).count());
  }
  return least / static_cast<double>(sample.operations);
}

class Maker {
 public:
  explicit Maker(Busy busy) : busy_(busy) {}

  PartId add(std::string stage, int blade, int body, const std::vector<PartId>& inputs) {
    const graph::NodeLabel label{std::move(stage), blade, body};
    const PartId output = builder_.add_part(name_of(label), {});
    builder_.add_node(label, reads(inputs), writes(output), busy_);
    return output;
  }
  graph::StepGraph build() { return builder_.build(); }

 private:
  Busy busy_;
  StepGraphBuilder builder_{"blade"};
};

}  // namespace

graph::StepGraph make_busy_graph(const StepShape& shape, double node_seconds) {
  static const double per_operation = seconds_per_operation();
  Maker maker({static_cast<long>(node_seconds / per_operation)});
  const PartId root = maker.add("hub motion", -1, -1, {});
  std::vector<std::vector<PartId>> inverses(static_cast<std::size_t>(shape.blades));
  std::vector<PartId> effective;
  for (int i = 0; i < shape.blades; ++i) {
    std::vector<PartId>& own = inverses[static_cast<std::size_t>(i)];
    const PartId position = maker.add("position", i, -1, {root});
    const PartId velocity = maker.add("velocity", i, -1, {position});
    for (int j = 0; j < shape.bodies; ++j) own.push_back(maker.add("mass", i, j, {velocity}));
    for (int j = 0; j < shape.bodies; ++j) {
      PartId& inverse = own[static_cast<std::size_t>(j)];
      inverse = maker.add("inverse", i, j, {inverse});
    }
    effective.push_back(maker.add("effective", i, -1, own));
  }
  const PartId hub = maker.add("hub solve", -1, -1, effective);
  std::vector<PartId> recovered;
  for (int i = 0; i < shape.blades; ++i) {
    const PartId multipliers = maker.add("multipliers", i, -1, {hub});
    for (int j = 0; j < shape.bodies; ++j) {
      const PartId inverse = inverses[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
      recovered.push_back(maker.add("recovery", i, j, {multipliers, inverse}));
    }
  }
  maker.add("finish", -1, -1, recovered);
  return maker.build();
}

}  // namespace spoke::bench
