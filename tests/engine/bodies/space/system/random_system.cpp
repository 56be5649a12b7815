#include "tests/engine/bodies/space/system/random_system.h"

#include <algorithm>

#include "tests/engine/bodies/space/random_joint.h"
#include "tests/models/space/beams.h"
#include "tests/models/space/random_space.h"

namespace spoke::test {
namespace {

using space::testing::random_axis;
using space::testing::random_number;
using space::testing::random_vector;

int random_index(int count, std::mt19937& random) {
  return std::uniform_int_distribution<int>(0, count - 1)(random);
}

space::RigidBody make_rigid_body(std::size_t children, std::mt19937& random) {
  space::RigidBody body;
  body.mass = 2.0 + random_number(random);
  body.centre = 0.3 * random_vector(random);
  body.inertia =
      0.1 * space::testing::random_inertia(random).rr() + 0.05 * space::Matrix3::Identity();
  for (std::size_t c = 0; c < children; ++c) body.outboard.push_back(0.5 * random_vector(random));
  return body;
}

std::shared_ptr<const space::Body> make_body(int j, std::size_t children, std::mt19937& random) {
  auto body = std::make_shared<space::Body>();
  if (j % 3 == 0) {
    body->shape = make_rigid_body(children, random);
    return body;
  }
  const auto beam = std::make_shared<space::Beam>(
      space::test::make_random_beam({j % 2 == 0, j % 4 == 0, true}, random));
  const int elements = 1 + j % 3;
  std::vector<int> handles{0};
  for (std::size_t c = 0; c < children; ++c) handles.push_back(random_index(elements + 1, random));
  body->shape =
      space::make_beam_body(*beam, space::test::make_unequal_stations(*beam, elements, random),
                            j % 3 == 1 ? ReferenceFrame::clamped : ReferenceFrame::chord, handles);
  body->beam = beam;
  return body;
}

space::TreeJoint make_joint(const char* kind, bool has_azimuth, std::mt19937& random) {
  space::TreeJoint joint;
  joint.joint = space::testing::make_random_joint(kind, random);
  for (int c = 0; c < joint.joint.driven; ++c) {
    if (has_azimuth && c == 0)
      joint.course.driven.emplace_back(spatial::AzimuthMotion{0.1, 0.2, -0.1});
    else
      joint.course.driven.emplace_back(spatial::MotionTable{
          Curve{{0.0, 0.5, 1.0}, {0.0, 0.3 * random_number(random), random_number(random)}}});
  }
  for (int c = 0; c < joint.joint.coordinates; ++c) {
    joint.course.efforts.emplace_back(random_number(random));
    joint.course.initial.push_back(0.2 * random_number(random));
    joint.course.initial_speed.push_back(random_number(random));
  }
  return joint;
}

/// Where bodies hang: each on one before or on the hub, the first there.
void hang(std::vector<TreeBody<Space>>& bodies, std::mt19937& random) {
  for (int j = 1; j < static_cast<int>(bodies.size()); ++j) {
    TreeBody<Space>& body = bodies[static_cast<std::size_t>(j)];
    body.parent = random_index(j + 1, random) - 1;
    if (body.parent < 0) continue;
    TreeBody<Space>& parent = bodies[static_cast<std::size_t>(body.parent)];
    parent.children.push_back(j);
    body.handle = static_cast<int>(parent.children.size());
  }
}

Subsystem<Space> make_trees(const RandomSystem& kind, std::size_t first_joint,
                            std::mt19937& random) {
  Subsystem<Space> tree;
  tree.bodies.resize(static_cast<std::size_t>(kind.bodies));
  hang(tree.bodies, random);
  const std::vector<const char*>& joints = space::testing::kJointKinds;
  for (std::size_t j = 0; j < tree.bodies.size(); ++j) {
    TreeBody<Space>& body = tree.bodies[j];
    body.body = make_body(static_cast<int>(j), body.children.size(), random);
    body.joint = make_joint(joints[(first_joint + j) % joints.size()], kind.is_driven, random);
    if (j % 2 == 0 && body.body->flexible())
      body.stiffening =
          space::TensionPlace{space::testing::random_rotation(random),
                              random_vector(random),
                              {{body.body->flexible()->elements / 2, random_vector(random), 0.9},
                               {body.body->flexible()->elements, random_vector(random), 0.5}}};
  }
  return tree;
}

}  // namespace

System<Space> make_random_system(const RandomSystem& kind, std::mt19937& random) {
  System<Space> system;
  const space::RigidBody hub = make_rigid_body(0, random);
  system.hub.support = kind.support;
  if (kind.is_driven)
    system.hub.drive = SpinUp{3.0, 1.0};
  else
    system.hub.drive = TorqueDrive{Curve{1.5}, 0.7};
  system.hub.orientation = space::make_quaternion(random_vector(random));
  system.hub.mass = hub.mass;
  system.hub.inertia = calc_mass(hub);
  system.hub_loads.emplace_back().force = random_vector(random);
  system.gravity = 9.81 * random_axis(random);
  system.damping = {0.1, 1e-4};
  for (const std::size_t first_joint : {0U, 5U})
    system.subsystems.push_back(make_trees(kind, first_joint, random));
  return system;
}

namespace {

void randomize(CoordinateBlock& block, double size, std::mt19937& random) {
  const auto fill = [&](double* values) {
    if (values) std::generate_n(values, block.size, [&] { return size * random_number(random); });
  };
  for (double* values : {block.q, block.v, block.a}) fill(values);
  for (double* history : block.history) fill(history);
}

}  // namespace

void randomize_state(std::mt19937& random, StepData<Space>& data) {
  randomize(data.hub_coordinates, 0.5, random);
  data.hub_attitude.sum = space::make_quaternion(space::Angular(0.1, 0.2, 0.3));
  for (SubsystemData<Space>& subsystem : data.subsystems)
    for (BodyData<Space>& body : subsystem.bodies) {
      randomize(body.coordinates, 1e-2, random);
      randomize(body.joint.coordinates, 0.3, random);
      body.joint.rotation->sum = space::make_quaternion(space::Angular(0.2, -0.1, 0.3));
    }
}

}  // namespace spoke::test
