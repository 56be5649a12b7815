// What do solids cost? One pass of the step graph that only evaluates, of one bar on a turning hub
// with geometric stiffening:
//
//   reduced, r = 20 and 50: serial.
//   in nodal coordinates, 7,000 unknowns in four slices: serial, and by oneTBB on two threads.
//
// And the time in which 20 modes of 25,000 unknowns are found, without the cache.

#include <spdlog/fmt/fmt.h>

#include <chrono>
#include <cmath>
#include <stdexcept>

#include "bench/box_mesh.h"
#include "bench/compare/interleaved.h"
#include "bench/progress.h"
#include "bench/questions.h"
#include "engine/step/run/time_stepper.h"
#include "engine/step/step_graph_builder.h"
#include "graph/machine/duration_text.h"
#include "models/solid/solid.h"
#include "models/system/spatial_system.h"

namespace spoke::bench {
namespace {

constexpr double kMostReduced20 = 3e-6, kMostReduced50 = 9e-6, kMostNodal = 6.5e-3;  // s
constexpr double kMostModes = 6.0;                                                   // s
constexpr double kLeastSpeedup = 1.7;
constexpr BoxSize kBar{{24, 3, 3}, {2.4, 0.3, 0.3}}, kPlate{{20, 20, 2}, {1.0, 1.0, 0.05}};
/// Coordinates of the interface at the tip, which are among those of a reduced solid.
constexpr int kInterface = 6;

spatial::PlaneNodes plane_at(double x) {
  return {spatial::Vector(x, 0.0, 0.0), spatial::Vector::UnitX(), 1e-6};
}

spatial::SolidBody make_solid(const BoxSize& size) {
  spatial::SolidBody body;
  body.mesh = std::make_shared<const spatial::SolidMesh>(make_box_mesh(size));
  body.material = spatial::SolidMaterial{7e10, 0.33, 2700.0};
  body.interfaces.push_back({"root", plane_at(0.0), spatial::InterfaceKind::rigid, {}});
  body.interfaces.push_back({"tip", plane_at(size.lengths[0]), spatial::InterfaceKind::rigid, {}});
  return body;
}

System<Space> make_turning(const spatial::SolidBody& body) {
  spatial::Model model;
  model.hub.drive = ConstantSpeed{5.0};
  spatial::Subsystem subsystem;
  subsystem.name = "bar";
  subsystem.bodies = {{"bar", body}};
  spatial::SubsystemJoint joint;
  joint.parent = "hub";
  joint.child = "bar";
  joint.joint.kind = spatial::JointKind::fixed;
  subsystem.joints = {joint};
  model.subsystems = {subsystem};
  return make_system(model);
}

/// A system whose accelerations are evaluated at a small deformation.
class EvaluatedSolid {
 public:
  EvaluatedSolid(const System<Space>& system, graph::ExecutorKind kind, int threads) {
    context_.system = system;
    context_.integrator.method = make_generalized_alpha(0.8, 1e-3);
    allocate(context_);
    graph_ = std::make_unique<graph::StepGraph>(build_step_graph(context_));
    executor_ = graph::make_executor(*graph_, kind, graph::Threads{threads});
    TimeStepper stepper(context_, *graph_);
    if (stepper.start() != StepOutcome::done)
      throw std::runtime_error("solids: the start cannot be evaluated");
    CoordinateBlock& block = body().coordinates;
    for (int k = 0; k < block.size; ++k) {
      block.q[k] = 1e-5 * std::sin(1.0 + k);
      block.v[k] = 1e-4 * std::cos(2.0 + k);
    }
  }

  void evaluate() {
    for (StepProgress& progress : context_.data.progress) progress = StepProgress{};
    executor_->run();
  }
  int unknowns() { return body().coordinates.size; }
  /// Returns the sum of all accelerations: a few bits of them that differ change it.
  double sum() {
    const CoordinateBlock& block = body().coordinates;
    double sum = 0.0;
    for (int k = 0; k < block.size; ++k) sum += block.a[k] * (1.0 + 0.1 * k);
    return sum;
  }

 private:
  BodyData<Space>& body() { return context_.data.subsystems[0].bodies[0]; }

  SystemContext<Space> context_;
  std::unique_ptr<graph::StepGraph> graph_;
  std::unique_ptr<graph::Executor> executor_;
};
using SolidPointer = std::shared_ptr<EvaluatedSolid>;

Alternative make_alternative(const std::string& name, const SolidPointer& solid, int reference) {
  solid->evaluate();
  return {name, [solid] { solid->evaluate(); }, {}, 1.0, reference};
}

SolidPointer make_reduced(int coordinates) {
  show_progress(fmt::format("reduced, r = {}: building", coordinates));
  spatial::SolidBody body = make_solid({{12, 2, 2}, {2.4, 0.3, 0.3}});
  body.modes = coordinates - kInterface;
  return std::make_shared<EvaluatedSolid>(make_turning(body), graph::ExecutorKind::serial, 1);
}

void measure_reduced(const Effort& effort, Report& report) {
  const std::vector<Timing> timings = measure({make_alternative("r = 20", make_reduced(20), 0),
                                               make_alternative("r = 50", make_reduced(50), 0)},
                                              effort);
  Table table{"One evaluation of a reduced solid, serial; both in turns",
              {"coordinates", "time", "rounds"},
              {}};
  for (const Timing& timing : timings) {
    table.rows.push_back(
        {timing.name, graph::duration_text(timing.least), std::to_string(timing.rounds)});
    report.add_timing("reduced solid", timing);
  }
  report.add_table(table);
  report.add_target(at_most("a reduced solid, r = 20, an evaluation, us", 1e6 * timings[0].least,
                            1e6 * kMostReduced20));
  report.add_target(at_most("a reduced solid, r = 50, an evaluation, us", 1e6 * timings[1].least,
                            1e6 * kMostReduced50));
}

void measure_nodal(const Effort& effort, Report& report) {
  show_progress("nodal coordinates: building");
  spatial::SolidBody body = make_solid(kBar);
  body.coordinates = spatial::SolidCoordinates::nodal;
  const System<Space> system = make_turning(body);
  const auto make = [&system](graph::ExecutorKind kind, int threads) {
    return std::make_shared<EvaluatedSolid>(system, kind, threads);
  };
  const SolidPointer serial = make(graph::ExecutorKind::serial, 1),
                     shared = make(graph::ExecutorKind::flow_graph, 2),
                     scheme = make(graph::ExecutorKind::openmp_levels, 2);
  const std::vector<Timing> timings =
      measure({make_alternative("serial", serial, 0), make_alternative("oneTBB, 2", shared, 0),
               make_alternative("OpenMP levels, 2", scheme, 0)},
              effort);
  if (serial->sum() != shared->sum() || serial->sum() != scheme->sum())
    throw std::runtime_error("solids: executors differ in the accelerations");
  Table table{fmt::format("One evaluation of a solid of {} nodal coordinates, by executor and "
                          "threads; all in turns",
                          serial->unknowns()),
              {"executor", "time", "/ serial", "rounds"},
              {}};
  for (const Timing& timing : timings) {
    table.rows.push_back({timing.name, graph::duration_text(timing.least),
                          ratio_with_spread(timing), std::to_string(timing.rounds)});
    report.add_timing("nodal solid", timing);
  }
  report.add_table(table);
  report.add_target(at_most("7,000 nodal coordinates, an evaluation, ms", 1e3 * timings[0].least,
                            1e3 * kMostNodal));
  report.add_target(at_least("7,000 nodal coordinates, 2 threads, speedup", 1.0 / timings[1].ratio,
                             kLeastSpeedup));
}

void measure_modes(Report& report) {
  show_progress("20 modes of 25,000 unknowns");
  spatial::SolidBody body = make_solid(kPlate);
  body.geometric_stiffening = false;
  body.modes = 20;
  solid::CacheUse cache;
  cache.reads = false;
  const auto start = std::chrono::steady_clock::now();
  const auto constants = solid::make_constants(body, {}, {}, &cache);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  report.add_target(at_most(
      fmt::format("20 modes of {} unknowns, from mesh to matrices, s", 3 * constants->nodes.size()),
      time.count(), kMostModes));
}

}  // namespace

void measure_solids(const QuestionOptions& options, Report& report) {
  const Effort effort = options.quick ? Effort{3, 1e-3, 1.0} : Effort{51, 1e-3, 6.0};
  measure_reduced(effort, report);
  measure_nodal(effort, report);
  if (!options.quick) measure_modes(report);
}

}  // namespace spoke::bench
