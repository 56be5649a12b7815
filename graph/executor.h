#pragma once

// The interface of all executors, and the function that makes one.

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "graph/step_graph.h"
#include "spoke/export.h"

namespace spoke::graph {

class NodeRecorder;

/// The number of threads of an executor, the calling one included. Executors with nested teams give
/// each of `outer` threads a team of `inner`; all others know one layer only.
struct Threads {
  int outer = 0;  ///< number of threads or teams; 0: as many as are available
  int inner = 1;  ///< threads of each team

  /// Asks for as many threads as are available.
  Threads() = default;
  /// Asks for so many threads, or teams of so many.
  Threads(int outer_threads, int inner_threads = 1) : outer(outer_threads), inner(inner_threads) {}
  /// Returns the threads of all teams together.
  int total() const { return outer * inner; }
  /// Whether both layers are equal.
  friend bool operator==(const Threads&, const Threads&) = default;
};
/// The largest number of threads of an executor, all teams together.
constexpr int kMostThreads = 1024;
/// Returns "2", or "3x2" for nested teams.
SPOKE_EXPORT std::string name_of(const Threads& threads);

/// Runs the nodes of one graph, each after its predecessors, any number of times.
///
/// A program may derive an executor of its own, and hand it to a simulation by
/// SimulationOptions::make_executor. It overrides run(), name() and threads(), and keeps to this:
/// - run() runs each node of the graph once, by run_on_thread(), after all nodes of
///   StepGraph::predecessors() have returned; what they wrote must be visible to it (a mutex, an
///   atomic with release and acquire, or the same thread make it so). Nodes of which neither leads
///   to the other may run at once, on any threads and in any order.
/// - When run() returns, all nodes have returned, and what they wrote is visible to the caller.
/// - run() throws nothing. It is called again and again, always by one thread at a time.
/// - No node runs outside of run() or run_while(). The destructor ends the executor's threads.
///
/// Then the results have the bits of the executor `serial`; state_hash() shows it.
class SPOKE_EXPORT Executor {
 public:
  Executor() = default;
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;
  virtual ~Executor() = default;

  /// Runs every node once and returns when all are done. One call at a time per executor.
  virtual void run() = 0;
  /// Runs the graph and then asks `more`, on the calling thread while no node runs, again and again
  /// until it returns false. An executor may keep its threads together meanwhile.
  virtual void run_while(const std::function<bool()>& more);
  /// Returns the executor's kind, for reports, as by name_of(ExecutorKind).
  virtual std::string_view name() const = 0;
  /// Returns the threads that were asked for.
  virtual Threads threads() const = 0;
  /// Returns one line about how the graph is run, for reports; an executor that chooses says what
  /// it chose and why. It may allocate, and must not be called during a run.
  virtual std::string describe() const;
  /// Returns whether it tries alternatives at present, so that the time of a run means little.
  virtual bool tuning() const { return false; }
  /// Returns how many times it has chosen among alternatives.
  virtual int choices() const { return 0; }
  /// Returns the threads of a run that is recorded: fewer than threads() if no more have processors
  /// or find work, or if the executor has chosen fewer, or has not chosen yet.
  virtual Threads recorded_threads() const { return threads(); }
  /// Returns whether it has found, for good, that a loop on the calling thread is fastest.
  virtual bool settled_on_serial() const { return false; }

  /// Records, from the next run on, which node runs on which thread when; nullptr ends that. It
  /// must not be called during a run. The recorder must have threads().total() threads and know the
  /// graph's number of nodes. Every executor of make_executor() records; one that chooses puts off
  /// choosing meanwhile, and runs on the calling thread alone until it has chosen.
  virtual void set_recorder(NodeRecorder* recorder) { recorder_ = recorder; }

 protected:
  /// Runs nodes of `graph` one after the other as thread `thread` of this executor, from 0, the
  /// calling one, to threads().total() - 1; records them if a trace is made. An executor of a
  /// program's own runs all of its nodes by this. Different threads may call it at once.
  void run_on_thread(int thread, const StepGraph& graph,
                     std::span<const NodeId> nodes) const noexcept;
  /// Returns the recorder, or nullptr.
  NodeRecorder* recorder() const { return recorder_; }

 private:
  NodeRecorder* recorder_ = nullptr;
};

/// Makes an executor of a program's own for a graph that outlives it and stays in place.
using ExecutorFactory = std::function<std::unique_ptr<Executor>(const StepGraph& graph)>;

/// The kind of an executor.
enum class ExecutorKind {
  /// Measures the nodes on the first runs, then goes parallel by the plan that a simulated run
  /// predicts to be fastest, if a probe shows that the machine has other processors at present and
  /// the plan promises at least 5 %, or more where runs are as short as some handovers between
  /// threads. Later runs try other plans; one that turns out slower than serial runs is left, and
  /// tried again later. All of that may cost 2 % of the time of the runs. It uses at most
  /// the available threads, and with one thread is serial from the start.
  automatic,
  /// A oneTBB flow graph in an arena of its own. Like oneTBB, it lets no more threads work than
  /// there are processors, unless the program raises that limit by an
  /// oneapi::tbb::global_control.
  flow_graph,
  serial,  ///< a loop on the calling thread; `threads` is ignored
  /// Nested OpenMP teams that last for all passes of run_while(); no more threads than processors.
  openmp_scheme1,
  openmp_scheme2,  ///< nested OpenMP teams that begin and end with every loop of a pass
  openmp_levels,   ///< an OpenMP loop for each level of the graph
  openmp_tasks,    ///< every node an OpenMP task that depends on its predecessors
};

/// Returns all kinds of this build. Without OpenMP it has no kinds "openmp_...".
SPOKE_EXPORT std::span<const ExecutorKind> executor_kinds();
/// Returns whether this build has the kind.
SPOKE_EXPORT bool has_executor(ExecutorKind kind);
/// Returns the name of a kind: "auto", "flow_graph", "serial" and so on.
SPOKE_EXPORT std::string_view name_of(ExecutorKind kind);
/// Returns whether OpenMP runs the threads of this kind.
SPOKE_EXPORT bool is_openmp(ExecutorKind kind);
/// Returns whether this kind has two layers of threads.
SPOKE_EXPORT bool has_nested_teams(ExecutorKind kind);
/// Returns the kind of this name. Throws InputError, with the names to choose from, if there is
/// none or this build is without it.
SPOKE_EXPORT ExecutorKind executor_kind(std::string_view name);
/// Throws InputError if a number of threads is negative, above kMostThreads in all, or of nested
/// teams that this kind does not have.
SPOKE_EXPORT void check_threads(ExecutorKind kind, const Threads& threads);

/// Throws InputError if OpenMP would give an executor of this kind fewer threads, because its
/// environment limits them (OMP_THREAD_LIMIT).
SPOKE_EXPORT void check_thread_limit(ExecutorKind kind, const Threads& threads);

/// Makes an executor with `threads` threads (0 = available_threads()). It refers to `graph`, which
/// must outlive it and stay in place. Throws InputError if this build is without the kind, where
/// check_threads() does, and if the system refuses so many threads.
SPOKE_EXPORT std::unique_ptr<Executor> make_executor(const StepGraph& graph, ExecutorKind kind,
                                                     Threads threads = {});

/// Returns how many threads of this process can run at once: the processors of the calling thread's
/// affinity mask, at most the processor quota of its control groups (rounded up). The result is at
/// least 1 and at most kMostThreads. If OpenMP binds threads (OMP_PROC_BIND, OMP_PLACES and the
/// like), and so the initial one, the mask of the process before that counts.
SPOKE_EXPORT int available_threads();

}  // namespace spoke::graph
