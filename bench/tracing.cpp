// What does recording which node ran when cost? Whole steps of rotors whose nodes take about 1 us
// on average, and shorter ones beside them: by an executor that has no recorder to ask for, by the
// same loop switched off, and switched on. Graphs of artificial nodes say less here: a time stamp
// keeps the processor from beginning a node before the one before it is through, which such nodes,
// each a chain of operations that needs nothing from the others, lose a tenth by.

#include <array>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bench/interleaved.h"
#include "bench/paper_rotor.h"
#include "bench/progress.h"
#include "bench/questions.h"
#include "engine/step_graph_builder.h"
#include "engine/step_recording.h"
#include "graph/executor.h"

namespace spoke::bench {
namespace {

using graph::Executor;
using graph::ExecutorKind;
using graph::NodeId;
using graph::StepGraph;

constexpr int kPasses = 2;  // of a step, for every alternative alike

struct Case {
  RotorSize size;
  Formulation formulation = Formulation::structured;
  bool is_promised = true;  // nodes are long enough
};
const std::array kCases{Case{{3, 4, 4}, Formulation::structured, false},
                        Case{{3, 4, 160}, Formulation::structured},
                        Case{{3, 4, 8}, Formulation::subsystem}};

/// An executor that is recorded.
struct Recorded {
  ExecutorKind kind;
  int threads;
  const char* column;
  const char* name;
};
const std::array kRecorded{
    Recorded{ExecutorKind::serial, 1, "serial on", "serial"},
    Recorded{ExecutorKind::flow_graph, 1, "flow 1 on", "flow_graph on 1 thread"},
    Recorded{ExecutorKind::flow_graph, 2, "flow 2 on", "flow_graph on 2 threads"},
    Recorded{ExecutorKind::automatic, 2, "auto 2 on", "auto on 2 threads"}};

Effort effort_of(const QuestionOptions& options) {
  return options.quick ? Effort{5, 1e-3, 0.3} : Effort{201, 2e-3, 4.0};
}

/// What the executor serial was before it could record.
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

/// A rotor that is stepped on, in batches.
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
  /// No step will be recorded from now on.
  void stop_recording() {
    stepper_->watch_runs(nullptr);
    executor_->set_recorder(nullptr);
    recording_.reset();
  }
  /// The next `steps` steps will be recorded.
  void record(int steps) {
    constexpr std::size_t most_bytes = std::size_t{256} << 20;
    recording_ = std::make_unique<StepRecording>(
        *graph_, context_.data,
        RecordingPlan{stepper_->steps() + 1, stepper_->steps() + steps, kPasses,
                      executor_->threads().total(), most_bytes});
    executor_->set_recorder(&recording_->recorder());
    stepper_->watch_runs(recording_.get());
  }

 private:
  StepContext context_;
  std::unique_ptr<StepGraph> graph_;
  std::unique_ptr<TimeStepper> stepper_;
  std::unique_ptr<Executor> executor_;
  std::unique_ptr<StepRecording> recording_;
};

using ModelPointer = std::shared_ptr<Model>;

/// A batch; the first part of it, untimed, wakes what slept. Making room for the records takes long
/// enough for a thread to fall asleep, so that comes before.
Alternative make_alternative(const ModelPointer& model, bool is_recorded, int steps,
                             int reference) {
  const auto prepare = [model, is_recorded, steps] {
    const int first = (steps + 3) / 4;
    model->stop_recording();
    if (is_recorded) model->record(first + steps);
    model->advance(first);
  };
  return {std::string(model->name()) + (is_recorded ? ", on" : ", off"),
          [model, steps] { model->advance(steps); }, prepare, 1.0 / steps, reference};
}

ModelPointer make_model(const Case& which, ExecutorKind kind, int threads) {
  const auto model = std::make_shared<Model>(which);
  model->use(kind, threads);
  model->settle();
  return model;
}

/// The loop, then each executor switched off and on. Both take the same memory and plan.
std::vector<Alternative> make_alternatives(const Case& which, int steps) {
  const auto loop = std::make_shared<Model>(which);
  loop->use_plain_loop();
  std::vector<Alternative> alternatives{make_alternative(loop, false, steps, 0)};
  for (const Recorded& recorded : kRecorded) {
    const auto off = static_cast<int>(alternatives.size());
    const ModelPointer model = make_model(which, recorded.kind, recorded.threads);
    alternatives.push_back(make_alternative(model, false, steps, off == 1 ? 0 : off));
    alternatives.push_back(make_alternative(model, true, steps, off));
  }
  return alternatives;
}

std::string cost(const Timing& timing) { return figure(100.0 * (timing.ratio - 1.0)) + " %"; }

void add_targets(const std::string& model, const Case& which, const std::vector<Timing>& timings,
                 Report& report) {
  report.add_target(
      at_most("tracing off: serial / loop without recorder, " + model, timings[1].ratio, 1.02));
  if (!which.is_promised) return;
  for (std::size_t k = 0; k < kRecorded.size(); ++k)
    report.add_target(at_most(std::string("tracing on / off: ") + kRecorded[k].name + ", " + model,
                              timings[2 + 2 * k].ratio, 1.05));
}

}  // namespace

void measure_tracing(const QuestionOptions& options, Report& report) {
  Table table{
      "What tracing costs, of a step of two passes", {"rotor", "mean node", "loop", "off"}, {}};
  for (const Recorded& recorded : kRecorded) table.columns.emplace_back(recorded.column);
  for (const Case& which : kCases) {
    const std::string model = which.size.name() + " " + std::string(name_of(which.formulation));
    show_progress(model);
    const int nodes = kPasses * Model(which).graph().node_count();
    const int steps = 40;
    const std::vector<Timing> timings =
        measure(make_alternatives(which, steps), effort_of(options));
    for (const Timing& timing : timings) report.add_timing(model, timing);
    std::vector<std::string> row{model, duration(timings[0].median / nodes),
                                 duration(timings[0].median), cost(timings[1])};
    for (std::size_t k = 0; k < kRecorded.size(); ++k) row.push_back(cost(timings[2 + 2 * k]));
    table.rows.push_back(std::move(row));
    add_targets(model, which, timings, report);
  }
  report.add_table(table);
  report.add_remark(
      "  off: the executor serial against a loop without recorder; on: against the same executor, "
      "off");
}

}  // namespace spoke::bench
