#pragma once

// Numbers and vectors of a model in space by the rows of their keys, as scenario_fields.h has them
// for the plane: the reader of files, the check of what is filled in code and the writer all go by
// them.

#include <array>
#include <string_view>
#include <vector>

#include "models/reader/keys/air_keys.h"
#include "models/reader/keys/beam_keys.h"
#include "models/reader/keys/control_keys.h"
#include "models/reader/keys/joint_keys.h"
#include "models/reader/keys/solid_keys.h"
#include "models/reader/keys/tree_keys.h"
#include "models/reader/scenario_fields.h"
#include "models/spatial_model.h"

namespace spoke::spatial {

/// The units of a coordinate of a joint.
struct CoordinateUnits {
  std::string_view position, speed, effort, stiffness, damping;
};
inline constexpr CoordinateUnits kAngleUnits{"rad", "rad/s", "N m", "N m/rad", "N m s/rad"};
inline constexpr CoordinateUnits kWayUnits{"m", "m/s", "N", "N/m", "N s/m"};
/// Of the six coordinates of a bushing together, as a file has them.
inline constexpr CoordinateUnits kBushingUnits{"m, rad", "m/s, rad/s", "N, N m", "N/m, N m/rad",
                                               "N s/m, N m s/rad"};

inline const CoordinateUnits& units_of(JointKind kind, int coordinate) {
  return slides(kind, coordinate) ? kWayUnits : kAngleUnits;
}

// The rows of structures, by which visit_fields() goes.
inline keys::Rows rows_of(const Hub&) { return keys::kSpaceHubRows; }
inline keys::Rows rows_of(const Beam&) { return keys::kBeamRows; }
inline keys::Rows rows_of(const Blade&) { return keys::kSpaceBladeRows; }
inline keys::Rows rows_of(const Subsystem&) { return keys::kSubsystemRows; }
inline keys::Rows rows_of(const PointMass&) { return keys::kSpacePointMassRows; }
inline keys::Rows rows_of(const RigidBody&) { return keys::kRigidBodyRows; }
inline keys::Rows rows_of(const Suspension&) { return keys::kSuspensionRows; }
inline keys::Rows rows_of(const Fuselage&) { return keys::kFuselageRows; }
inline keys::Rows rows_of(const Axle&) { return keys::kAxleRows; }
inline keys::Rows rows_of(const DriveTrain&) { return keys::kDriveTrainRows; }
inline keys::Rows rows_of(const SolidMaterial&) { return keys::kMaterialRows; }
inline keys::Rows rows_of(const PlaneNodes&) { return keys::kPlaneNodesRows; }
inline keys::Rows rows_of(const CylinderNodes&) { return keys::kCylinderNodesRows; }
inline keys::Rows rows_of(const BoxNodes&) { return keys::kBoxNodesRows; }
inline keys::Rows rows_of(const Joint&) { return keys::kJointRows; }
inline keys::Rows rows_of(const PointLoad&) { return keys::kSpacePointLoadRows; }
inline keys::Rows rows_of(const DistributedLoad&) { return keys::kSpaceDistributedLoadRows; }
inline keys::Rows rows_of(const HubLoad&) { return keys::kSpaceHubLoadRows; }

template <HasRows S, class Visit>
void visit_fields(S& of, const Visit& visit) {
  keys::visit_numbers<Vector>(rows_of(of), of, visit);
  if constexpr (IsLoad<S>)
    keys::visit_numbers<Vector>(keys::kLoadCourseRows<std::remove_const_t<S>>, of, visit);
}

template <PerhapsConst<VectorHarmonic> V, class Visit>
void visit_fields(V& course, std::string_view unit, const Visit& visit) {
  visit("constant", course.constant, Quantity::any(unit), Presence::optional);
  visit("rate", course.rate, Quantity::any(unit == "m" ? "m/s" : "rad/s"), Presence::optional);
  visit("amplitude", course.amplitude, Quantity::any(unit), Presence::optional);
  visit("frequency", course.frequency, kSpeed, Presence::optional);
  visit("phase", course.phase, kAngle, Presence::optional);
}

/// Visits the arrays of sections that hold a number for each station. visit(key, values, quantity);
/// material arrays are all but those of the shape.
template <PerhapsConst<Sections> S, class Visit>
void visit_stiffnesses(S& s, const Visit& visit) {
  keys::visit_stations(keys::kStiffnessRows, s, visit);
}
template <PerhapsConst<Sections> S, class Visit>
void visit_shear_stiffnesses(S& s, const Visit& visit) {
  keys::visit_stations(keys::kShearStiffnessRows, s, visit);
}
template <PerhapsConst<Sections> S, class Visit>
void visit_inertias(S& s, const Visit& visit) {
  keys::visit_stations(keys::kSectionInertiaRows, s, visit);
}
template <PerhapsConst<Sections> S, class Visit>
void visit_shape(S& s, const Visit& visit) {
  keys::visit_stations(keys::kSectionShapeRows, s, visit);
}
/// Visits the arrays that hold two numbers for each station.
template <PerhapsConst<Sections> S, class Visit>
void visit_stiffness_centers(S& s, const Visit& visit) {
  visit("tension_center", s.tension_center, kLength);
  visit("shear_center", s.shear_center, kLength);
}

template <PerhapsConst<Stop> S, class Visit>
void visit_fields(S& stop, const CoordinateUnits& unit, const Visit& visit) {
  visit("lower", stop.lower, Quantity::any(unit.position), Presence::required);
  visit("upper", stop.upper, Quantity::any(unit.position), Presence::required);
  visit("stiffness", stop.stiffness, Quantity::positive(unit.stiffness), Presence::required);
  visit("damping", stop.damping, Quantity::not_negative(unit.damping), Presence::optional);
  visit("width", stop.width, Quantity::positive(unit.position), Presence::required);
}

template <PerhapsConst<Relaxation> R, class Visit>
void visit_fields(R& relaxation, const CoordinateUnits& unit, const Visit& visit) {
  visit("stiffness", relaxation.stiffness, Quantity::positive(unit.stiffness), Presence::required);
  visit("time", relaxation.time, Quantity::positive("s"), Presence::required);
}

template <PerhapsConst<AzimuthMotion> M, class Visit>
void visit_fields(M& motion, const CoordinateUnits& unit, const Visit& visit) {
  visit("mean", motion.mean, Quantity::any(unit.position), Presence::optional);
  visit("cosine", motion.cosine, Quantity::any(unit.position), Presence::optional);
  visit("sine", motion.sine, Quantity::any(unit.position), Presence::optional);
}

/// Visits the numbers of a coordinate that are keys of its joint.
template <PerhapsConst<JointCoordinate> C, class Visit>
void visit_fields(C& coordinate, const CoordinateUnits& unit, const Visit& visit) {
  visit("stiffness", coordinate.stiffness, Quantity::not_negative(unit.stiffness));
  visit("damping", coordinate.damping, Quantity::not_negative(unit.damping));
  visit("rest", coordinate.rest, Quantity::any(unit.position));
  visit("initial", coordinate.initial, Quantity::any(unit.position));
  visit("initial_speed", coordinate.initial_speed, Quantity::any(unit.speed));
}

/// Visits the arrays of a blade's aerodynamics that hold a number for each station.
template <PerhapsConst<BladeAerodynamics> A, class Visit>
void visit_stations(A& aerodynamics, const Visit& visit) {
  keys::visit_stations(keys::kBladeAerodynamicsRows, aerodynamics, visit);
}

}  // namespace spoke::spatial
