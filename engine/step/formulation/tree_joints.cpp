// Calculates the power of the drives of joints in space.

#include "engine/step/formulation/tree_joints.h"

#include "engine/bodies/kernels/space/table_terms.h"

namespace spoke {

void report_drives(std::size_t j, SubsystemData<Space>& data) noexcept {
  BodyData<Space>& body = data.bodies[j];
  body.report.drive_power = calc_drive_power(body.model->joint.joint, joint_state_of(body),
                                             data.joints[j], data.wrenches[j].inboard);
}

}  // namespace spoke
