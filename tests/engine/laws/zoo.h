#pragma once

// One list of models for the laws that all models obey: every shipped scenario, and variations that
// join what these have apart. A scenario that is shipped joins by itself.

#include <functional>
#include <string>
#include <vector>

#include "engine/formulation.h"
#include "models/scenario.h"
#include "models/system/spatial_system.h"

namespace spoke::test {

/// A model of the zoo.
struct ZooModel {
  std::string name;                       ///< of the shipped scenario, and how it varies
  std::string file;                       ///< name of the shipped scenario
  std::function<void(Scenario&)> vary{};  ///< none: as it is

  /// Reads the scenario; it ends after `steps` steps.
  Scenario read(int steps) const;
};

/// Returns all models, by name. Not among them is large_rotor, which is paper_rotor of another
/// size.
std::vector<ZooModel> list_zoo();

/// Returns the formulations in which a model of so many coordinates makes a step in a moment: large
/// dense matrices take long.
inline std::vector<Formulation> quick_formulations(int coordinates) {
  std::vector<Formulation> list{Formulation::structured};
  if (coordinates <= 600) list.push_back(Formulation::subsystem);
  if (coordinates <= 200) list.push_back(Formulation::augmented);
  return list;
}

/// Calls `apply` with the system of a scenario, in the plane or in space, and the time step [s].
template <class Apply>
void on_system(const Scenario& scenario, Apply&& apply) {
  if (scenario.space)
    apply(make_system(*scenario.space), scenario.integration.step);
  else
    apply(make_system(scenario.rotor), scenario.integration.step);
}

}  // namespace spoke::test
