// Names of choices, and the sizes of closures.

#include "models/loop.h"

namespace spoke {

int count_locked(LoopKind kind) {
  switch (kind) {
    case LoopKind::fixed:
      return 6;
    case LoopKind::revolute:
    case LoopKind::prismatic:
      return 5;
    case LoopKind::universal:
    case LoopKind::cylindrical:
      return 4;
    case LoopKind::spherical:
      return 3;
    case LoopKind::bearing:
      return 2;
    case LoopKind::distance:
      break;
  }
  return 1;
}

int count_locked_in_plane(LoopKind kind) {
  switch (kind) {
    case LoopKind::fixed:
      return 3;
    case LoopKind::revolute:
    case LoopKind::prismatic:
      return 2;
    case LoopKind::distance:
      return 1;
    case LoopKind::universal:
    case LoopKind::spherical:
    case LoopKind::cylindrical:
    case LoopKind::bearing:
      break;
  }
  return 0;
}

int count_axes(LoopKind kind) {
  switch (kind) {
    case LoopKind::universal:
      return 2;
    case LoopKind::revolute:
    case LoopKind::prismatic:
    case LoopKind::cylindrical:
    case LoopKind::bearing:
      return 1;
    case LoopKind::fixed:
    case LoopKind::spherical:
    case LoopKind::distance:
      break;
  }
  return 0;
}

std::string_view name_of(LoopKind kind) {
  switch (kind) {
    case LoopKind::fixed:
      return "fixed";
    case LoopKind::revolute:
      return "revolute";
    case LoopKind::prismatic:
      return "prismatic";
    case LoopKind::universal:
      return "universal";
    case LoopKind::spherical:
      return "spherical";
    case LoopKind::cylindrical:
      return "cylindrical";
    case LoopKind::bearing:
      return "bearing";
    case LoopKind::distance:
      break;
  }
  return "distance";
}

std::string_view name_of(Anchor::Frame frame) {
  if (frame == Anchor::Frame::axle) return "axle";
  if (frame == Anchor::Frame::body) return "body";
  return frame == Anchor::Frame::hub ? "hub" : "mount";
}

}  // namespace spoke
