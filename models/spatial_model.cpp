// Names of choices, and the sizes of joints.

#include "models/spatial_model.h"

namespace spoke::spatial {

int count_coordinates(JointKind kind) {
  switch (kind) {
    case JointKind::fixed:
      return 0;
    case JointKind::revolute:
    case JointKind::prismatic:
      return 1;
    case JointKind::universal:
    case JointKind::cylindrical:
      return 2;
    case JointKind::spherical:
      break;
  }
  return 3;
}

int count_axes(JointKind kind) {
  if (kind == JointKind::universal) return 2;
  return kind == JointKind::fixed || kind == JointKind::spherical ? 0 : 1;
}

std::string_view name_of(JointKind kind) {
  switch (kind) {
    case JointKind::fixed:
      return "fixed";
    case JointKind::revolute:
      return "revolute";
    case JointKind::universal:
      return "universal";
    case JointKind::spherical:
      return "spherical";
    case JointKind::prismatic:
      return "prismatic";
    case JointKind::cylindrical:
      break;
  }
  return "cylindrical";
}

std::string_view name_of(LoadFrame frame) {
  switch (frame) {
    case LoadFrame::inertial:
      return "inertial";
    case LoadFrame::hub:
      return "hub";
    case LoadFrame::body:
      return "body";
    case LoadFrame::section:
      break;
  }
  return "section";
}

}  // namespace spoke::spatial
