#pragma once

// Rules for couplings of joints.

#include <map>
#include <string>
#include <vector>

#include "models/reader/spatial/fault.h"
#include "models/spatial_model.h"

namespace spoke::spatial {

/// A joint that couplings may name.
struct CouplingEnd {
  JointKind kind = JointKind::fixed;
  std::vector<bool> is_free{};  ///< by coordinate
};

/// Joints by their names.
using CouplingEnds = std::map<std::string, CouplingEnd, std::less<>>;

/// Returns the joints of a blade that have names, and the axles of the rotors that it carries.
CouplingEnds ends_of(const Blade& blade, const std::vector<int>& rotors, const Model& model);
/// Returns those of a subsystem; with the axles that it carries.
CouplingEnds ends_of(const Subsystem& subsystem, const Model& model);

/// Finds a fault of couplings of joints that have none. Of joints elsewhere nothing is known yet.
Fault find_fault(const std::vector<Coupling>& couplings, const CouplingEnds& ends);
/// Finds the first fault of those couplings of a model that have joints on several blades or
/// subsystems, "blades.2.coupling.1.joints.2.joint".
Fault find_coupling_across_fault(const Model& model);

}  // namespace spoke::spatial
