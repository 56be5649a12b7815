#pragma once

// What is wrong with a model in space: a path of keys, and words. One set of rules for models from
// files and models filled in code.

#include <string>
#include <string_view>
#include <vector>

#include "models/reader/spatial/spatial_fields.h"

namespace spoke::spatial {

/// What is wrong with a structure, where in it, and what was expected. Keys are joined by dots,
/// indices count from 1: "joint.2.axis".
struct Fault {
  std::string path;  ///< of the key; empty: all of it
  std::string text;  ///< empty: nothing is wrong

  explicit operator bool() const { return !text.empty(); }
  /// The same, seen from the structure that holds this one under `key`.
  Fault within(const std::string& key) const;
};

/// Keeps the first fault that is found.
class FirstFault {
 public:
  /// For visit_fields(): numbers outside of their range.
  void operator()(std::string_view key, double value, const Quantity& quantity,
                  Presence presence = Presence::required) const;
  void operator()(std::string_view key, int value, const Count& count, Presence presence) const;
  void operator()(std::string_view key, const Vector& value, const Quantity& quantity,
                  Presence presence) const;
  /// Arrays.
  void numbers(std::string_view key, const std::vector<double>& values,
               const Quantity& quantity) const;

  /// Takes a fault if there was none before.
  void add(const Fault& fault) const {
    if (!fault_) fault_ = fault;
  }
  const Fault& found() const { return fault_; }

 private:
  mutable Fault fault_;  // visitors are constant
};

/// Of a direction that must not be of length zero.
Fault find_direction_fault(const std::string& key, const Vector& direction);
/// Of an inertia tensor about the centre of mass. A body of its own needs a regular one; a small
/// mass on a beam may have none.
enum class MayBeZero { no, yes };
Fault find_inertia_fault(const std::string& key, const Tensor& inertia, MayBeZero may_be_zero);
/// Of a curve of this quantity over time.
Fault find_curve_fault(const std::string& key, const Curve& curve, const Quantity& quantity);
/// Of a name that is needed.
Fault find_name_fault(const std::string& name);
/// "is \"NAME\", expected ...", with the nearest of the names there are.
std::string describe_unknown(const std::string& name, const std::vector<std::string_view>& names);

/// Of sections of a beam of this length.
Fault find_fault(const Sections& sections, double length);
Fault find_fault(const Beam& beam);
Fault find_fault(const RigidBody& body);
Fault find_fault(const Joint& joint);
Fault find_fault(const Blade& blade);
Fault find_fault(const Subsystem& subsystem);
Fault find_fault(const Hub& hub);
/// Of a load on a model that is fine by itself.
Fault find_fault(const PointLoad& load, const Model& model);
Fault find_fault(const DistributedLoad& load, const Model& model);
Fault find_fault(const HubLoad& load, const Model& model);

/// Of the sizes of all blades and subsystems together.
std::string find_size_fault(const Model& model);
/// Of damping.mass_factor, if it is fine by itself.
std::string find_mass_factor_fault(const Model& model);

}  // namespace spoke::spatial
