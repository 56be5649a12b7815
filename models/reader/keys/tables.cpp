// The list of all tables: which rows each has, in the order of messages.

#include "models/reader/keys/tables.h"

#include "models/air/wind_keys.h"
#include "models/reader/keys/air_keys.h"
#include "models/reader/keys/beam_keys.h"
#include "models/reader/keys/blade_keys.h"
#include "models/reader/keys/control_keys.h"
#include "models/reader/keys/event_keys.h"
#include "models/reader/keys/hub_keys.h"
#include "models/reader/keys/joint_keys.h"
#include "models/reader/keys/load_keys.h"
#include "models/reader/keys/loop_keys.h"
#include "models/reader/keys/scenario_keys.h"
#include "models/reader/keys/simulation_keys.h"
#include "models/reader/keys/solid_keys.h"
#include "models/reader/keys/tree_keys.h"
#include "models/reader/keys/turbine_keys.h"

namespace spoke::keys {
namespace {

constexpr bool kConditional = true;

void add_hub(std::vector<Table>& all) {
  constexpr std::string_view kDrive = "[hub.drive]", kKind = "belongs to kind";
  all.push_back({"hub", {{"[hub]", kHubRows}}});
  all.push_back({"hub", {{"[hub] in space", kSpaceHubRows}}});
  all.push_back({"hub.drive",
                 {{kDrive, kDriveKindRows, false, kKind},
                  {kDrive, kSpinUpRows, kConditional, kKind},
                  {kDrive, kSpinUpHoldSpinDownRows, kConditional, kKind},
                  {kDrive, kTorqueDriveRows, kConditional, kKind},
                  {kDrive, kSpeedTableRows, kConditional, kKind},
                  {kDrive, kConstantSpeedRows, kConditional, kKind},
                  {kDrive, kTorqueBySpeedRows, kConditional, kKind},
                  {kDrive, kFreeDriveRows, kConditional, kKind}}});
  all.push_back({"hub.mount", {{"[hub.mount]", kMountRows}}});
  all.push_back({"hub.suspension", {{"[hub.suspension]", kSuspensionRows}}});
  all.push_back({"course", {{"courses", kCourseRows}}});
}

void add_blades(std::vector<Table>& all) {
  const Part beam{"beams in space", kBeamRows, kConditional};
  const Part blade{"[blade] in space", kSpaceBladeRows};
  constexpr std::string_view kSections = "[blade.sections] in space";
  all.push_back({"blade", {{"[blade]", kBladeRows, kConditional}, {"[blade]", kBladeCountRows}}});
  all.push_back({"blade", {beam, blade, {"[blade]", kBladeCountRows}}});
  all.push_back({"blades", {{"[blade]", kBladeRows, kConditional}}});
  all.push_back({"blades", {beam, blade}});
  all.push_back({"blade.sections", {{"[blade.sections]", kBladeSectionsRows}}});
  all.push_back({"blade.point_mass", {{"[[blade.point_mass]]", kPointMassRows}}});
  all.push_back({"beam.sections",
                 {{kSections, kSectionRows},
                  {kSections, kStiffnessRows},
                  {kSections, kShearStiffnessRows},
                  {kSections, kSectionInertiaRows},
                  {kSections, kSectionMatrixRows},
                  {kSections, kSectionShapeRows}}});
  all.push_back({"beam.point_mass", {{"[[blade.point_mass]] in space", kSpacePointMassRows}}});
  all.push_back({"blade.aerodynamics", {{"[blade.aerodynamics]", kBladeAerodynamicsRows}}});
}

void add_joints(std::vector<Table>& all) {
  const Part joint{"joints", kJointRows};
  all.push_back({"blade.joint", {joint, {"[[blade.joint]]", kJointStationRows}}});
  all.push_back({"subsystem.joint", {joint, {"[[subsystem.joint]]", kSubsystemJointRows}}});
  all.push_back({"joint.relaxation", {{"relaxations", kRelaxationRows}}});
  all.push_back({"joint.stop", {{"stops", kStopRows}}});
  all.push_back({"joint.friction", {{"frictions", kFrictionRows}}});
  all.push_back({"joint.motion", {{"motions", kMotionRows}}});
  all.push_back({"joint.effort", {{"efforts", kEffortRows}}});
  all.push_back({"loop", {{"loops", kLoopRows}}});
  all.push_back({"loop", {{"loops in space", kSpaceLoopRows}}});
  all.push_back({"place", {{"places", kPlaceRows}}});
  all.push_back({"place", {{"places in space", kSpacePlaceRows}}});
  all.push_back({"anchor", {{"[[anchor]]", kAnchorRows}}});
  all.push_back({"anchor.motion", {{"motion of anchors", kAnchorMotionRows}}});
}

void add_trees(std::vector<Table>& all) {
  const Part tree{"trees", kTreeRows};
  all.push_back({"subsystem.body.drag", {{"drag of bodies", kBodyDragRows}}});
  all.push_back({"coupling", {{"couplings", kCouplingRows}}});
  all.push_back({"coupling.joints", {{"coupled joints", kCoupledJointRows}}});
  all.push_back({"subsystem", {{"[[subsystem]]", kSubsystemRows}, tree}});
  all.push_back({"subsystem.body",
                 {{"beams in space", kBeamRows, kConditional},
                  {"[[subsystem.body]]", kBodyRows},
                  {"rigid bodies", kRigidBodyRows, kConditional},
                  {"solids", kSolidRows, kConditional}}});
  all.push_back({"support",
                 {{"[support]", kSupportRows},
                  {"fuselages", kFuselageRows, kConditional},
                  tree,
                  {"[support]", kSupportAxleRows}}});
  all.push_back(
      {"support.axle", {{"[support.axle]", kAxleRows}, {"drive trains", kDriveTrainRows}}});
  all.push_back({"rotor", {{"[[rotor]]", kRotorRows}}});
  all.push_back({"subsystem.body.material", {{"materials", kMaterialRows}}});
  all.push_back({"subsystem.body.scale", {{"scales", kScaleRows}}});
  all.push_back({"subsystem.body.interface", {{"interfaces", kInterfaceRows}}});
  all.push_back(
      {"subsystem.body.geometric_stiffness", {{"geometric stiffness", kGeometricStiffnessRows}}});
  all.push_back({"nodes", {{"nodes", kNodesRows}}});
  all.push_back({"nodes.plane", {{"nodes at a plane", kPlaneNodesRows}}});
  all.push_back({"nodes.cylinder", {{"nodes at a cylinder", kCylinderNodesRows}}});
  all.push_back({"nodes.box", {{"nodes in a box", kBoxNodesRows}}});
}

template <class L>
Part course() {
  return {"loads", kLoadCourseRows<L>};
}

void add_loads(std::vector<Table>& all) {
  const Part blade{"loads", kLoadedBladeRows}, name{"loads", kLoadNameRows};
  const Part place{"loads in space", kLoadPlaceRows};
  all.push_back({"gravity", {{"[gravity]", kGravityRows}}});
  all.push_back({"gravity", {{"[gravity] in space", kSpaceGravityRows}}});
  all.push_back({"damping",
                 {{"[damping]", kDampingRows, false, "damping ratio"},
                  {"[damping] of beams", kBeamDampingRows, false, "damping ratio"}}});
  all.push_back({"load", {{"[[load]]", kPointLoadRows}, blade, name, course<PointLoad>()}});
  all.push_back(
      {"load",
       {place, {"[[load]] in space", kSpacePointLoadRows}, name, course<spatial::PointLoad>()}});
  all.push_back(
      {"distributed_load",
       {{"[[distributed_load]]", kDistributedLoadRows}, blade, name, course<DistributedLoad>()}});
  all.push_back({"distributed_load",
                 {place,
                  {"[[distributed_load]] in space", kSpaceDistributedLoadRows},
                  name,
                  course<spatial::DistributedLoad>()}});
  all.push_back({"drag", {{"[[drag]]", kDragRows}, blade, name, course<Drag>()}});
  all.push_back({"hub_load", {name, {"[[hub_load]]", kHubLoadRows}, course<HubLoad>()}});
  all.push_back({"hub_load",
                 {{"[[hub_load]] in space", kSpaceHubLoadRows}, name, course<spatial::HubLoad>()}});
}

void add_air(std::vector<Table>& all) {
  all.push_back({"control", {{"[control]", kControlRows}}});
  all.push_back({"control.pitch", {{"[control.pitch]", kPitchControlRows}}});
  all.push_back({"control.library",
                 {{"[control.library]", kLibraryRows}, {"controllers", kOuterControlRows}}});
  all.push_back({"control.library.record", {{"[[control.library.record]]", kLibraryRecordRows}}});
  all.push_back({"control.program", {{"controllers", kOuterControlRows}}});
  all.push_back({"control.pitch.schedule", {{"schedules", kScheduleRows}}});
  all.push_back(
      {"control.turbine", {{"controllers", kOuterControlRows}, {"laws of turbines", kLawRows}}});
  all.push_back({"control.turbine.filter", {{"laws of turbines: filter", kSpeedFilterRows}}});
  all.push_back({"control.turbine.torque", {{"laws of turbines: torque", kTorqueLawRows}}});
  all.push_back({"control.turbine.pitch", {{"laws of turbines: pitch", kPitchLawRows}}});
  all.push_back({"control.turbine.schedule", {{"laws of turbines: schedule", kPitchScheduleRows}}});
  all.push_back({"control.turbine.smoothing", {{"laws of turbines: smoothing", kSmoothingRows}}});
  all.push_back(
      {"control.turbine.individual", {{"laws of turbines: individual", kIndividualRows}}});
  all.push_back({"control.turbine.actuator", {{"laws of turbines: actuator", kActuatorRows}}});
  all.push_back({"control.turbine.yaw", {{"laws of turbines: yaw", kYawLawRows}}});
  all.push_back({"event", {{"[[event]]", kEventRows}}});
  all.push_back(
      {"event.pitch", {{"turns of events", kEventYawRows}, {"pitch of events", kEventPitchRows}}});
  all.push_back({"event.yaw", {{"turns of events", kEventYawRows}}});
  all.push_back({"air", {{"[air]", kAirRows}}});
  all.push_back({"wind", {{"[wind]", kWindRows}}});
  all.push_back({"wind.gust", {{"[wind.gust]", kGustRows}}});
  all.push_back({"wind.iec", {{"[wind.iec]", kIecRows}}});
  all.push_back({"wind.turbulence", {{"[wind.turbulence]", kTurbulenceRows}}});
  all.push_back({"aerodynamics", {{"[aerodynamics]", kAerodynamicsRows}}});
  all.push_back(
      {"airfoil", {{"[[airfoil]]", kAirfoilRows}, {"[[airfoil]]", kPolarRows, kConditional}}});
  all.push_back({"airfoil.polar", {{"[[airfoil]]", kPolarRows}}});
}

void add_simulation(std::vector<Table>& all) {
  all.push_back({"initial", {{"[initial]", kInitialRows}}});
  all.push_back({"integration", {{"[integration]", kIntegrationRows}}});
  all.push_back({"limits", {{"[limits]", kLimitsRows}}});
  all.push_back({"output", {{"[output]", kOutputRows}}});
  all.push_back({"statistics", {{"[statistics]", kStatisticsRows}}});
  all.push_back({"sensor", {{"[[sensor]]", kSensorRows}}});
  all.push_back({"sensor", {{"[[sensor]] in space", kSpaceSensorRows}}});
}

}  // namespace

const std::vector<Table>& tables() {
  static const std::vector<Table> kAll = [] {
    std::vector<Table> all{{"", {{"top level", kScenarioRows}}}};
    add_hub(all);
    add_blades(all);
    add_joints(all);
    add_trees(all);
    add_loads(all);
    add_air(all);
    add_simulation(all);
    return all;
  }();
  return kAll;
}

}  // namespace spoke::keys
