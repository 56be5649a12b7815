#pragma once

// Finds faults in a model in space, each a path of keys and words, by one set of rules for models
// from files and models filled in code.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "models/reader/spatial/spatial_fields.h"

namespace spoke::spatial {

/// A fault of a structure: its place, what is wrong, and what was expected. Keys are joined by
/// dots, indices count from 1: "joint.2.axis".
struct Fault {
  std::string path;  ///< path of the key; empty: the whole structure
  std::string text;  ///< what is wrong and expected; empty: nothing is wrong

  explicit operator bool() const { return !text.empty(); }
  /// Returns the fault seen from the structure that holds this one under `key`.
  Fault within(const std::string& key) const;
};

/// Keeps the first fault that is found.
class FirstFault {
 public:
  /// Finds numbers outside of their range, for visit_fields().
  void operator()(std::string_view key, double value, const Quantity& quantity,
                  Presence presence = Presence::required) const;
  void operator()(std::string_view key, int value, const Count& count, Presence presence) const;
  void operator()(std::string_view key, const Vector& value, const Quantity& quantity,
                  Presence presence) const;
  /// Finds array elements outside of their range.
  void numbers(std::string_view key, const std::vector<double>& values,
               const Quantity& quantity) const;

  /// Takes a fault if there was none before.
  void add(const Fault& fault) const {
    if (!fault_) fault_ = fault;
  }
  const Fault& found() const { return fault_; }

 private:
  mutable Fault fault_;  // mutable, since visitors are constant
};

/// Finds numbers of a structure outside of their range, by the rows of its keys, seen from a path
/// that ends in a dot.
template <class S>
void find_range_faults(const std::string& path, keys::Rows rows, const S& of,
                       const FirstFault& first) {
  keys::visit_numbers<Vector>(
      rows, of, [&](std::string_view key, const auto& value, const auto& range, Presence presence) {
        first(path + std::string(key), value, range, presence);
      });
}

/// Finds a direction of length zero.
Fault find_direction_fault(const std::string& key, const Vector& direction);
/// Finds a fault of an inertia tensor about the centre of mass. A body of its own needs a regular
/// tensor; that of a small mass on a beam may be zero.
enum class MayBeZero { no, yes };
Fault find_inertia_fault(const std::string& key, const Tensor& inertia, MayBeZero may_be_zero);
/// Finds a fault of a curve of this quantity over time.
Fault find_curve_fault(const std::string& key, const Curve& curve, const Quantity& quantity);
/// Finds a fault of a vector over time.
Fault find_course_fault(const std::string& key, const VectorCourse& course, std::string_view unit);
/// Finds a missing or malformed name.
Fault find_name_fault(const std::string& name);

/// What a tree of bodies stands on.
struct TreeBase {
  std::string_view name = "hub";         ///< as its joints call it
  std::string_view table = "subsystem";  ///< table of the tree in a scenario
  bool is_support = false;               ///< whether the tree is that of a support
  bool may_be_alone = false;             ///< whether there may be no body on it
};
/// Returns what a subsystem of a model stands on. The one of the support's name is the support's.
TreeBase base_of(const Subsystem& subsystem, const Model& model);

/// Finds a fault of sections of a beam of this length.
Fault find_fault(const Sections& sections, double length);
Fault find_fault(const Beam& beam);
Fault find_fault(const RigidBody& body);
/// Finds a fault of a solid; its mesh is read, unless it has one.
Fault find_fault(const SolidBody& body);
Fault find_fault(const Joint& joint);
Fault find_fault(const Blade& blade);
Fault find_fault(const Subsystem& subsystem, const TreeBase& base = {});
/// Finds a fault of the place that a body of a tree carries, a joint of the tree or an axle; none:
/// its base does.
Fault find_place_fault(const Body* carrier, const std::optional<double>& station,
                       const std::string& interface);
Fault find_fault(const Hub& hub);
/// Finds a fault of the springs, the dampers and the carrier of a suspension.
Fault find_fault(const Suspension& suspension);
/// Finds a fault of a support with its tree.
Fault find_fault(const Support& support, const Subsystem& tree);
/// Finds a fault of the axle of a rotor on a support.
Fault find_axle_fault(const Axle& axle, const Support& support, const Subsystem& tree);
/// Finds faults of the rotors besides the first, and of names that they share with others. `key`
/// of a rotor: "rotor.2".
Fault find_rotors_fault(const Model& model);
/// Finds what of a model does not fit its support: "hub.mass".
Fault find_carried_fault(const Model& model);
/// Finds a fault of a load on a model that is otherwise fine.
Fault find_fault(const PointLoad& load, const Model& model);
Fault find_fault(const DistributedLoad& load, const Model& model);
Fault find_fault(const HubLoad& load, const Model& model);
/// Finds a fault of a blade's aerodynamics, its beam of this length; seen from its own table.
Fault find_fault(const BladeAerodynamics& aerodynamics, double length);
Fault find_fault(const Airfoil& airfoil);
/// Finds a fault of the air around a model that is otherwise fine, seen from the scenario.
Fault find_fault(const Air& air, const Model& model);

/// Finds a fault of a controller of a model that is otherwise fine.
Fault find_fault(const PitchControl& control, const Model& model);
Fault find_fault(const OuterControl& control, const Model& model);
/// Finds faults of a turbine's laws, which `control` has.
Fault find_laws_fault(const OuterControl& control);

/// Returns what is wrong with the sizes of all blades and subsystems together; empty if nothing is.
std::string find_size_fault(const Model& model);
/// Returns what is wrong with damping.mass_factor, a number in its range; empty if nothing is.
std::string find_mass_factor_fault(const Model& model);

}  // namespace spoke::spatial
