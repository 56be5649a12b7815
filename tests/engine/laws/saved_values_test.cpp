// The list of the values that saved states hold is whole: what it names is of a state, or shown by
// sensors; what is marked as state it names; and steps from it need nothing else of the table.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/bodies/table/state_values.h"
#include "engine/step/run/time_stepper.h"
#include "graph/executor.h"
#include "models/system/spatial_system.h"
#include "tests/engine/laws/watched_memory.h"
#include "tests/engine/laws/zoo.h"

using namespace spoke;
using namespace spoke::test;

namespace {

constexpr std::int64_t kSavedAt = 5;  ///< step at whose end values are taken

/// Parts, by the end of their names, of which saved states hold values although steps do not go on
/// from them: sensors show them.
constexpr std::array<std::string_view, 3> kShown{"records", "air", "relaxing springs"};
/// Parts marked as state of which they leave something out, besides what the evaluation before the
/// first step finds.
constexpr std::array<std::string_view, 2> kLeftOut{
    "progress",  // follows from the step's number, but for powers and what is remembered
    "first pivots of loops",  // of the start, which a run makes before it takes a saved state
};
/// Parts that are not poisoned, as they have constants or what the start leaves.
constexpr std::array<std::string_view, 3> kKept{"progress", "first pivots of loops", "tension"};

bool is_one_of(std::span<const std::string_view> names, const graph::Part& part) {
  return std::any_of(names.begin(), names.end(), [&part](std::string_view name) {
    return part.name == name || part.name.ends_with(" / " + std::string(name));
  });
}

/// A model some steps from its start.
template <class World>
struct Stepped {
  Stepped(const System<World>& system, Formulation formulation, const Method& method) {
    context.system = system;
    context.formulation = formulation;
    context.integrator = {method, {1e-10, 0, 50}};
    allocate(context);
    graph.emplace(context.build_whole_graph());
    executor = graph::make_executor(*graph, graph::ExecutorKind::serial, 1);
    stepper.emplace(context, *graph);
    REQUIRE(stepper->start() == StepOutcome::done);
    REQUIRE(stepper->advance(kSavedAt, *executor) == StepOutcome::done);
    for (const Range range : context.data.state_memory()) state.insert(range.data());
  }

  /// Whether a part is marked as state.
  bool is_state(const graph::Part& part) const {
    return !part.memory.empty() && state.contains(part.memory.front().data());
  }
  std::vector<double> go_on() {
    stepper->continue_from(kSavedAt);
    REQUIRE(stepper->advance(kSavedAt + 4, *executor) == StepOutcome::done);
    return take_state_values(kSavedAt + 4, context.data);
  }

  SystemContext<World> context;
  std::optional<graph::StepGraph> graph;
  std::unique_ptr<graph::Executor> executor;
  std::optional<TimeStepper> stepper;
  std::set<const std::byte*> state;  ///< first bytes of what is marked
};

/// Returns values of which each differs from what was, also where the table has a whole number; if
/// not `all`, zeros stay: those of padding are saved, too.
std::vector<double> change(std::vector<double> values, bool all) {
  for (double& value : values) {
    if (value == 0.0 && !all) continue;
    const double other = value + 1.0;
    value = other != value ? other : std::nextafter(value, 0.0);
  }
  return values;
}

/// A double of the table, or what is left at the end of a range.
using Word = Range;

/// Lists the words of a part.
std::vector<Word> words_of(const graph::Part& part) {
  std::vector<Word> words;
  for (const Range range : part.memory)
    for (std::size_t k = 0; k < range.size(); k += sizeof(double))
      words.push_back(range.subspan(k, std::min(sizeof(double), range.size() - k)));
  return words;
}

/// The words of a part that putting a state back leaves as they are, by part.
template <class World>
std::vector<std::vector<Word>> find_left(Stepped<World>& model) {
  const std::vector<double> values = take_state_values(kSavedAt, model.context.data);
  std::vector<std::vector<Word>> words;
  std::vector<std::vector<std::byte>> before;
  for (const graph::Part& part : model.graph->parts()) {
    words.push_back(words_of(part));
    std::vector<std::byte>& bytes = before.emplace_back();
    for (const Word word : words.back()) bytes.insert(bytes.end(), word.begin(), word.end());
  }
  model.context.data.put_state(change(values, true), kSavedAt);
  for (std::size_t p = 0; p < words.size(); ++p) {
    const std::byte* at = before[p].data();
    std::erase_if(words[p], [&at](const Word word) {
      const std::byte* const was = at;
      at += word.size();
      return !std::equal(word.begin(), word.end(), was);
    });
  }
  model.context.data.put_state(values, kSavedAt);
  return words;
}

/// Returns the motions of the hub that nothing follows, for which saved states have a place: that
/// of the system where each subsystem has its own, else those of the subsystems.
template <class World>
std::vector<Range> find_idle_hubs(StepData<World>& data) {
  if (!data.is_coupled) return {bytes_in(data.hub)};
  std::vector<Range> hubs;
  for (SubsystemData<World>& subsystem : data.subsystems)
    hubs.push_back(bytes_in(subsystem.prescribed));
  return hubs;
}

/// Returns the memory that putting a state back changes, although it is of no part that is state or
/// shown.
template <class World>
std::vector<std::string> find_foreign(Stepped<World>& model) {
  const std::vector<double> values = take_state_values(kSavedAt, model.context.data);
  std::vector<Range> covered = covered_by(*model.graph, [&model](const graph::Part& part) {
    return model.is_state(part) || is_one_of(kShown, part);
  });
  for (const Range hub : find_idle_hubs(model.context.data)) covered.push_back(hub);
  sort_by_place(covered);
  const std::vector<Watched> watched = watch(model.context);
  std::vector<std::vector<std::byte>> before;
  for (const Watched& at : watched) before.emplace_back(at.memory.begin(), at.memory.end());
  model.context.data.put_state(change(values, false), kSavedAt);
  std::vector<std::string> found;
  for (std::size_t k = 0; k < watched.size(); ++k)
    if (find_outside(watched[k].memory, before[k], covered)) found.push_back(watched[k].name);
  model.context.data.put_state(values, kSavedAt);
  return found;
}

// Add what the evaluation before the first step finds of a body, of all that is marked as state:
// the acceleration of its frame, and the forces of strains of second order at which the step
// begins.

void add_found(BodyData<Plane>& body, std::vector<Range>& memory) {
  memory.push_back(bytes_in(body.X));
  if (body.strain) memory.push_back(graph::bytes_of(body.strain->wrenches));
}
void add_found(BodyData<Space>& body, std::vector<Range>& memory) {
  memory.push_back(bytes_in(body.X));
  if (!body.strain) return;
  memory.push_back(graph::bytes_of(body.strain->wrenches));
  memory.push_back(graph::bytes_of(body.strain->nodal));
}

/// Lists it of all bodies, and of rotors on supports.
template <class World>
std::vector<Range> list_found(StepData<World>& data) {
  std::vector<Range> memory;
  for (SubsystemData<World>& subsystem : data.subsystems)
    for (BodyData<World>& body : subsystem.bodies) add_found(body, memory);
  for (RotorData<World>& rotor : data.rotors) {
    memory.push_back(bytes_in(rotor.acceleration));
    memory.push_back(bytes_in(rotor.turn));
  }
  sort_by_place(memory);
  return memory;
}

/// Returns the parts marked as state that the list of values has not all of.
template <class World>
std::vector<std::string> find_left_out(Stepped<World>& model) {
  const std::vector<Range> found_first = list_found(model.context.data);
  const std::vector<std::vector<Word>> left = find_left(model);
  std::vector<std::string> found;
  for (std::size_t p = 0; p < left.size(); ++p) {
    const graph::Part& part = model.graph->parts()[p];
    if (!model.is_state(part) || is_one_of(kLeftOut, part)) continue;
    if (std::any_of(left[p].begin(), left[p].end(), [&found_first](const Word word) {
          return !is_covered(found_first, word.data());
        }))
      found.push_back(part.name);
  }
  return found;
}

/// Overwrites all that putting a state back leaves as it is.
template <class World>
void poison_left(Stepped<World>& model) {
  const std::vector<std::vector<Word>> left = find_left(model);
  for (std::size_t p = 0; p < left.size(); ++p)
    if (!is_one_of(kKept, model.graph->parts()[p]))
      for (const Word word : left[p])
        std::fill(word.begin(), word.end(), std::byte{0xff});  // not a number
}

template <class World>
void check_saved(const System<World>& system, Formulation formulation, const Method& method) {
  CAPTURE(name_of(formulation));
  CAPTURE(method.index());
  Stepped<World> model(system, formulation, method);
  for (const std::string& memory : find_foreign(model))
    FAIL_CHECK("saved states hold what is of no state, and not shown, of " << memory);
  for (const std::string& part : find_left_out(model))
    FAIL_CHECK("saved states leave something out of " << part);
  const std::vector<double> values = take_state_values(kSavedAt, model.context.data);
  const std::vector<double> expected = model.go_on();
  model.context.data.put_state(values, kSavedAt);
  poison_left(model);
  CHECK(model.go_on() == expected);
}

template <class World>
void check_saved(const System<World>& system, double step) {
  for (const Formulation formulation : quick_formulations(system.deformation_count()))
    check_saved(system, formulation, make_generalized_alpha(0.8, step));
  check_saved(system, Formulation::structured, Rk4{5e-11});
}

}  // namespace

TEST_CASE("saved states of every model hold all that is marked as state, and steps need no more") {
  for (const ZooModel& model : list_zoo()) {
    CAPTURE(model.name);
    on_system(model.read(1), [](const auto& system, double step) { check_saved(system, step); });
  }
}
