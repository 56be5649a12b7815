#pragma once

// The controller of [control.turbine]: torque, pitch and yaw of a wind turbine, below and above
// rated (models/turbine_control.h has the laws).

#include <memory>
#include <vector>

#include "engine/controller.h"
#include "models/turbine_control.h"
#include "spoke/export.h"

namespace spoke {

/// Makes the controller of laws. `initial`: pitch angle at the start [rad]; `azimuths`: of the
/// blades on the hub, in the sense of rotation, in the order of ControlRecord::blades [rad].
SPOKE_EXPORT std::shared_ptr<Controller> make_turbine_controller(TurbineLaws laws, double initial,
                                                                 std::vector<double> azimuths);

}  // namespace spoke
