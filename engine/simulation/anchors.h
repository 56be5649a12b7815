#pragma once

// Anchors of a model by name, and the motions that the embedding program prescribes.

#include <string>
#include <string_view>
#include <vector>

#include "models/scenario.h"
#include "models/system/loop_model.h"

namespace spoke {

/// Access of a simulation to the anchors of its model, see Simulation::set_anchor_motion(). Throws
/// InputError where there is no such anchor.
class Anchors {
 public:
  /// Keeps references to both, which must outlive this.
  Anchors(const Scenario& scenario, std::vector<AnchorModel>& models)
      : scenario_(scenario), models_(models) {}

  /// Returns the motion of an anchor at time t [s], in the frame in which it moves.
  SaidAnchorMotion motion(std::string_view name, double t) const;
  /// Returns the anchor of that name, whose motion the program prescribes.
  AnchorModel& said(std::string_view name) const;
  /// Returns all anchors whose motion the program prescribes.
  std::vector<const AnchorModel*> said() const;
  /// Throws InputError unless a motion of an anchor that begins with `begin` is finite, is possible
  /// in the world of the model, and goes on from where the anchor is at time t [s].
  void check_continuation(std::string_view name, const SaidAnchorMotion& begin, double t) const;

 private:
  /// Returns its number.
  std::size_t find(std::string_view name) const;
  const std::vector<Anchor>& described() const {
    return scenario_.space ? scenario_.space->anchors : scenario_.rotor.anchors;
  }

  const Scenario& scenario_;
  std::vector<AnchorModel>& models_;
};

/// Returns the motion of an anchor at time t [s], in the frame in which it moves.
SaidAnchorMotion motion_of(const AnchorModel& anchor, double t);

/// Returns the vectors of a motion, at the time since which it holds. Vectors: AnchorMotion, which
/// comes later in the order of rooms.
template <class Vectors>
Vectors vectors_of(const SaidAnchorMotion& motion) {
  Vectors found;
  found.translation = linear(motion.value);
  found.velocity = linear(motion.rate);
  found.acceleration = linear(motion.acceleration);
  found.rotation = angular(motion.value);
  found.rotation_rate = angular(motion.rate);
  found.rotation_acceleration = angular(motion.acceleration);
  return found;
}

/// Returns the motion with such vectors that holds since time t [s].
template <class Vectors>
SaidAnchorMotion motion_since(double t, const Vectors& vectors) {
  return {t, space::make_twist(vectors.translation, vectors.rotation),
          space::make_twist(vectors.velocity, vectors.rotation_rate),
          space::make_twist(vectors.acceleration, vectors.rotation_acceleration)};
}

/// Returns a name like `the anchor "swashplate"`.
std::string describe_anchor(std::string_view name);

}  // namespace spoke
