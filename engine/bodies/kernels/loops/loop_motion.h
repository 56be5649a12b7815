#pragma once

// The state of a subsystem's loops in a pass: their openings, their unit forces on handles and hub,
// and the relative accelerations that close them (docs/formulation.md, section 12).

#include "engine/bodies/kernels/loops/anchor_motion.h"
#include "engine/bodies/table/step_data.h"

namespace spoke {

/// A handle of a body as the loops see it, in vectors of space resolved in H.
struct LoopHandle {
  space::Position p = space::Position::Zero();  ///< from the hub's origin [m]
  space::Rotation R;                            ///< from the frame of its section to H
  space::Twist twist = space::Twist::Zero();    ///< of its section [m/s, rad/s]
};

/// What a closure may add to the forces of its springs by the step that is made: shares of
/// stiffness and damping in an implicit pass, h^2 beta' and h gamma'; zero in an explicit one.
struct ClosureGains {
  double position = 0.0;  ///< [s^2]
  double velocity = 0.0;  ///< [s]
  /// Whether the pass changes no coordinate: rigid rows then ask for accelerations alone.
  bool stays = false;
  /// Shares of openings and rates that rigid rows take off besides: explicit passes that project.
  double opening = 0.0;  ///< [1/s^2]
  double rate = 0.0;     ///< [1/s]
};

// Handles of bodies, by world. The poses of the loops must be set.

LoopHandle calc_loop_handle(const SubsystemData<Plane>& data, int body, int handle) noexcept;
LoopHandle calc_loop_handle(const SubsystemData<Space>& data, int body, int handle) noexcept;

/// Turns a wrench in H to the frame of a body.
Twist turn_to_body(const SubsystemData<Plane>& data, int body, const space::Twist& wrench) noexcept;
space::Twist turn_to_body(const SubsystemData<Space>& data, int body,
                          const space::Twist& wrench) noexcept;

/// Returns the hub's acceleration that subsystem `i` follows at time t [s], less gravity, in H.
Twist calc_loop_hub_acceleration(const System<Plane>& system, std::size_t i, double t,
                                 const StepData<Plane>& data) noexcept;
space::Twist calc_loop_hub_acceleration(const System<Space>& system, std::size_t i, double t,
                                        const StepData<Space>& data) noexcept;

/// Sets the accelerations of frames up to the last body that carries a loop, by those of the
/// coordinates in the table. `hub`: of the hub, less gravity, in H.
void calc_loop_accelerations(const Subsystem<Plane>& subsystem, const Twist& hub,
                             SubsystemData<Plane>& data) noexcept;
void calc_loop_accelerations(const Subsystem<Space>& subsystem, const space::Twist& hub,
                             SubsystemData<Space>& data) noexcept;

/// Returns the acceleration of a handle by these, in the frame of its body.
Twist calc_loop_acceleration(const SubsystemData<Plane>& data, int body, int handle) noexcept;
space::Twist calc_loop_acceleration(const SubsystemData<Space>& data, int body,
                                    int handle) noexcept;

/// Returns the motion of a place of a loop of subsystem `i` at time t [s], which is not elsewhere.
template <class World>
PlaceMotion calc_place_motion(const System<World>& system, std::size_t i,
                              const LoopPlaceModel& place, double t, const StepData<World>& data);
/// The motion of the places of a loop, in H of its subsystem.
struct LoopPlaces {
  PlaceMotion from, to;
};
/// Returns it for a loop of subsystem `i`, no share, wherever its places are.
template <class World>
LoopPlaces calc_place_motions(const System<World>& system, std::size_t i, const LoopModel& loop,
                              double t, const StepData<World>& data);

/// Sets the states of all rows of subsystem `i` at time t [s]. Rotations and twists must be those
/// of the state.
template <class World>
void calc_loop_motion(const System<World>& system, std::size_t i, double t,
                      const ClosureGains& gains, StepData<World>& data) noexcept;
/// Returns the parts that they depend on; `has_implicit`: whether any pass is implicit.
template <class World>
PartList parts_of_loop_motion(std::size_t i, bool has_implicit, const StepData<World>& data);

/// Sets the states of the rows of a loop between subsystems, and of its shares, at time t [s],
/// behind those of the other loops of all that it visits.
template <class World>
void calc_shared_loop(const System<World>& system, const SharedLoop& loop, double t,
                      const ClosureGains& gains, StepData<World>& data) noexcept;
/// Sets those of all such loops.
template <class World>
void calc_shared_motion(const System<World>& system, double t, const ClosureGains& gains,
                        StepData<World>& data) noexcept;
/// The parts that they depend on, and those that are set; `has_implicit`: whether any pass is
/// implicit.
struct SharedMotionParts {
  PartList inputs, outputs;
};
template <class World>
SharedMotionParts parts_of_shared_motion(bool has_implicit, const StepData<World>& data);

/// Sets them at the end of a step, with the motion of all subsystems that they visit, by the
/// coordinates in the table, as update_loops() does for other loops.
template <class World>
void update_shared_loops(const System<World>& system, double t, StepData<World>& data) noexcept;

/// Sets them at the end of a step, if the subsystem has loops, by the coordinates in the table: the
/// last pass of an implicit step leaves them one correction behind, see update_kinematics().
template <class World>
void update_loops(const System<World>& system, std::size_t i, double t,
                  StepData<World>& data) noexcept;

/// Returns the energy of the springs in closures by the states of their rows [J].
template <class World>
double calc_closure_energy(const Subsystem<World>& subsystem,
                           const LoopData<World>& loops) noexcept;

}  // namespace spoke
