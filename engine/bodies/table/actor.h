#pragma once

// What acts on the bodies of a system besides gravity, the scenario's loads and the joints: an
// actor. The table has a list of them (StepData::actors); the step graph, saved states, states at
// rest and sensors go through it and ask for none by its name. Each actor has a folder of
// engine/bodies/act/.
//
// An actor is placed on a table that is allocated: it takes memory from the arenas of the
// subsystems, declares its parts (parts.h), lists its wrenches with the bodies that they act on
// (BodyData::applied), its delayed states with the subsystem (add_states()), and what else saved
// states must hold (SubsystemData::saved). In a step its nodes run; its other functions are called
// between steps or while a graph is built, but for keep_values() and read(), which the node
// "sensors" calls.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/bodies/table/pass_nodes.h"
#include "engine/bodies/table/stage.h"
#include "engine/bodies/table/state_pair.h"
#include "models/world.h"

namespace spoke {

template <class World>
struct Reading;

/// Places among the columns of a model in space where those of actors stand.
enum class ColumnPlace {
  behind_joints,  ///< behind the joints and loads of the roots
  last,           ///< behind all but the sensors of the scenario's
};

/// A column of sensors.csv.
struct ActorColumn {
  std::string name;
  std::string unit;
};

/// Places in a pass where actors add nodes.
enum class PassPlace {
  before_motion,  ///< before all that moves: sets courses, which the joints follow
  on_motion,      ///< behind the velocities, before the terms of the bodies: sets wrenches
};

template <class World>
class Actor {
 public:
  virtual ~Actor() = default;

  /// Returns the stage of its nodes.
  virtual Stage stage() const = 0;
  /// Adds its nodes for subsystem `i` at a place of the pass, if it has any there.
  virtual void add_nodes(const PassNodes& pass, PassPlace place, int i) const = 0;
  /// Adds the parts by which it acts on body `j` of subsystem `i`: the body's terms read them.
  virtual void list_parts_on(int /*i*/, int /*j*/, PartList&) const {}
  /// Adds the parts that prescribed joints of subsystem `i` follow.
  virtual void list_courses(int /*i*/, PartList&) const {}
  /// Adds the parts from which keep_values() and read() show values of subsystem `i`.
  virtual void list_shown(int /*i*/, PartList&) const {}

  /// Sets the states that it reaches on subsystem `i` a time `elapsed` [s] behind those that are
  /// kept, at the motion in the table.
  virtual void advance(std::size_t /*i*/, double /*elapsed*/) noexcept {}
  /// Adds those of its states of subsystem `i` that linear models of small motions have, too: the
  /// others they hold.
  virtual void list_relaxing(std::size_t /*i*/, std::vector<RelaxingState>&) const {}

  // What the sensors of a model in space show of it. Subsystems may be at different steps: each
  // keeps its values of a step in its ring, and columns are made of these when all are there.
  /// Counts the values of subsystem `i` that are kept in each step.
  virtual std::size_t count_values(std::size_t /*i*/) const { return 0; }
  /// Writes these at the end of a step at time `t` [s], by its last evaluation.
  virtual void keep_values(std::size_t /*i*/, double /*t*/, double* /*into*/) const noexcept {}
  /// Returns its columns at a place.
  virtual std::vector<ActorColumn> columns(ColumnPlace) const { return {}; }
  /// Adds the values of these columns at the end of step `step`, whose records are in the table.
  /// `kept`: by subsystem, the values kept in that step.
  virtual void append_values(ColumnPlace, std::int64_t /*step*/,
                             std::span<const double* const> /*kept*/,
                             std::vector<double>& /*values*/) const {}
  /// Returns the value of a sensor of the scenario's, by its last evaluation; none: the quantity is
  /// no one of this actor's.
  virtual std::optional<TwistOf<World>> read(std::size_t /*i*/,
                                             const Reading<World>&) const noexcept {
    return std::nullopt;
  }

  // Actors that call code of the user's, which may fail; a failure ends the step.
  virtual bool calls_user() const { return false; }
  /// Whether a call has failed since clear_failures().
  virtual bool has_failed() const { return false; }
  virtual void clear_failures() {}
};

}  // namespace spoke
