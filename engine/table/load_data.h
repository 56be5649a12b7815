#pragma once

// Loads as they act on the subsystems: the user's own, those of the scenario, and those of air.

#include <exception>
#include <memory>
#include <vector>

#include "engine/air/blade_air.h"
#include "engine/body/body_types.h"
#include "engine/load.h"
#include "engine/space/handle_motion.h"
#include "engine/space/section_loads.h"
#include "engine/support/page_arena.h"
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

/// A load, and the markers that it asked for.
struct AskedLoad {
  std::shared_ptr<const Load> load;
  std::vector<Marker> markers;
};

template <class World>
struct LoadData {
  int number = 0;  ///< in the list that it was given in
  std::shared_ptr<const Load> load;
  std::vector<Marker> given;
  std::vector<int> subsystems;  ///< those of the markers, each once, ascending
  std::vector<PlacedMarker<World>> markers;
  ArenaVector<SectionWrench<World>> wrenches;  ///< by marker
  // Arguments and results of the load: rewritten at every evaluation, no part of the table.
  std::vector<MarkerMotion> motions;
  std::vector<Wrench> forces;
  std::exception_ptr thrown;  ///< exception of the load, since it was last cleared
};

/// A wrench of a load on a section of the body that it is listed with.
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

/// What air does to the hub of a rotor. Part of the table: doubles only.
struct AirSum {
  double thrust = 0.0;  ///< along the axis [N]
  double torque = 0.0;  ///< about the axis [N m]
  double wind = 0.0;    ///< wind at the hub against it, along the axis [m/s]
};

/// Air on a blade: its markers are the stations.
template <class World>
struct AirData {
  std::shared_ptr<const air::BladeAir> blade;
  std::vector<PlacedMarker<World>> markers;
  ArenaVector<SectionWrench<World>> wrenches;  ///< by marker
  ArenaVector<air::StationAir> stations;       ///< by marker: what the evaluation has found
  /// States of inflow and stall at the end of the last step, and whether there are any yet, 0 or 1:
  /// before, air is in equilibrium.
  ArenaVector<double> states;
  ArenaVector<double> reached;  ///< states at the evaluated time
  AirSum sum;                   ///< over the stations
  // Arguments and results of the kernel: rewritten at every evaluation, no part of the table.
  std::vector<MarkerMotion> motions;
  std::vector<space::HandleMotion> sections;  ///< their motion against the frames of their bodies
  std::vector<Eigen::Vector3d> winds;
  std::vector<Wrench> forces;
};

}  // namespace spoke
