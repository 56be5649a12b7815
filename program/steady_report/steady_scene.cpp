// Describes equilibria by displacements of a scene's nodes, and modes by shapes of complex numbers.

#include "program/steady_report/steady_scene.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/bodies/space/solid_output.h"
#include "engine/output/scene/carriers.h"
#include "engine/output/scene/make_scene.h"
#include "models/tree/tree.h"
#include "program/run_report/base64.h"
#include "program/run_report/scene_data.h"
#include "program/steady_report/mode_files.h"

namespace spoke::steady_report {
namespace {

using Eigen::Vector3cd;
using Eigen::Vector3d;

void append(const Vector3d& v, std::vector<float>& numbers) {
  for (const double x : v) numbers.push_back(static_cast<float>(x));
}

/// Returns the larger of `largest` and the magnitudes of components.
double larger(double largest, const Vector3cd& v) {
  return std::max(largest, v.cwiseAbs().maxCoeff());
}

/// Appends components as fractions of `unit`, real parts first.
void append(const Vector3cd& v, double unit, std::vector<std::int16_t>& numbers) {
  const auto share = [unit](double x) {
    return static_cast<std::int16_t>(unit > 0.0 ? std::lround(x / unit) : 0);
  };
  for (const std::complex<double>& x : v) numbers.push_back(share(x.real()));
  for (const std::complex<double>& x : v) numbers.push_back(share(x.imag()));
}

/// `to_hub`: from the axes of the motion to those of the drawn hub.
Json hub_json(const HubShape& hub, const Eigen::Matrix3d& to_hub) {
  Json real = Json::array(), imag = Json::array();
  for (const Vector3cd& v :
       {Vector3cd(to_hub * hub.displacement), Vector3cd(to_hub * hub.rotation)})
    for (const std::complex<double>& x : v) {
      real.push_back(x.real());
      imag.push_back(x.imag());
    }
  return {{"real", real}, {"imag", imag}};
}

/// A node's motion in a mode, relative to the hub.
struct NodeShape {
  Vector3cd displacement, rotation;
};

/// Returns the constants of the solids of an equilibrium.
scene::SolidsInTrees solids_of(const EquilibriumResult& result) {
  scene::SolidsInTrees all;
  for (const BladeEquilibrium& blade : result.blades) {
    auto& own = all.emplace_back();
    for (const SolidDeformation& solid : blade.solids) {
      own.resize(std::max(own.size(), static_cast<std::size_t>(solid.body) + 1));
      own[static_cast<std::size_t>(solid.body)] = solid.solid;
    }
  }
  return all;
}

/// Returns the place of a body among the solids of a blade.
std::size_t place_of(const scene::MeshBody& mesh, const BladeEquilibrium& blade) {
  const auto found =
      std::find_if(blade.solids.begin(), blade.solids.end(),
                   [&mesh](const SolidDeformation& solid) { return solid.body == mesh.body; });
  return static_cast<std::size_t>(found - blade.solids.begin());
}

/// The motion of a solid's numbers in a mode: real parts, then imaginary ones.
struct SolidMotion {
  std::vector<double> numbers;
  double largest = 0.0;  ///< displacement of a drawn node, relative to its frame [m]
};

SolidMotion calc_motion(const scene::Surface& surface, const Eigen::VectorXcd& q) {
  SolidMotion motion;
  if (!surface.recovery || q.size() == 0) return motion;
  const space::NodeRecovery& recovery = *surface.recovery;
  for (const Eigen::VectorXd& part : {Eigen::VectorXd(q.real()), Eigen::VectorXd(q.imag())}) {
    if (recovery.is_reduced())
      motion.numbers.insert(motion.numbers.end(), part.begin(), part.end());
    for (int k = 0; k < recovery.size(); ++k) {
      const Vector3d u = recovery.displacement(k, part.data());
      motion.largest = std::max(motion.largest, u.norm());
      if (!recovery.is_reduced()) motion.numbers.insert(motion.numbers.end(), u.begin(), u.end());
    }
  }
  return motion;
}

Json describe_motion(const SolidMotion& motion) {
  constexpr double kMost = std::numeric_limits<std::int16_t>::max();
  double largest = 0.0;
  for (const double number : motion.numbers) largest = std::max(largest, std::abs(number));
  const double unit = largest > 0.0 ? largest / kMost : 1.0;
  std::vector<std::int16_t> shares;
  for (const double number : motion.numbers)
    shares.push_back(static_cast<std::int16_t>(std::lround(number / unit)));
  return {{"unit", unit}, {"shares", run_report::encode(shares)}};
}

}  // namespace

SteadyScene::SteadyScene(const Scenario& scenario, const EquilibriumResult& result,
                         std::size_t most_nodes)
    : scene_(scene::make_scene(scenario, most_nodes, solids_of(result))),
      to_hub_(scenario.space ? Eigen::Matrix3d(rotor_placement(scenario.space->hub).rotation)
                             : Eigen::Matrix3d(Eigen::Matrix3d::Identity())),
      first_(make_first_frame(scenario, scene_).groups) {
  for (const scene::NodeSource& source : scene_.sources) {
    const std::vector<int>& bodies =
        result.blades[static_cast<std::size_t>(source.subsystem)].bodies;
    const auto first = std::find(bodies.begin(), bodies.end(), source.body);
    places_.push_back(static_cast<std::size_t>(first - bodies.begin() + source.node));
  }
  put_anchors(scenario, result);
}

spatial::Placement SteadyScene::to_drawn(int subsystem, const EquilibriumResult& result) const {
  if (subsystem == scene_.support) return {};
  const auto rotor =
      static_cast<std::size_t>(result.blades[static_cast<std::size_t>(subsystem)].rotor);
  if (rotor == 0) return {Vector3d::Zero(), to_hub_};
  const HubPlace& hub = result.rotors[rotor].hub;
  return {hub.position, hub.axes};
}

/// Puts anchors where the equilibrium has them.
void SteadyScene::put_anchors(const Scenario& scenario, const EquilibriumResult& result) {
  const std::vector<Anchor>& anchors =
      scenario.space ? scenario.space->anchors : scenario.rotor.anchors;
  for (const scene::Carrier& carrier : scene_.carriers) {
    if (carrier.anchor < 0) continue;
    const Anchor& anchor = anchors[static_cast<std::size_t>(carrier.anchor)];
    spatial::Vector axis = spatial::Vector::UnitZ();
    if (scenario.space) axis = hub_of(*scenario.space, anchor.rotor).axis.normalized();
    const double speed = result.rotors.empty()
                             ? result.speed
                             : result.rotors[static_cast<std::size_t>(anchor.rotor)].speed;
    const bool is_averaged = anchor.turns_with_hub && speed != 0.0;
    spatial::Placement& place = first_[static_cast<std::size_t>(carrier.group)];
    const spatial::Placement last = scene::calc_last_place(anchor, is_averaged ? &axis : nullptr);
    place = anchor.frame == Anchor::Frame::body
                ? place * inverse(scene::calc_first_place(anchor)) * last
                : last;
  }
}

Json SteadyScene::describe() const { return run_report::describe_scene(scene_); }

Json SteadyScene::describe(const EquilibriumResult& result) const {
  std::vector<spatial::Placement> motions(static_cast<std::size_t>(scene_.groups));
  for (std::size_t r = 1; r < result.rotors.size(); ++r) {
    const HubPlace& hub = result.rotors[r].hub;
    motions[static_cast<std::size_t>(scene_.hubs[r].group)] = {
        hub.position, hub.axes * scene_.hubs[r].to_hub.transpose()};
  }
  for (const scene::Carrier& carrier : scene_.carriers) {
    const auto g = static_cast<std::size_t>(carrier.group);
    const auto hub = static_cast<std::size_t>(scene::group_of_hub(scene_, carrier));
    motions[g] = hub == 0 ? first_[g] : motions[hub] * first_[g];
  }
  std::vector<float> displacements(3 * scene_.nodes.size()), rotations = displacements, groups;
  if (!result.blades.empty()) {
    displacements.clear();
    rotations.clear();
    for (std::size_t k = 0; k < scene_.nodes.size(); ++k) {
      const BladeEquilibrium& blade =
          result.blades[static_cast<std::size_t>(scene_.sources[k].subsystem)];
      const std::size_t at = places_[k];
      const spatial::Placement drawn_in = to_drawn(scene_.sources[k].subsystem, result);
      const Eigen::Matrix3d& turn = drawn_in.rotation;
      append(turn * (blade.nodes[at] - blade.undeformed[at]), displacements);
      append(turn * blade.rotations[at], rotations);
      // All nodes of a rigid body show its motion.
      const scene::Node& drawn = scene_.nodes[k];
      if (drawn.group == 0) continue;
      spatial::Placement& motion = motions[static_cast<std::size_t>(drawn.group)];
      motion.rotation = turn * blade.undeformed_axes[at] * drawn.axes.transpose();
      motion.position = drawn_in.position + turn * blade.undeformed[at] - motion.rotation * drawn.p;
    }
  }
  for (std::size_t g = 1; g < motions.size(); ++g) run_report::append_pose(motions[g], groups);
  Json solids = Json::array();
  for (const scene::MeshBody& mesh : scene_.meshes) {
    std::vector<float> numbers;
    if (!result.blades.empty()) {
      const BladeEquilibrium& blade = result.blades[static_cast<std::size_t>(mesh.subsystem)];
      run_report::append_numbers(scene_.surfaces[static_cast<std::size_t>(mesh.surface)],
                                 blade.solids[place_of(mesh, blade)].coordinates, numbers);
    }
    solids.push_back(run_report::encode(numbers));
  }
  Json described = {{"speed", result.speed},
                    {"groups", run_report::encode(groups)},
                    {"displacements", run_report::encode(displacements)},
                    {"rotations", run_report::encode(rotations)},
                    {"solids", solids}};
  if (result.hub) {
    std::vector<float> hub;
    run_report::append_pose({result.hub->position, result.hub->axes * to_hub_.transpose()}, hub);
    described.set("hub", std::vector<double>(hub.begin(), hub.end()));
  }
  return described;
}

/// Returns the motion of the hub that carries a subsystem, with which its nodes go; none of a
/// support.
HubShape SteadyScene::find_carrier(int subsystem, const Mode& mode,
                                   const EquilibriumResult& result) const {
  if (subsystem == scene_.support) return {};
  if (mode.hubs.empty()) return {mode.hub_displacement, mode.hub_rotation};
  return mode
      .hubs[static_cast<std::size_t>(result.blades[static_cast<std::size_t>(subsystem)].rotor)];
}

Json SteadyScene::describe(const Mode& mode, const EquilibriumResult& result) const {
  std::vector<NodeShape> shapes;
  std::size_t first = 0;
  double displacement = 0.0, rotation = 0.0, solid_displacement = 0.0;
  for (std::size_t k = 0; k < scene_.nodes.size(); ++k) {
    const auto tree = static_cast<std::size_t>(scene_.sources[k].subsystem);
    if (mode.shape[tree].empty()) continue;
    if (shapes.empty()) first = k;
    const std::size_t at = places_[k];
    const Vector3cd p = result.blades[tree].nodes[at].cast<std::complex<double>>();
    const HubShape hub = find_carrier(static_cast<int>(tree), mode, result);
    const Vector3cd carried = hub.displacement + hub.rotation.cross(p);
    const Eigen::Matrix3d drawn = to_drawn(static_cast<int>(tree), result).rotation;
    shapes.push_back({drawn * (mode.shape[tree][at] - carried),
                      drawn * (mode.rotations[tree][at] - hub.rotation)});
    displacement = larger(displacement, shapes.back().displacement);
    rotation = larger(rotation, shapes.back().rotation);
  }
  Json solids = Json::array();
  for (const scene::MeshBody& mesh : scene_.meshes) {
    const auto tree = static_cast<std::size_t>(mesh.subsystem);
    const bool moves = tree < mode.solids.size() && !mode.solids[tree].empty();
    const SolidMotion motion = calc_motion(
        scene_.surfaces[static_cast<std::size_t>(mesh.surface)],
        moves ? mode.solids[tree][place_of(mesh, result.blades[tree])] : Eigen::VectorXcd());
    solids.push_back(describe_motion(motion));
    solid_displacement = std::max(solid_displacement, motion.largest);
  }
  Json others = Json::array();
  for (std::size_t r = 1; r < mode.hubs.size(); ++r)
    others.push_back(hub_json(mode.hubs[r], result.rotors[r].hub.axes));
  constexpr double kMost = std::numeric_limits<std::int16_t>::max();
  std::vector<std::int16_t> numbers;
  for (const NodeShape& shape : shapes) {
    append(shape.displacement, displacement / kMost, numbers);
    append(shape.rotation, rotation / kMost, numbers);
  }
  Json described = {
      {"name", mode.name},
      {"of", mode.of},
      {"frequency", hertz(mode.frequency)},
      {"damping", damping_of(mode)},
      {"grows", mode.grows()},
      {"hub", hub_json({mode.hub_displacement, mode.hub_rotation}, to_hub_)},
      {"solids", solids},
      {"first", first},
      {"shape", run_report::encode(numbers)},
      {"units", {{"displacement", displacement / kMost}, {"rotation", rotation / kMost}}},
      {"largest",
       {{"displacement", larger(std::max(displacement, solid_displacement), mode.hub_displacement)},
        {"rotation", larger(rotation, mode.hub_rotation)}}}};
  if (mode.hubs.size() > 1) described.set("others", others);
  return described;
}

}  // namespace spoke::steady_report
