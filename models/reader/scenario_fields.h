#pragma once

// Numbers of a scenario by the rows of their keys (keys/): the reader of files and the check of
// what is filled in code both go by them. visit_fields() calls visit(key, value, range, presence)
// for the numbers and vectors of a structure, in the order of its rows; a range is a Quantity or a
// Count.

#include <concepts>
#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

#include "models/reader/keys/blade_keys.h"
#include "models/reader/keys/hub_keys.h"
#include "models/reader/keys/load_keys.h"
#include "models/reader/keys/quantities.h"
#include "models/reader/keys/simulation_keys.h"
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

inline constexpr std::size_t kMostPointMasses = 1000;  ///< on a blade

// The rows of structures, by which visit_fields() goes.
inline keys::Rows rows_of(const Hub&) { return keys::kHubRows; }
inline keys::Rows rows_of(const SpinUp&) { return keys::kSpinUpRows; }
inline keys::Rows rows_of(const SpinUpHoldSpinDown&) { return keys::kSpinUpHoldSpinDownRows; }
inline keys::Rows rows_of(const TorqueDrive&) { return keys::kTorqueDriveRows; }
inline keys::Rows rows_of(const FreeDrive&) { return keys::kFreeDriveRows; }
inline keys::Rows rows_of(const ConstantSpeed&) { return keys::kConstantSpeedRows; }
inline keys::Rows rows_of(const TorqueBySpeed&) { return keys::kTorqueBySpeedRows; }
inline keys::Rows rows_of(const PointMass&) { return keys::kPointMassRows; }
inline keys::Rows rows_of(const Blade&) { return keys::kBladeRows; }
inline keys::Rows rows_of(const Damping&) { return keys::kDampingRows; }
inline keys::Rows rows_of(const PointLoad&) { return keys::kPointLoadRows; }
inline keys::Rows rows_of(const DistributedLoad&) { return keys::kDistributedLoadRows; }
inline keys::Rows rows_of(const Drag&) { return keys::kDragRows; }
inline keys::Rows rows_of(const HubLoad&) { return keys::kHubLoadRows; }
inline keys::Rows rows_of(const Integration&) { return keys::kIntegrationRows; }
inline keys::Rows rows_of(const Limits&) { return keys::kLimitsRows; }
inline keys::Rows rows_of(const Output&) { return keys::kOutputRows; }

template <class S>
concept HasRows = requires(const S& s) {
  { rows_of(s) } -> std::same_as<keys::Rows>;
};

/// Whether a structure is a load, whose rows are followed by those of its course.
template <class S>
concept IsLoad = HasRows<S> && requires(const S& s) {
  s.factor;
};

template <HasRows S, class Visit>
void visit_fields(S& of, const Visit& visit) {
  keys::visit_numbers<void>(rows_of(of), of, visit);
  if constexpr (IsLoad<S>)
    keys::visit_numbers<void>(keys::kLoadCourseRows<std::remove_const_t<S>>, of, visit);
}

/// Whether a blade is described by sections, rightly or wrongly.
inline bool has_sections(const Blade& blade) { return !keys::is_uniform(blade); }

/// Visits the arrays of sections that are as long as that of the stations.
template <PerhapsConst<BladeSections> S, class Visit>
void visit_properties(S& sections, const Visit& visit) {
  keys::visit_stations(keys::kBladeSectionsRows, sections, visit);
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
