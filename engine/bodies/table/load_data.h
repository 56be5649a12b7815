#pragma once

// Loads as they act on bodies: wrenches of actors, and the loads of the scenario.

#include <vector>

#include "engine/bodies/body_types.h"
#include "engine/bodies/space/handle_motion.h"
#include "engine/bodies/space/section_loads.h"
#include "models/system/system.h"

namespace spoke {

/// A wrench on a body's section, in the body frame. Part of the table: doubles only.
template <class World>
struct SectionWrench {
  PositionOf<World> force = PositionOf<World>::Zero();  ///< [N]
  AngularOf<World> moment{};                            ///< [N m]
};

/// A marker on its body.
template <class World>
struct PlacedMarker {
  int subsystem = 0;
  int body = 0;
  typename BodyTypes<World>::Section section;
};

/// A wrench of an actor on a section of the body that it is listed with.
template <class World>
struct AppliedWrench {
  const typename BodyTypes<World>::Section* section = nullptr;
  const SectionWrench<World>* wrench = nullptr;
};

/// On a spatial body, with the motion of the section against the frame of its body at the state of
/// the wrench; null: it is found when the wrench is applied.
template <>
struct AppliedWrench<Space> {
  const space::Section* section = nullptr;
  const SectionWrench<Space>* wrench = nullptr;
  const space::HandleMotion* motion = nullptr;
};

/// A load of the scenario on a body (BodyLoad, BodyDrag), with the section at each of its points.
template <class World, class Load>
struct PlacedLoad {
  const Load* load = nullptr;
  std::vector<typename BodyTypes<World>::Section> sections;
};

/// A load on a spatial body; on a rigid one it acts at the places of its points, on a solid at
/// `places`.
template <>
struct PlacedLoad<Space, BodyLoad<Space>> {
  const BodyLoad<Space>* load = nullptr;
  std::vector<space::LoadedSections> sections;
  std::vector<space::Section> places;
};

}  // namespace spoke
