#pragma once

// Motion of the bodies and sections of a spatial subsystem as the hub sees it, in the hub's frame
// H, with all derivatives exact. Rotations and twists of the table must be those of the state.

#include "engine/bodies/table/step_data.h"

namespace spoke {

/// Motion relative to the hub, in H.
struct SpatialMotion {
  space::Position p = space::Position::Zero();    ///< [m]
  space::Position v = space::Position::Zero();    ///< [m/s]
  space::Position a = space::Position::Zero();    ///< [m/s^2]
  space::Rotation R;                              ///< from the frame or section to H
  space::Angular w = space::Angular::Zero();      ///< [rad/s]
  space::Angular alpha = space::Angular::Zero();  ///< [rad/s^2]
};

/// Returns the hub's acceleration that subsystem `i` follows at the state at time `t` [s]: in H,
/// less gravity.
space::Twist calc_hub_acceleration(const System<Space>& system, std::size_t i,
                                   const StepData<Space>& data, double t) noexcept;

/// Returns X of body `j` by that of the body that carries it, or by the hub's acceleration, and the
/// accelerations of coordinates in the table.
space::Twist calc_next_acceleration(const TreeBody<Space>& body, std::size_t j,
                                    const SubsystemData<Space>& data,
                                    const space::Twist& parent_X) noexcept;
/// Returns the acceleration of a handle of body `j`, in its frame, by X of that frame.
space::Twist calc_handle_acceleration(const SubsystemData<Space>& data, std::size_t j, int handle,
                                      const space::Twist& X) noexcept;

/// Returns X of the last body of a path from the hub, less gravity, by the accelerations of its
/// coordinates and of those inboard.
space::Twist calc_frame_acceleration(const Subsystem<Space>& subsystem,
                                     const SubsystemData<Space>& data,
                                     const space::Twist& hub_acceleration,
                                     const std::vector<int>& path) noexcept;

/// Whether a reading shows accelerations, which are found from the hub outward along its path.
inline bool is_accelerated(const Reading<Space>& reading) {
  return reading.quantity == SensorQuantity::acceleration;
}

/// Returns the motion of a section as a sensor shows it: bodies with geometric stiffening are
/// foreshortened. Accelerations, and the hub's, count only where the reading is_accelerated().
SpatialMotion calc_shown_motion(const Subsystem<Space>& subsystem, const SubsystemData<Space>& data,
                                const space::Twist& hub_acceleration,
                                const Reading<Space>& reading) noexcept;

}  // namespace spoke
