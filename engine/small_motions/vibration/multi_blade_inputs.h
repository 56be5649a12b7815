#pragma once

// What loads and motors do to a rotor that is seen from outside.

#include <string>
#include <vector>

#include "engine/equilibrium.h"
#include "engine/linearize.h"
#include "engine/small_motions/steady/load_effects.h"
#include "engine/small_motions/vibration/mode_parts.h"
#include "engine/small_motions/vibration/multi_blade.h"

namespace spoke::vibration {

/// An input that all blades of a family have alike: what raising it by one on one blade does there,
/// by the azimuth of the blade. Matrices have one column. Of a shaft all is along standing axes.
struct BladeInput {
  LinearSignal input;  ///< "blades 1 to 3 / load.1"
  Turning force;       ///< on the independent coordinates of the blade
  Turning hub;         ///< on the hub, all components, along axes that are turned with the blade
  /// On what the blade shows, vectors along the same axes; where loops tie it to others on what
  /// each blade further on in their ring shows, along axes that are turned with that one.
  std::vector<Turning> outputs;
};

/// An input whose effect stands.
struct StandingInput {
  LinearSignal input;
  std::size_t rotor;           ///< on whose hub it acts
  Eigen::VectorXd hub;         ///< on that hub, all components, along standing axes
  steady::LoadEffect support;  ///< on the support, whose base is its hub; empty: nothing
};

struct MultiBladeInputs {
  std::vector<std::vector<BladeInput>> families;  ///< by family of the frame
  std::vector<StandingInput> standing;
  /// Inputs that neither stand nor are alike on all blades of a family.
  std::vector<std::string> left_out;
};

/// Finds the effects of all loads and motors of a scenario. `T`: the axes of any hub by its azimuth
/// (StandingAxes), for all components of a twist.
MultiBladeInputs find_inputs(const Scenario& scenario, const Linearised& all,
                             const FixedFrame& frame, const Turning& T);

/// Returns the name of a family: "blades 1 to 3".
std::string name_family(const BladeFamily& family, const steady::SteadyModel& model);

/// Returns how the components of the motion of its hub, the columns, move the coordinates of a
/// subsystem that its loops let follow; empty: none do. Precondition: it is on a rotor.
Eigen::MatrixXd find_following(std::size_t subsystem, const Linearised& all);

}  // namespace spoke::vibration
