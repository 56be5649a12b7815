#pragma once

// What the formulation `structured` (engine/step/formulation/structured.h) does with one body by
// itself: it condenses it to the multi-port of its handles, and recovers its accelerations.

#include "engine/bodies/table/body_kind.h"
#include "engine/bodies/table/step_data.h"
#include "engine/bodies/tree/joint_recovery.h"

namespace spoke::structured {

/// Memory of the formulation per body besides BodyData.
template <class World>
struct BodyWork : BodyTypes<World>::Condensed {
  tree::JointElimination<World> joint;        ///< inboard joint; unused for roots
  tree::Branch<World> branch;                 ///< the body with all that it carries
  bool by_mass = false;                       ///< see SubsystemWork
  TwistOf<World> X = TwistOf<World>::Zero();  ///< acceleration of the frame, if by_mass
};

/// Solves for W_theta and z and condenses a body to its multi-port; `twist`: of its frame. In space
/// as its kind does.
void condense_body(const BodyData<Plane>& data, const Twist& twist, bool implicit,
                   BodyWork<Plane>& work) noexcept;
inline void condense_body(BodyData<Space>& data, const space::Twist& twist, bool implicit,
                          const BodyWork<Space>& work) noexcept {
  data.kind->condense(twist, implicit, work, data);
}
/// Return the parts that it depends on: of a solid in several slices their half solutions, of which
/// one in one slice makes its own.
inline PartList parts_of_condensed(std::size_t j, const SubsystemData<Plane>& data) {
  const BodyParts& parts = data.parts.bodies[j];
  PartList list{parts.coordinates, data.parts.twists, parts.terms};
  graph::add_to(list, graph::maybe(parts.tension));
  return list;
}
inline PartList parts_of_condensed(std::size_t j, const SubsystemData<Space>& data) {
  const BodyParts& parts = data.parts.bodies[j];
  const BodyData<Space>& body = data.bodies[j];
  PartList list{parts.coordinates, data.parts.twists, parts.terms};
  graph::add_to(list, data.parts.rotations, graph::maybe(parts.tension),
                graph::maybe(parts.carried), body.kind->slices(body) ? parts.halves : parts.tiles);
  return list;
}

/// Calculates the accelerations of a body (P 7): X into `data.X`, qf'' into the flex vector `a`.
void recover_body(const SubsystemData<Plane>& subsystem, std::size_t j, const BodyWork<Plane>& work,
                  bool implicit, BodyData<Plane>& data, double* a) noexcept;
inline void recover_body(const SubsystemData<Space>&, std::size_t, const BodyWork<Space>& work,
                         bool implicit, BodyData<Space>& data, double* a) noexcept {
  data.kind->recover(work, implicit, data, a);
}
/// Return the parts that they depend on: of a solid in one slice its half solutions, too.
inline PartList parts_of_recovered(std::size_t j, const SubsystemData<Plane>& data) {
  const BodyParts& parts = data.parts.bodies[j];
  PartList list{data.parts.wrenches, parts.inverse};
  graph::add_to(list, graph::maybe(parts.tension));
  return list;
}
inline PartList parts_of_recovered(std::size_t j, const SubsystemData<Space>& data) {
  const BodyParts& parts = data.parts.bodies[j];
  PartList list{data.parts.wrenches, data.parts.rotations, parts.inverse, parts.terms,
                parts.scratch};
  graph::add_to(list, graph::maybe(parts.tension), graph::maybe(parts.carried), parts.halves);
  return list;
}

}  // namespace spoke::structured
