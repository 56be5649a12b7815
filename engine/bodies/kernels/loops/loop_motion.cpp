// Goes through the loops of a subsystem, row by row.

#include "engine/bodies/kernels/loops/loop_motion.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "engine/bodies/kernels/kinematics.h"
#include "engine/bodies/kernels/loops/bearing_force.h"
#include "engine/bodies/kernels/samples.h"
#include "engine/bodies/tree/multi_port.h"

namespace spoke {
namespace {

Twist to_world(const space::Twist& twist, const Plane&) { return {twist[0], twist[1], twist[5]}; }
const space::Twist& to_world(const space::Twist& twist, const Space&) { return twist; }

/// A place with what its rows need: its motion, and what carries it.
struct Place {
  PlaceMotion motion;
  LoopHandle handle;     ///< if a body carries it
  CarriedPlace carried;  ///< else, or if an anchor moves it against that body
};

template <class World>
Place find_place(const System<World>& system, const LoopPlaceModel& model, double t,
                 const SubsystemData<World>& data) {
  Place place;
  if (model.carrier != LoopPlace::Carrier::body) {
    place.carried = calc_carried_place(system, *data.hub, data.axle, model, t);
    place.motion = place.carried.motion;
    return place;
  }
  place.handle = calc_loop_handle(data, model.body, model.handle);
  if (model.is_moved()) {
    const AnchorModel& anchor = system.anchors[static_cast<std::size_t>(model.anchor)];
    place.carried =
        calc_moved_place(anchor, model, {place.handle.p, place.handle.R}, place.handle.twist, t);
    place.motion = place.carried.motion;
    return place;
  }
  const space::Position r = place.handle.R * model.offset.p;
  place.motion.p = place.handle.p + r;
  place.motion.R = place.handle.R * model.offset.R;
  place.motion.twist = place.handle.twist;
  linear(place.motion.twist) += cross(angular(place.handle.twist), r);
  return place;
}

/// Returns where the frame H of the hub that carries subsystem `i` is in that of the base. The
/// poses of the loops must be set.
space::Pose pose_of_hub(const System<Plane>&, std::size_t, const StepData<Plane>&) { return {}; }
space::Pose pose_of_hub(const System<Space>& system, std::size_t i, const StepData<Space>& data) {
  const int rotor = system.subsystems[i].rotor;
  if (rotor < 0) return {};
  const SupportedRotor& carried = system.rotors[static_cast<std::size_t>(rotor)];
  const auto carrier = static_cast<std::size_t>(carried.subsystem);
  const space::Pose& pose =
      data.subsystems[carrier].loops.poses[static_cast<std::size_t>(carried.body)];
  if (system.subsystems[carrier].rotor < 0) return pose;
  const space::Pose outer = pose_of_hub(system, carrier, data);
  return {outer.p + outer.R * pose.p, outer.R * pose.R};
}

/// The places of a loop between subsystems, both in H of its own.
struct SharedPlaces {
  Place from, to;
  space::Rotation to_own;  ///< from H of the other one
};

template <class World>
SharedPlaces find_places(const System<World>& system, const SharedLoop& loop, double t,
                         const StepData<World>& data) {
  const LoopAt& at_end = loop.ends.front();
  const auto own = static_cast<std::size_t>(loop.own.subsystem);
  const auto end = static_cast<std::size_t>(at_end.subsystem);
  const auto place_of = [&](std::size_t i, int k) {
    return find_place(system, system.subsystems[i].loops[static_cast<std::size_t>(k)].from, t,
                      data.subsystems[i]);
  };
  SharedPlaces places{place_of(own, loop.own.loop), place_of(end, at_end.loop), {}};
  if (system.subsystems[own].rotor == system.subsystems[end].rotor) return places;
  const space::Pose here = pose_of_hub(system, own, data), there = pose_of_hub(system, end, data);
  const space::Rotation R = here.R.inverse() * there.R;
  const space::Position p = here.R.inverse() * space::Position(there.p - here.p);
  Place& to = places.to;
  to.motion = {p + R * to.motion.p, R * to.motion.R, R * to.motion.twist};
  to.handle = {p + R * to.handle.p, R * to.handle.R, R * to.handle.twist};
  to.carried.acceleration = R * to.carried.acceleration;
  to.carried.own = R * to.carried.own;
  places.to_own = R;
  return places;
}

/// Returns the acceleration of a place against its handle, as it turns with the section.
space::Position centripetal_of(const Place& place) {
  const space::Angular w = angular(place.handle.twist);
  return cross(w, cross(w, space::Position(place.motion.p - place.handle.p)));
}

/// Returns the part of the acceleration of a row that a place `to` on a body has besides that of
/// its handle, for the unit force at p.
double known_of_body(bool is_moved, const space::Twist& unit, const space::Position& p,
                     const Place& to) {
  if (!is_moved) return -linear(unit).dot(centripetal_of(to));
  return -translate(space::Position(p - to.motion.p), unit).dot(to.carried.acceleration);
}

/// Sets the wrenches of a row's unit force on bodies and hub. Returns the part of the row's
/// relative acceleration that is known, since what carries `to` is prescribed.
template <class World>
double set_unit_force(const LoopModel& loop, const space::Twist& unit, const Place& from,
                      const Place& to, const SubsystemData<World>& data,
                      LoopRowState<World>& state) {
  const space::Position& p = from.motion.p;
  state.from =
      turn_to_body(data, loop.from.body, translate(space::Position(p - from.handle.p), unit));
  state.to.setZero();
  state.hub.setZero();
  state.given_rate = 0.0;
  const double of_from = linear(unit).dot(centripetal_of(from));
  if (loop.to.carrier == LoopPlace::Carrier::body) {
    state.to = -turn_to_body(data, loop.to.body, translate(space::Position(p - to.handle.p), unit));
    if (loop.to.is_moved())
      state.given_rate = -translate(space::Position(p - to.motion.p), unit).dot(to.carried.own);
    return of_from + known_of_body(loop.to.is_moved(), unit, p, to);
  }
  const space::Twist on_place = -translate(space::Position(p - to.motion.p), unit);
  double known = of_from + on_place.dot(to.carried.acceleration);
  if (to.carried.is_on_hub) {
    state.hub = to_world(-translate(p, unit), World{});
  } else if (!to.carried.pivot.isZero(0.0)) {
    const space::Twist about_pivot = -translate(space::Position(p - to.carried.pivot_place), unit);
    state.hub[World::kAxial] = to.carried.pivot.dot(angular(about_pivot));
    known -= state.hub[World::kAxial] * to.carried.mount_spin_up;
  }
  state.given_rate = on_place.dot(to.motion.twist) - state.hub.dot(data.hub->twist);
  return known;
}

/// Sets what the row's springs or its closure ask for. `known`: see set_unit_force(); `kinematic`:
/// the relative acceleration of bodies and hub by the last iterate.
template <class World>
void set_target(const LoopRow& row, LoopRowUse use, const RowMotion& motion,
                const ClosureGains& gains, double known, double kinematic,
                LoopRowState<World>& state) {
  state.opening = motion.opening;
  state.rate = motion.rate;
  state.compliance = state.shared_compliance = state.force = state.loss = 0.0;
  const bool is_implicit = gains.position > 0.0;
  if (row.is_of_bearing) {  // the rest is set_bearing()'s
    state.target = is_implicit ? kinematic : 0.0;
    return;
  }
  if (use == LoopRowUse::sprung) {
    const double force = -row.stiffness * motion.opening - row.damping * motion.rate;
    if (!is_implicit) {
      state.force = force;
      state.target = 0.0;
      return;
    }
    state.compliance = 1.0 / (gains.position * row.stiffness + gains.velocity * row.damping);
    state.target = kinematic + state.compliance * force;
    return;
  }
  state.target =
      is_implicit && !gains.stays
          ? kinematic - motion.opening / gains.position
          : -motion.convective - known - gains.opening * motion.opening - gains.rate * motion.rate;
}

/// Accelerations by the last iterate, of the handles in their bodies' frames; zero where no body
/// carries the place, and in explicit passes.
template <class World>
struct LoopAccelerations {
  TwistOf<World> from = TwistOf<World>::Zero(), to = from, hub = from;
};

template <class World>
void calc_row(const Subsystem<World>& subsystem, std::size_t loop, int row, const Place& from,
              const Place& to, const ClosureGains& gains, const LoopAccelerations<World>& last,
              SubsystemData<World>& data) {
  const LoopModel& model = subsystem.loops[loop];
  LoopData<World>& loops = data.loops;
  const LoopRow& constants = model.rows[static_cast<std::size_t>(row)];
  const auto at = static_cast<std::size_t>(loops.paths[loop].first_row + row);
  LoopRowState<World>& state = loops.states[at];
  const RowMotion motion = calc_loop_row(constants, from.motion, to.motion);
  const double known = set_unit_force(model, motion.unit, from, to, data, state);
  const double kinematic =
      state.from.dot(last.from) + state.hub.dot(last.hub) + state.to.dot(last.to);
  set_target(constants, loops.use[at], motion, gains, known, kinematic, state);
}

/// Sets the forces of a bearing's matrices, or what they ask for, behind its two rows.
template <class World>
void set_bearing(const BearingModel& bearing, const Place& from, const Place& to,
                 const ClosureGains& gains, LoopRowState<World>* rows) {
  const BearingForce found = calc_bearing_force(
      bearing, {rows[0].opening, rows[1].opening}, {rows[0].rate, rows[1].rate},
      calc_bearing_speed(bearing, from.motion, to.motion), gains.position, gains.velocity);
  const bool is_implicit = gains.position > 0.0;
  const Eigen::Vector2d asked = found.compliance * found.force;
  for (int r = 0; r < 2; ++r) {
    rows[r].loss = found.loss[r];
    if (!is_implicit) {
      rows[r].force = found.force[r];
      continue;
    }
    rows[r].compliance = found.compliance(r, r);
    rows[r].target += asked[r];
  }
  if (is_implicit) rows[0].shared_compliance = found.compliance(1, 0);
}

// Couplings of joints, of which the plane has none.

/// The sum c q over coordinates of a coupling.
struct CoupledMotion {
  RowMotion row{space::Twist::Zero(), 0.0, 0.0, 0.0};
  double given_rate = 0.0;  ///< of driven coordinates
  double known = 0.0;       ///< accelerations of these
  double kinematic = 0.0;   ///< of free ones by the last iterate
};

void add_coordinates(const LoopModel&, const ClosureGains&, const SubsystemData<Plane>&,
                     CoupledMotion&) {}
void add_coordinates(const LoopModel& coupling, const ClosureGains& gains,
                     const SubsystemData<Space>& data, CoupledMotion& sum) {
  sum.row.opening -= coupling.rows[0].rest;
  for (const CoupledCoordinate& at : coupling.coupled) {
    const BodyData<Space>& body = data.bodies[static_cast<std::size_t>(at.body)];
    if (at.is_driven) {
      const space::PrescribedMotion& driven = body.joint.driven[at.component];
      sum.row.opening += at.ratio * driven.value;
      sum.given_rate += at.ratio * driven.rate;
      sum.known += at.ratio * driven.acceleration;
      continue;
    }
    const CoordinateBlock& coordinates = body.joint.coordinates;
    sum.row.opening += at.ratio * coordinates.q[at.component];
    sum.row.rate += at.ratio * coordinates.v[at.component];
    if (gains.position > 0.0) sum.kinematic += at.ratio * coordinates.a[at.component];
  }
}

/// Lets the row of a coupling ask for the relative acceleration sum c q'' of free coordinates.
template <class World>
void set_coupling(const LoopModel& coupling, std::size_t row, const ClosureGains& gains,
                  CoupledMotion sum, SubsystemData<World>& data) {
  LoopRowState<World>& state = data.loops.states[row];
  state.from.setZero();
  state.to.setZero();
  state.hub.setZero();
  state.given_rate = sum.given_rate;
  sum.row.rate += sum.given_rate;
  set_target(coupling.rows[0], data.loops.use[row], sum.row, gains, sum.known, sum.kinematic,
             state);
}

}  // namespace

template <class World>
PlaceMotion calc_place_motion(const System<World>& system, std::size_t i,
                              const LoopPlaceModel& place, double t, const StepData<World>& data) {
  assert(i < data.subsystems.size());
  return find_place(system, place, t, data.subsystems[i]).motion;
}

template <class World>
LoopPlaces calc_place_motions(const System<World>& system, std::size_t i, const LoopModel& loop,
                              double t, const StepData<World>& data) {
  assert(!loop.is_share);
  if (!loop.is_shared())
    return {calc_place_motion(system, i, loop.from, t, data),
            calc_place_motion(system, i, loop.to, t, data)};
  const SharedPlaces places =
      find_places(system, system.shared_loops[static_cast<std::size_t>(loop.shared)], t, data);
  return {places.from.motion, places.to.motion};
}

template <class World>
void calc_loop_motion(const System<World>& system, std::size_t i, double t,
                      const ClosureGains& gains, StepData<World>& table) noexcept {
  assert(i < table.subsystems.size());
  const Subsystem<World>& subsystem = system.subsystems[i];
  SubsystemData<World>& data = table.subsystems[i];
  calc_poses(subsystem, data, data.loops.poses);
  const bool is_implicit = gains.position > 0.0;
  LoopAccelerations<World> last;
  if (is_implicit) {
    last.hub = calc_loop_hub_acceleration(system, i, t, table);
    calc_loop_accelerations(subsystem, last.hub, data);
  }
  for (std::size_t k = 0; k < subsystem.loops.size(); ++k) {
    const LoopModel& loop = subsystem.loops[k];
    if (loop.is_shared()) continue;  // see calc_shared_motion()
    if (loop.is_coupling()) {
      CoupledMotion sum;
      add_coordinates(loop, gains, data, sum);
      set_coupling(loop, static_cast<std::size_t>(data.loops.paths[k].first_row), gains, sum, data);
      continue;
    }
    const Place from = find_place(system, loop.from, t, data);
    const Place to = find_place(system, loop.to, t, data);
    if (is_implicit) {
      last.from = calc_loop_acceleration(data, loop.from.body, loop.from.handle);
      last.to.setZero();
      if (loop.to.carrier == LoopPlace::Carrier::body)
        last.to = calc_loop_acceleration(data, loop.to.body, loop.to.handle);
    }
    for (int row = 0; row < static_cast<int>(loop.rows.size()); ++row)
      calc_row(subsystem, k, row, from, to, gains, last, data);
    if (loop.bearing)
      set_bearing(*loop.bearing, from, to, gains,
                  &data.loops.states[data.loops.paths[k].first_row]);
  }
}

template <class World>
PartList parts_of_loop_motion(std::size_t i, bool has_implicit, const StepData<World>& data) {
  const SubsystemData<World>& subsystem = data.subsystems[i];
  const SubsystemParts& own = subsystem.parts;
  PartList list{own.rotations, own.twists, own.hub_state};
  for (std::size_t j = 0; std::cmp_less_equal(j, subsystem.loops.last_body); ++j) {
    // In space the handles' motions are with the rotations.
    if constexpr (!tree::kHasJointCoordinates<World>) list.push_back(own.bodies[j].coordinates);
    if (has_implicit) list.push_back(own.bodies[j].accelerations);
  }
  for (const int j : subsystem.loops.coupled)
    list.push_back(own.bodies[static_cast<std::size_t>(j)].coordinates);
  if (has_implicit && data.is_coupled) list.push_back(data.parts.hub_coordinates);
  return list;
}

namespace {

/// Sets a row of a share to one that only has a unit force.
template <class World>
void clear_share(LoopRowState<World>& row) {
  row.to.setZero();
  row.hub.setZero();
  row.opening = row.rate = row.given_rate = row.target = row.compliance = row.force = 0.0;
  row.shared_compliance = row.loss = 0.0;
}

template <class World>
const LoopModel& model_of(const System<World>& system, const LoopAt& at) {
  return system.subsystems[static_cast<std::size_t>(at.subsystem)]
      .loops[static_cast<std::size_t>(at.loop)];
}

/// Returns the row of a loop, or of a share, that is its first.
template <class World>
std::size_t first_row_of(const LoopAt& at, const StepData<World>& table) {
  return static_cast<std::size_t>(table.subsystems[static_cast<std::size_t>(at.subsystem)]
                                      .loops.paths[static_cast<std::size_t>(at.loop)]
                                      .first_row);
}

/// Clears the rows of a share on a hub, until what comes through the hub is known.
template <class World>
void clear_on_hub(const SharedLoop::OnHub& at, std::size_t rows, StepData<World>& table) {
  LoopRowState<World>* const row = &table.subsystems[static_cast<std::size_t>(at.subsystem)]
                                        .loops.states[first_row_of(at, table)];
  for (std::size_t r = 0; r < rows; ++r) {
    clear_share(row[r]);
    row[r].from.setZero();
  }
}

/// Sets the row of a coupling between subsystems, and those of its shares.
template <class World>
void calc_shared_coupling(const System<World>& system, const SharedLoop& shared,
                          const ClosureGains& gains, StepData<World>& table) {
  CoupledMotion sum;
  const auto add = [&](const LoopAt& at) {
    SubsystemData<World>& data = table.subsystems[static_cast<std::size_t>(at.subsystem)];
    add_coordinates(model_of(system, at), gains, data, sum);
    LoopRowState<World>& state = data.loops.states[first_row_of(at, table)];
    clear_share(state);
    state.from.setZero();
  };
  add(shared.own);
  for (const LoopAt& at : shared.ends) add(at);
  set_coupling(model_of(system, shared.own), first_row_of(shared.own, table), gains, sum,
               table.subsystems[static_cast<std::size_t>(shared.own.subsystem)]);
}

}  // namespace

template <class World>
void calc_shared_loop(const System<World>& system, const SharedLoop& shared, double t,
                      const ClosureGains& gains, StepData<World>& table) noexcept {
  const LoopModel& loop = model_of(system, shared.own);
  for (const SharedLoop::OnHub& at : shared.on_hubs) clear_on_hub(at, loop.rows.size(), table);
  if (loop.is_coupling()) {
    calc_shared_coupling(system, shared, gains, table);
    return;
  }
  const LoopAt& at_end = shared.ends.front();
  const LoopModel& share = model_of(system, at_end);
  SubsystemData<World>& own = table.subsystems[static_cast<std::size_t>(shared.own.subsystem)];
  SubsystemData<World>& end = table.subsystems[static_cast<std::size_t>(at_end.subsystem)];
  const auto [from, to, to_own] = find_places(system, shared, t, table);
  TwistOf<World> of_from = TwistOf<World>::Zero(), of_to = of_from;  // by the last iterate
  if (gains.position > 0.0) {
    of_from = calc_loop_acceleration(own, loop.from.body, loop.from.handle);
    of_to = calc_loop_acceleration(end, share.from.body, share.from.handle);
  }
  const std::size_t first = first_row_of(shared.own, table);
  LoopRowState<World>* const rows = &own.loops.states[first];
  LoopRowState<World>* const shares = &end.loops.states[first_row_of(at_end, table)];
  for (std::size_t r = 0; r < loop.rows.size(); ++r) {
    clear_share(rows[r]);
    clear_share(shares[r]);
    const RowMotion motion = calc_loop_row(loop.rows[r], from.motion, to.motion);
    const space::Position& p = from.motion.p;
    rows[r].from = turn_to_body(own, loop.from.body,
                                translate(space::Position(p - from.handle.p), motion.unit));
    shares[r].from = -turn_to_body(
        end, share.from.body,
        to_own.inverse() * space::Twist(translate(space::Position(p - to.handle.p), motion.unit)));
    const double known = linear(motion.unit).dot(centripetal_of(from)) +
                         known_of_body(share.from.is_moved(), motion.unit, p, to);
    if (share.from.is_moved())
      rows[r].given_rate =
          -translate(space::Position(p - to.motion.p), motion.unit).dot(to.carried.own);
    set_target(loop.rows[r], own.loops.use[first + r], motion, gains, known,
               rows[r].from.dot(of_from) + shares[r].from.dot(of_to), rows[r]);
  }
  if (loop.bearing) set_bearing(*loop.bearing, from, to, gains, rows);
}

template <class World>
void calc_shared_motion(const System<World>& system, double t, const ClosureGains& gains,
                        StepData<World>& table) noexcept {
  for (const SharedLoop& loop : system.shared_loops)
    calc_shared_loop(system, loop, t, gains, table);
}

template <class World>
SharedMotionParts parts_of_shared_motion(bool has_implicit, const StepData<World>& data) {
  SharedMotionParts parts;
  for (const int i : data.shared_loops.visited) {
    const SubsystemParts& own = data.subsystems[static_cast<std::size_t>(i)].parts;
    graph::add_to(parts.inputs, own.rotations, own.twists);
    if constexpr (!tree::kHasJointCoordinates<World>)
      graph::add_to(parts.inputs, own.all(&BodyParts::coordinates));
    for (const int j : data.subsystems[static_cast<std::size_t>(i)].loops.coupled)
      parts.inputs.push_back(own.bodies[static_cast<std::size_t>(j)].coordinates);
    if (has_implicit) graph::add_to(parts.inputs, own.all(&BodyParts::accelerations));
    parts.outputs.push_back(own.loops.motion);
  }
  return parts;
}

template <class World>
void update_shared_loops(const System<World>& system, double t, StepData<World>& data) noexcept {
  for (const int i : data.shared_loops.visited) {
    const auto index = static_cast<std::size_t>(i);
    SubsystemData<World>& own = data.subsystems[index];
    update_kinematics(system.subsystems[index], own);
    calc_poses(system.subsystems[index], own, own.loops.poses);
  }
  calc_shared_motion(system, t, {}, data);
}

template <class World>
void update_loops(const System<World>& system, std::size_t i, double t,
                  StepData<World>& table) noexcept {
  assert(i < table.subsystems.size());
  if (!table.subsystems[i].loops.is_empty()) calc_loop_motion(system, i, t, {}, table);
}

template <class World>
double calc_closure_energy(const Subsystem<World>& subsystem,
                           const LoopData<World>& loops) noexcept {
  double energy = 0.0;
  std::size_t r = 0;
  for (const LoopModel& loop : subsystem.loops) {
    if (loop.bearing) {
      const Eigen::Vector2d phi(loops.states[r].opening, loops.states[r + 1].opening);
      energy += 0.5 * phi.dot(loop.bearing->storing() * phi);
    }
    for (const LoopRow& row : loop.rows) {
      const double opening = loops.states[r++].opening;
      energy += 0.5 * row.stiffness * opening * opening;
    }
  }
  return energy;
}

template PlaceMotion calc_place_motion(const System<Plane>&, std::size_t, const LoopPlaceModel&,
                                       double, const StepData<Plane>&);
template LoopPlaces calc_place_motions(const System<Plane>&, std::size_t, const LoopModel&, double,
                                       const StepData<Plane>&);
template void calc_shared_loop(const System<Plane>&, const SharedLoop&, double, const ClosureGains&,
                               StepData<Plane>&) noexcept;
template void calc_shared_motion(const System<Plane>&, double, const ClosureGains&,
                                 StepData<Plane>&) noexcept;
template SharedMotionParts parts_of_shared_motion(bool, const StepData<Plane>&);
template void update_shared_loops(const System<Plane>&, double, StepData<Plane>&) noexcept;
template void calc_loop_motion(const System<Plane>&, std::size_t, double, const ClosureGains&,
                               StepData<Plane>&) noexcept;
template PartList parts_of_loop_motion(std::size_t, bool, const StepData<Plane>&);
template void update_loops(const System<Plane>&, std::size_t, double, StepData<Plane>&) noexcept;
template double calc_closure_energy(const Subsystem<Plane>&, const LoopData<Plane>&) noexcept;
template PlaceMotion calc_place_motion(const System<Space>&, std::size_t, const LoopPlaceModel&,
                                       double, const StepData<Space>&);
template LoopPlaces calc_place_motions(const System<Space>&, std::size_t, const LoopModel&, double,
                                       const StepData<Space>&);
template void calc_shared_loop(const System<Space>&, const SharedLoop&, double, const ClosureGains&,
                               StepData<Space>&) noexcept;
template void calc_shared_motion(const System<Space>&, double, const ClosureGains&,
                                 StepData<Space>&) noexcept;
template SharedMotionParts parts_of_shared_motion(bool, const StepData<Space>&);
template void update_shared_loops(const System<Space>&, double, StepData<Space>&) noexcept;
template void calc_loop_motion(const System<Space>&, std::size_t, double, const ClosureGains&,
                               StepData<Space>&) noexcept;
template PartList parts_of_loop_motion(std::size_t, bool, const StepData<Space>&);
template void update_loops(const System<Space>&, std::size_t, double, StepData<Space>&) noexcept;
template double calc_closure_energy(const Subsystem<Space>&, const LoopData<Space>&) noexcept;

}  // namespace spoke
