// Looks through the joints of all trees.

#include "engine/small_motions/steady/relaxing_joints.h"

#include "models/error.h"
#include "models/tree/tree.h"

namespace spoke::steady {
namespace {

[[noreturn]] void refuse(const spatial::Tree& tree, const spatial::TreeBody& body) {
  const std::string& name = body.joint.name;
  throw InputError(tree.name + " / joint " + (name.empty() ? "of " + body.name : name) +
                   ": has a relaxation, of which linear models of small motions know nothing, as "
                   "they have no states of forces; expected none, or at high frequencies its "
                   "stiffness as that of the joint, at low ones stiffness times time as damping");
}

}  // namespace

void refuse_relaxation(const Scenario& scenario) {
  if (!scenario.space) return;
  for (const spatial::Tree& tree : build_trees(*scenario.space))
    for (const spatial::TreeBody& body : tree.bodies)
      for (const spatial::JointCoordinate& coordinate : body.joint.coordinates)
        if (coordinate.relaxation) refuse(tree, body);
}

}  // namespace spoke::steady
