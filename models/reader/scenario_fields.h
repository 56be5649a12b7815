#pragma once

// Ranges of the numbers of a scenario, in one place: the reader of files and the check of what is
// filled in code both go by it. visit_fields() calls visit(key, value, range, presence) for the
// numbers of a structure, in the order of the file; a range is a Quantity or a Count.

#include <concepts>
#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

#include "models/scenario.h"
#include "models/support/key_row.h"
#include "models/support/quantity.h"

namespace spoke {

/// Whether the motion of a hub, in the plane or in space, is an unknown of the model.
template <class H>
bool moves_alone(const H& hub) {
  return hub.support == HubSupport::free || !prescribes_motion(hub.drive);
}

/// The fault of a load or sensor on blades where there are none.
inline constexpr const char* kNoBlades = "is on blades, of which there are none";

template <class T, class Of>
concept PerhapsConst = std::same_as<std::remove_const_t<T>, Of>;

// Sizes beyond these are slips of the keyboard, not machines anybody simulates; below them
// the engine still compares its need with the memory there is.
inline constexpr int kMostOfAKind = 100'000;
inline constexpr std::size_t kMostPointMasses = 1000;  ///< on a blade

// Ranges of numbers that stand in arrays.
inline constexpr Quantity kGravity = Quantity::any("m/s^2");
inline constexpr Quantity kForce = Quantity::any("N");
inline constexpr Quantity kFactor = Quantity::any("");
inline constexpr Quantity kTime = Quantity::any("s");
inline constexpr Quantity kSpeed = Quantity::any("rad/s");
inline constexpr Quantity kTorque = Quantity::any("N m");
inline constexpr Quantity kForcePerLength = Quantity::any("N/m");
inline constexpr Quantity kLength = Quantity::any("m");
inline constexpr Quantity kRamp = Quantity::not_negative("s");
inline constexpr Quantity kStation = Quantity::not_negative("m");

template <PerhapsConst<Hub> H, class Visit>
void visit_fields(H& hub, const Visit& visit) {
  const bool is_free = hub.support == HubSupport::free;
  visit("radius", hub.radius, Quantity::not_negative("m"), Presence::optional);
  visit("inertia", hub.inertia, Quantity::positive("kg m^2"), Presence::optional);
  visit("mass", hub.mass, is_free ? Quantity::positive("kg") : Quantity::not_negative("kg"),
        is_free ? Presence::required : Presence::optional);
}

template <PerhapsConst<SpinUp> D, class Visit>
void visit_fields(D& drive, const Visit& visit) {
  visit("speed", drive.speed, kSpeed, Presence::required);
  visit("ramp", drive.ramp, Quantity::positive("s"), Presence::required);
}

template <PerhapsConst<SpinUpHoldSpinDown> D, class Visit>
void visit_fields(D& drive, const Visit& visit) {
  visit("speed", drive.speed, kSpeed, Presence::required);
  visit("ramp", drive.ramp, Quantity::positive("s"), Presence::required);
  visit("hold", drive.hold, Quantity::not_negative("s"), Presence::optional);
  visit("ramp_down", drive.ramp_down, Quantity::positive("s"), Presence::optional);
}

template <PerhapsConst<TorqueDrive> D, class Visit>
void visit_fields(D& drive, const Visit& visit) {
  visit("initial_speed", drive.initial_speed, kSpeed, Presence::optional);
}

template <PerhapsConst<FreeDrive> D, class Visit>
void visit_fields(D& drive, const Visit& visit) {
  visit("initial_speed", drive.initial_speed, kSpeed, Presence::optional);
}

/// Whether a blade is described by sections, rightly or wrongly.
inline bool has_sections(const Blade& blade) { return blade.sections != BladeSections{}; }

/// Visits the arrays of sections that are as long as that of the stations.
template <PerhapsConst<BladeSections> S, class Visit>
void visit_properties(S& sections, const Visit& visit) {
  visit("mass_per_length", sections.mass_per_length, Quantity::positive("kg/m"));
  visit("axial_stiffness", sections.axial_stiffness, Quantity::positive("N"));
  visit("bending_stiffness", sections.bending_stiffness, Quantity::positive("N m^2"));
}

template <PerhapsConst<PointMass> P, class Visit>
void visit_fields(P& point, const Visit& visit) {
  visit("mass", point.mass, Quantity::positive("kg"), Presence::required);
  visit("inertia", point.inertia, Quantity::not_negative("kg m^2"), Presence::optional);
}

template <PerhapsConst<Blade> B, class Visit>
void visit_fields(B& blade, const Visit& visit) {
  visit("length", blade.length, Quantity::positive("m"), Presence::required);
  visit("bodies", blade.bodies, Count{1, kMostOfAKind}, Presence::optional);
  visit("elements", blade.elements, Count{1, kMostOfAKind}, Presence::optional);
  if (!has_sections(blade)) {
    visit("density", blade.density, Quantity::positive("kg/m^3"), Presence::required);
    visit("area", blade.area, Quantity::positive("m^2"), Presence::required);
    visit("second_moment", blade.second_moment, Quantity::positive("m^4"), Presence::required);
    visit("youngs_modulus", blade.youngs_modulus, Quantity::positive("Pa"), Presence::required);
  }
  visit("azimuth", blade.azimuth, Quantity::any("rad"), Presence::optional);
}

template <PerhapsConst<Damping> D, class Visit>
void visit_fields(D& damping, const Visit& visit) {
  visit("mass_factor", damping.mass_factor, Quantity::not_negative("1/s"), Presence::optional);
  visit("stiffness_factor", damping.stiffness_factor, Quantity::not_negative("s"),
        Presence::optional);
}

template <PerhapsConst<ConstantSpeed> D, class Visit>
void visit_fields(D& drive, const Visit& visit) {
  visit("speed", drive.speed, kSpeed, Presence::required);
}

template <PerhapsConst<TorqueBySpeed> D, class Visit>
void visit_fields(D& drive, const Visit& visit) {
  visit("initial_speed", drive.initial_speed, kSpeed, Presence::optional);
  visit("ramp", drive.ramp, kRamp, Presence::optional);
}

template <PerhapsConst<PointLoad> L, class Visit>
void visit_fields(L& load, const Visit& visit) {
  visit("moment", load.moment, Quantity::any("N m"), Presence::optional);
  visit("ramp", load.ramp, kRamp, Presence::optional);
}

template <PerhapsConst<DistributedLoad> L, class Visit>
void visit_fields(L& load, const Visit& visit) {
  visit("moment_per_length", load.moment_per_length, Quantity::any("N"), Presence::optional);
  visit("ramp", load.ramp, kRamp, Presence::optional);
}

template <PerhapsConst<Drag> D, class Visit>
void visit_fields(D& drag, const Visit& visit) {
  visit("linear", drag.linear, Quantity::not_negative("N s/m"), Presence::optional);
  visit("quadratic", drag.quadratic, Quantity::not_negative("N s^2/m^2"), Presence::optional);
  visit("linear_per_length", drag.linear_per_length, Quantity::not_negative("N s/m^2"),
        Presence::optional);
  visit("quadratic_per_length", drag.quadratic_per_length, Quantity::not_negative("N s^2/m^3"),
        Presence::optional);
  visit("ramp", drag.ramp, kRamp, Presence::optional);
}

template <PerhapsConst<HubLoad> L, class Visit>
void visit_fields(L& load, const Visit& visit) {
  visit("torque", load.torque, kTorque, Presence::optional);
  visit("ramp", load.ramp, kRamp, Presence::optional);
}

template <PerhapsConst<Integration> I, class Visit>
void visit_fields(I& integration, const Visit& visit) {
  constexpr int most_iterations = 1000;
  visit("duration", integration.duration, Quantity::positive("s"), Presence::required);
  visit("step", integration.step, Quantity::positive("s"), Presence::optional);
  visit("spectral_radius", integration.spectral_radius, Quantity::between(0.0, 1.0),
        Presence::optional);
  visit("tolerance", integration.tolerance, Quantity::positive("m, rad"), Presence::optional);
  visit("iterations", integration.iterations, Count{0, most_iterations}, Presence::optional);
  visit("max_iterations", integration.max_iterations, Count{1, most_iterations},
        Presence::optional);
  visit("loop_redundancy", integration.loop_redundancy, Quantity::inside(0.0, 1.0),
        Presence::optional);
}

template <PerhapsConst<Limits> L, class Visit>
void visit_fields(L& limits, const Visit& visit) {
  visit("deflection", limits.deflection, Quantity::not_negative(""), Presence::optional);
  visit("energy_growth", limits.energy_growth, Quantity::not_negative(""), Presence::optional);
  visit("step_error", limits.step_error, Quantity::not_negative(""), Presence::optional);
  visit("momentum", limits.momentum, Quantity::not_negative(""), Presence::optional);
}

template <PerhapsConst<Output> O, class Visit>
void visit_fields(O& output, const Visit& visit) {
  visit("interval", output.interval, Quantity::not_negative("s"), Presence::optional);
}

// Rules for several numbers together. Each returns in words what is wrong, or an empty text.

/// Checks a step and a duration that are each in their range.
std::string find_step_fault(const Integration& integration);
/// A fault of a blade that is described by sections: the key, and what is wrong in words. Both
/// texts are empty if there is none.
struct SectionsFault {
  std::string key, text;
};
SectionsFault find_sections_fault(const Blade& blade);
/// Checks the number of stations and point masses on all blades.
std::string find_station_fault(std::size_t count);
/// Returns the number of stations and point masses of a blade.
std::size_t count_stations(const Blade& blade);
/// Returns what is wrong with the geometric stiffening of a beam of such strains; null: nothing.
const char* find_strain_fault(BeamStrain strain, bool geometric_stiffening);
std::string find_element_fault(const std::vector<Blade>& blades);
/// Checks damping.mass_factor, which is in its range.
std::string find_mass_factor_fault(const Damping& damping, const std::vector<Blade>& blades);
/// Checks the number of points that count_points() has found in all.
std::string find_point_fault(std::size_t points);

/// Returns the blade on which the place of a load is limited most: its own, or the shortest.
/// Precondition: the blade exists.
const Blade& shortest_loaded(BladeChoice loaded, const std::vector<Blade>& blades);
/// Returns the range of places on this blade where a load may act.
Quantity place_on(const Blade& blade);
/// Returns the range of the outer end of a load between two places, whose inner end `from` is in
/// its range.
Quantity end_on(const Blade& blade, double from);
/// Returns whether a drag has a part per length.
inline bool is_distributed(const Drag& drag) {
  return drag.linear_per_length != 0.0 || drag.quadratic_per_length != 0.0;
}
/// Counts the points that a load stores on each blade that it acts on: those of its curve, and for
/// a load between two places four more for each element of the blade.
std::size_t count_points(BladeChoice loaded, bool is_distributed, const Curve& factor,
                         const std::vector<Blade>& blades);

}  // namespace spoke
