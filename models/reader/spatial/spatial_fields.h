#pragma once

// Ranges of the numbers of a model in space, as scenario_fields.h has them for the plane: the
// reader of files, the check of what is filled in code and the writer all go by it. visit_fields()
// calls visit(key, value, range, presence) for the numbers and vectors of a structure, in the order
// of the file.

#include <array>
#include <string_view>
#include <vector>

#include "models/reader/scenario_fields.h"
#include "models/spatial_model.h"

namespace spoke::spatial {

inline constexpr Quantity kAngle = Quantity::any("rad");
inline constexpr Quantity kInertia = Quantity::any("kg m^2");
inline constexpr Quantity kDirection = Quantity::any("");
inline constexpr Quantity kVelocity = Quantity::any("m/s");
inline constexpr Quantity kMoment = Quantity::any("N m");
inline constexpr Quantity kMomentPerLength = Quantity::any("N");

template <PerhapsConst<PitchControl> P, class Visit>
void visit_fields(P& control, const Visit& visit) {
  visit("speed", control.speed, kSpeed, Presence::required);
  visit("proportional", control.proportional, Quantity::not_negative("s"), Presence::required);
  visit("integral", control.integral, Quantity::not_negative("rad/rad"), Presence::required);
  visit("minimum", control.minimum, kAngle, Presence::required);
  visit("maximum", control.maximum, kAngle, Presence::required);
}

/// Visits the numbers that may be missing.
template <PerhapsConst<PitchControl> P, class Visit>
void visit_options(P& control, const Visit& visit) {
  visit("half_gain_angle", control.half_gain_angle, Quantity::positive("rad"));
  visit("rate", control.rate, Quantity::positive("rad/s"));
  visit("filter", control.filter, Quantity::positive("rad/s"));
  visit("period", control.period, Quantity::positive("s"));
}

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

template <PerhapsConst<Hub> H, class Visit>
void visit_fields(H& hub, const Visit& visit) {
  const bool is_free = hub.support == HubSupport::free;
  visit("axis", hub.axis, kDirection, Presence::optional);
  visit("radius", hub.radius, Quantity::not_negative("m"), Presence::optional);
  visit("mass", hub.mass, is_free ? Quantity::positive("kg") : Quantity::not_negative("kg"),
        is_free ? Presence::required : Presence::optional);
  visit("center", hub.center, kLength, Presence::optional);
  visit("velocity", hub.velocity, kVelocity, Presence::optional);
  visit("angular_velocity", hub.angular_velocity, kSpeed, Presence::optional);
}

template <PerhapsConst<VectorHarmonic> V, class Visit>
void visit_fields(V& course, std::string_view unit, const Visit& visit) {
  visit("constant", course.constant, Quantity::any(unit), Presence::optional);
  visit("rate", course.rate, Quantity::any(unit == "m" ? "m/s" : "rad/s"), Presence::optional);
  visit("amplitude", course.amplitude, Quantity::any(unit), Presence::optional);
  visit("frequency", course.frequency, kSpeed, Presence::optional);
  visit("phase", course.phase, kAngle, Presence::optional);
}

template <PerhapsConst<Beam> B, class Visit>
void visit_fields(B& beam, const Visit& visit) {
  visit("length", beam.length, Quantity::positive("m"), Presence::required);
  visit("bodies", beam.bodies, Count{1, kMostOfAKind}, Presence::optional);
  visit("elements", beam.elements, Count{1, kMostOfAKind}, Presence::optional);
}

template <PerhapsConst<Blade> B, class Visit>
void visit_fields(B& blade, const Visit& visit) {
  visit("azimuth", blade.azimuth, kAngle, Presence::optional);
  visit("precone", blade.precone, kAngle, Presence::optional);
}

template <PerhapsConst<Subsystem> S, class Visit>
void visit_fields(S& subsystem, const Visit& visit) {
  visit("azimuth", subsystem.azimuth, kAngle, Presence::optional);
}

template <PerhapsConst<PointMass> P, class Visit>
void visit_fields(P& point, const Visit& visit) {
  visit("position", point.position, kStation, Presence::required);
  visit("mass", point.mass, Quantity::positive("kg"), Presence::required);
  visit("offset", point.offset, kLength, Presence::optional);
}

template <PerhapsConst<RigidBody> R, class Visit>
void visit_fields(R& body, const Visit& visit) {
  visit("mass", body.mass, Quantity::positive("kg"), Presence::required);
  visit("center", body.center, kLength, Presence::optional);
}

template <PerhapsConst<Suspension> S, class Visit>
void visit_fields(S& suspension, const Visit& visit) {
  visit("mass", suspension.mass, Quantity::positive("kg"), Presence::required);
  visit("center", suspension.center, kLength, Presence::optional);
}

template <PerhapsConst<Fuselage> F, class Visit>
void visit_fields(F& fuselage, const Visit& visit) {
  visit("mass", fuselage.mass, Quantity::positive("kg"), Presence::required);
  visit("center", fuselage.center, kLength, Presence::optional);
  visit("position", fuselage.position, kLength, Presence::optional);
  visit("attitude", fuselage.attitude, kAngle, Presence::optional);
  visit("velocity", fuselage.velocity, kVelocity, Presence::optional);
  visit("angular_velocity", fuselage.angular_velocity, kSpeed, Presence::optional);
}

template <PerhapsConst<Axle> A, class Visit>
void visit_fields(A& axle, const Visit& visit) {
  visit("offset", axle.offset, kLength, Presence::optional);
  visit("orientation", axle.orientation, kAngle, Presence::optional);
}

inline constexpr Quantity kTraction = Quantity::any("Pa");
inline constexpr Quantity kFrequency = Quantity::positive("Hz");
inline constexpr Quantity kDampingRatio = Quantity::not_negative("");
inline constexpr Quantity kLengthScale = Quantity::positive("");
inline constexpr Count kModes{0, 10'000};

template <PerhapsConst<SolidMaterial> M, class Visit>
void visit_fields(M& material, const Visit& visit) {
  visit("youngs_modulus", material.youngs_modulus, Quantity::positive("Pa"), Presence::required);
  visit("poissons_ratio", material.poissons_ratio, Quantity::inside(-1.0, 0.5), Presence::required);
  visit("density", material.density, Quantity::positive("kg/m^3"), Presence::required);
}

template <PerhapsConst<PlaneNodes> N, class Visit>
void visit_fields(N& plane, const Visit& visit) {
  visit("point", plane.point, kLength, Presence::required);
  visit("normal", plane.normal, kDirection, Presence::required);
  visit("tolerance", plane.tolerance, Quantity::positive("m"), Presence::optional);
}
template <PerhapsConst<CylinderNodes> N, class Visit>
void visit_fields(N& cylinder, const Visit& visit) {
  visit("point", cylinder.point, kLength, Presence::required);
  visit("axis", cylinder.axis, kDirection, Presence::required);
  visit("radius", cylinder.radius, Quantity::positive("m"), Presence::required);
  visit("tolerance", cylinder.tolerance, Quantity::positive("m"), Presence::optional);
}
template <PerhapsConst<BoxNodes> N, class Visit>
void visit_fields(N& box, const Visit& visit) {
  visit("from", box.from, kLength, Presence::required);
  visit("to", box.to, kLength, Presence::required);
}

/// Visits the arrays of sections that hold a number for each station. visit(key, values, quantity);
/// material arrays are all but those of the shape.
template <PerhapsConst<Sections> S, class Visit>
void visit_stiffnesses(S& s, const Visit& visit) {
  visit("axial_stiffness", s.axial_stiffness, Quantity::positive("N"));
  visit("flap_stiffness", s.flap_stiffness, Quantity::positive("N m^2"));
  visit("lag_stiffness", s.lag_stiffness, Quantity::positive("N m^2"));
  visit("torsion_stiffness", s.torsion_stiffness, Quantity::positive("N m^2"));
}
template <PerhapsConst<Sections> S, class Visit>
void visit_shear_stiffnesses(S& s, const Visit& visit) {
  visit("flap_shear_stiffness", s.flap_shear_stiffness, Quantity::positive("N"));
  visit("lag_shear_stiffness", s.lag_shear_stiffness, Quantity::positive("N"));
}
template <PerhapsConst<Sections> S, class Visit>
void visit_inertias(S& s, const Visit& visit) {
  visit("flap_inertia", s.flap_inertia, Quantity::positive("kg m"));
  visit("lag_inertia", s.lag_inertia, Quantity::positive("kg m"));
}
template <PerhapsConst<Sections> S, class Visit>
void visit_shape(S& s, const Visit& visit) {
  visit("twist", s.twist, kAngle);
  visit("sweep", s.sweep, kLength);
  visit("prebend", s.prebend, kLength);
  visit("chord", s.chord, Quantity::not_negative("m"));
  visit("thickness", s.thickness, Quantity::not_negative("m"));
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

template <PerhapsConst<Joint> J, class Visit>
void visit_fields(J& joint, const Visit& visit) {
  visit("offset", joint.offset, kLength, Presence::optional);
  visit("orientation", joint.orientation, kAngle, Presence::optional);
}

template <PerhapsConst<PointLoad> L, class Visit>
void visit_fields(L& load, const Visit& visit) {
  visit("force", load.force, kForce, Presence::optional);
  visit("moment", load.moment, kMoment, Presence::optional);
  visit("ramp", load.ramp, kRamp, Presence::optional);
}

template <PerhapsConst<DistributedLoad> L, class Visit>
void visit_fields(L& load, const Visit& visit) {
  visit("force_per_length", load.force_per_length, kForcePerLength, Presence::optional);
  visit("moment_per_length", load.moment_per_length, kMomentPerLength, Presence::optional);
  visit("ramp", load.ramp, kRamp, Presence::optional);
}

template <PerhapsConst<HubLoad> L, class Visit>
void visit_fields(L& load, const Visit& visit) {
  visit("position", load.position, kLength, Presence::optional);
  visit("force", load.force, kForce, Presence::optional);
  visit("torque", load.torque, kMoment, Presence::optional);
  visit("ramp", load.ramp, kRamp, Presence::optional);
}

inline constexpr Quantity kReynolds = Quantity::not_negative("");
inline constexpr Quantity kCoefficient = Quantity::any("");

/// Visits the arrays of a blade's aerodynamics that hold a number for each station.
template <PerhapsConst<BladeAerodynamics> A, class Visit>
void visit_stations(A& aerodynamics, const Visit& visit) {
  visit("chord", aerodynamics.chord, Quantity::not_negative("m"));
  visit("twist", aerodynamics.twist, kAngle);
  visit("center", aerodynamics.center, kLength);
}

}  // namespace spoke::spatial
