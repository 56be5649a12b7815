// What does recording which node ran when cost? Whole steps of rotors whose nodes take 1 us on
// average on this machine, and shorter ones beside them: first by a loop without a recorder and by
// the executor serial with recording off; then by each executor with recording off and on. Only two
// alternatives take turns at a time, so that each finds the threads and caches as the other left
// them. Graphs of artificial nodes say less here: a time stamp keeps the processor from beginning a
// node before the last one has ended, which costs such nodes, independent chains of operations, a
// tenth.

#include <array>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bench/compare/interleaved.h"
#include "bench/paper_rotor.h"
#include "bench/progress.h"
#include "bench/questions.h"
#include "engine/step/run/step_recording.h"
#include "engine/step/step_graph_builder.h"
#include "graph/executor.h"
#include "graph/machine/duration_text.h"

namespace spoke::bench {
namespace {

using graph::Executor;
using graph::ExecutorKind;
using graph::NodeId;
using graph::StepGraph;

constexpr int kPasses = 2;  // passes of a step, for every alternative alike

// The cost of recording is promised for nodes that take at least that long on average [s].
constexpr double kLongNode = 1e-6;

struct Case {
  RotorSize size;
  Formulation formulation = Formulation::structured;
  bool is_promised = true;  // whether nodes are long enough for the promise
};

/// An executor that is recorded.
struct Recorded {
  ExecutorKind kind;
  int threads;
  const char* column;
  const char* name;
};
// The OpenMP executor comes last: its threads spin on after a run.
const std::array kRecorded{
    Recorded{ExecutorKind::serial, 1, "serial on", "serial"},
    Recorded{ExecutorKind::flow_graph, 1, "flow 1 on", "flow_graph on 1 thread"},
    Recorded{ExecutorKind::flow_graph, 2, "flow 2 on", "flow_graph on 2 threads"},
    Recorded{ExecutorKind::automatic, 2, "auto 2 on", "auto on 2 threads"},
    Recorded{ExecutorKind::openmp_levels, 2, "levels 2 on", "openmp_levels on 2 threads"}};

Effort effort_of(const QuestionOptions& options) {
  return options.quick ? Effort{5, 1e-3, 0.3} : Effort{401, 2e-3, 4.0};
}

/// The executor serial as it was before it could record.
class PlainLoop final : public Executor {
 public:
  explicit PlainLoop(const StepGraph& graph) : graph_(graph) {}
  void run() override {
    for (const NodeId node : graph_.serial_order()) graph_.run_node(node);
  }
  std::string_view name() const override { return "loop without recorder"; }
  graph::Threads threads() const override { return 1; }

 private:
  const StepGraph& graph_;
};

/// A rotor that makes steps in batches.
class Model {
 public:
  explicit Model(const Case& which) {
    context_.system = make_system(paper_rotor(which.size, true).rotor);
    context_.formulation = which.formulation;
    context_.integrator = {make_generalized_alpha(0.8, 1e-3), {.fixed = kPasses}};
    allocate(context_);
    graph_ = std::make_unique<StepGraph>(build_step_graph(context_));
    stepper_ = std::make_unique<TimeStepper>(context_, *graph_);
    if (stepper_->start() != StepOutcome::done) throw std::runtime_error("the rotor cannot start");
  }

  void use_plain_loop() { executor_ = std::make_unique<PlainLoop>(*graph_); }
  void use(ExecutorKind kind, int threads) {
    executor_ = graph::make_executor(*graph_, kind, threads);
  }
  /// Steps until an executor that chooses has chosen.
  void settle() {
    while (executor_->tuning()) advance(8);
  }
  const StepGraph& graph() const { return *graph_; }
  std::string_view name() const { return executor_->name(); }

  void advance(int steps) {
    if (stepper_->advance(stepper_->steps() + steps, *executor_) != StepOutcome::done)
      throw std::runtime_error("the rotor cannot be stepped on");
  }
  /// Makes room for recording the next `steps` steps, and records them if `is_recorded`.
  void make_room(int steps, bool is_recorded) {
    constexpr std::size_t most_bytes = std::size_t{256} << 20;
    stepper_->watch_runs(nullptr);
    executor_->set_recorder(nullptr);
    recording_ = std::make_unique<StepRecording>(
        *graph_, context_.data,
        RecordingPlan{stepper_->steps() + 1, stepper_->steps() + steps, kPasses,
                      executor_->threads().total(), most_bytes});
    if (!is_recorded) return;
    executor_->set_recorder(&recording_->recorder());
    stepper_->watch_runs(recording_.get());
  }

 private:
  SystemContext<Plane> context_;
  std::unique_ptr<StepGraph> graph_;
  std::unique_ptr<TimeStepper> stepper_;
  std::unique_ptr<Executor> executor_;
  std::unique_ptr<StepRecording> recording_;
};

/// Returns the mean time of a rotor's node in a few steps of the executor serial [s].
double mean_node(const Case& which) {
  Model model(which);
  model.use(ExecutorKind::serial, 1);
  std::vector<Timing> timings =
      measure({{"steps", [&] { model.advance(10); }, {}, 0.1 / kPasses, 0}}, Effort{9, 1e-3, 0.3});
  return timings[0].median / model.graph().node_count();
}

/// Returns the first of rotors with more and more elements per body whose nodes take so long.
Case with_long_nodes(Formulation formulation, int fewest_elements, int more) {
  Case which{{3, 4, fewest_elements}, formulation};
  while (mean_node(which) < kLongNode) which.size.elements += more;
  return which;
}

std::vector<Case> make_cases() {
  return {Case{{3, 4, 4}, Formulation::structured, false},
          with_long_nodes(Formulation::structured, 100, 10),
          with_long_nodes(Formulation::subsystem, 6, 1)};
}

using ModelPointer = std::shared_ptr<Model>;

/// Makes an alternative of one batch; its first part, untimed, wakes sleeping threads. Making room
/// for the records empties caches and lets a thread fall asleep, so it comes before, also with
/// recording off: only recording is to be measured.
Alternative make_alternative(const ModelPointer& model, bool is_recorded, int steps) {
  const auto prepare = [model, is_recorded, steps] {
    const int first = (steps + 3) / 4;
    model->make_room(first + steps, is_recorded);
    model->advance(first);
  };
  return {std::string(model->name()) + (is_recorded ? ", on" : ", off"),
          [model, steps] { model->advance(steps); }, prepare, 1.0 / steps, 0};
}

ModelPointer make_model(const Case& which, ExecutorKind kind, int threads) {
  const auto model = std::make_shared<Model>(which);
  model->use(kind, threads);
  model->settle();
  return model;
}

/// Measures the loop and the executor serial.
std::vector<Timing> measure_off(const Case& which, int steps, const Effort& effort) {
  const auto loop = std::make_shared<Model>(which);
  loop->use_plain_loop();
  const ModelPointer serial = make_model(which, ExecutorKind::serial, 1);
  return measure({make_alternative(loop, false, steps), make_alternative(serial, false, steps)},
                 effort);
}

/// Measures an executor with recording off and on. Both take the same memory and plan.
std::vector<Timing> measure_on(const Case& which, const Recorded& recorded, int steps,
                               const Effort& effort) {
  const ModelPointer model = make_model(which, recorded.kind, recorded.threads);
  return measure({make_alternative(model, false, steps), make_alternative(model, true, steps)},
                 effort);
}

std::string cost(const Timing& timing) { return figure(100.0 * (timing.ratio - 1.0)) + " %"; }

/// Measures the executors of one rotor, and adds its row of the table and its targets.
void measure_rotor(const Case& which, const Effort& effort, Table& table, Report& report) {
  const std::string model = which.size.name() + " " + std::string(name_of(which.formulation));
  const int steps = 40;
  show_progress(model);
  const std::vector<Timing> off = measure_off(which, steps, effort);
  for (const Timing& timing : off) report.add_timing(model, timing);
  report.add_target(
      at_most("tracing off: serial / loop without recorder, " + model, off[1].ratio, 1.02));
  const int nodes = kPasses * Model(which).graph().node_count();
  std::vector<std::string> row{model, graph::duration_text(off[0].median / nodes),
                               graph::duration_text(off[0].median), cost(off[1])};
  for (const Recorded& recorded : kRecorded) {
    if (!graph::has_executor(recorded.kind)) {
      row.emplace_back("-");
      continue;
    }
    const std::vector<Timing> on = measure_on(which, recorded, steps, effort);
    for (const Timing& timing : on) report.add_timing(model, timing);
    row.push_back(cost(on[1]));
    if (which.is_promised)
      report.add_target(at_most(std::string("tracing on / off: ") + recorded.name + ", " + model,
                                on[1].ratio, 1.05));
  }
  table.rows.push_back(std::move(row));
}

}  // namespace

void measure_tracing(const QuestionOptions& options, Report& report) {
  Table table{
      "What tracing costs, of a step of two passes", {"rotor", "mean node", "loop", "off"}, {}};
  for (const Recorded& recorded : kRecorded) table.columns.emplace_back(recorded.column);
  for (const Case& which : make_cases()) measure_rotor(which, effort_of(options), table, report);
  report.add_table(table);
  report.add_remark(
      "  off: the executor serial against a loop without recorder; on: against the same executor, "
      "off");
}

}  // namespace spoke::bench
