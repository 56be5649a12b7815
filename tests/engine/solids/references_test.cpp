// Solids against total Lagrangian solutions of their meshes (St. Venant-Kirchhoff, velocity Verlet
// at two steps, error 2e-6 m and 5e-6 m), and against a pendulum of 20 modes, all by independent
// programs.

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/bodies/kernels/space/table_terms.h"
#include "models/solid/assembly.h"
#include "tests/engine/bodies/space/system/runs.h"
#include "tests/engine/solids/solid_models.h"

using namespace spoke;
using namespace spoke::test;
using spatial::Vector;

namespace {

/// A model of one bar on a hub, joined at its root.
spatial::Model on_hub(const spatial::SolidBody& body, spatial::JointKind kind) {
  spatial::Model model;
  spatial::Subsystem subsystem;
  subsystem.name = "bar";
  subsystem.bodies = {{"bar", body}};
  spatial::SubsystemJoint joint;
  joint.child = "bar";
  joint.joint.kind = kind;
  joint.joint.axes[0] = Vector::UnitY();
  subsystem.joints = {joint};
  model.subsystems = {subsystem};
  return model;
}

/// Removes the interface at the tip, which the references lack.
spatial::SolidBody without_tip(spatial::SolidBody body) {
  body.interfaces.pop_back();
  return body;
}

const BodyData<Space>& bar_of(const Run<Space>& run) {
  return run.context.data.subsystems[0].bodies[0];
}
const space::SolidConstants& constants_of(const Run<Space>& run) {
  return *bar_of(run).model->body->solid()->constants;
}

/// Returns the index of the node at a place at rest.
Eigen::Index node_at(const space::SolidConstants& constants, const space::Position& place) {
  const auto at = std::find_if(constants.nodes.begin(), constants.nodes.end(),
                               [&](const space::Position& x) { return (x - place).norm() < 1e-9; });
  REQUIRE(at != constants.nodes.end());
  return at - constants.nodes.begin();
}

/// Returns the deformed place of the node in the body's frame.
space::Position place_of(const Run<Space>& run, const space::Position& at_rest) {
  const space::SolidConstants& constants = constants_of(run);
  const Eigen::VectorXd u = calc_displacements(constants, bar_of(run).coordinates.q);
  const Eigen::Index node = node_at(constants, at_rest);
  return constants.nodes[static_cast<std::size_t>(node)] + space::Position(u.segment<3>(3 * node));
}

/// Lets a free bar with mean axes start with the velocities v by node, its hub with it.
void start_with(const Eigen::VectorXd& v, const spatial::SolidBody& description, Run<Space>& run) {
  StepData<Space>& data = run.context.data;
  BodyData<Space>& body = data.subsystems[0].bodies[0];
  const space::SolidConstants& constants = constants_of(run);
  const space::ReducedSolid& solid = *constants.reduced();
  const Eigen::SparseMatrix<double> m = solid::assemble(*description.mesh, *description.material).m;
  const Eigen::Index n = m.rows();
  space::Twist momentum = space::Twist::Zero();
  Eigen::VectorXd rates = Eigen::VectorXd::Zero(constants.coordinates);
  for (Eigen::Index c = 0; c < 3; ++c) {
    Eigen::VectorXd along(n);
    for (Eigen::Index i = 0; i < n; ++i) along[i] = v[3 * i + c];
    const Eigen::VectorXd weighted = m * along;
    for (Eigen::Index i = 0; i < n; ++i) {
      space::Position p = space::Position::Zero();
      p[c] = weighted[i];
      momentum += space::make_twist(p, cross(constants.nodes[static_cast<std::size_t>(i)], p));
      rates += weighted[i] * solid.shapes.row(3 * i + c).transpose();
    }
  }
  space::TwistMatrix inertia = space::TwistMatrix::Zero();
  inertia.topLeftCorner<3, 3>() = constants.mass * space::Matrix3::Identity();
  inertia.bottomLeftCorner<3, 3>() = space::skew(constants.S0);
  inertia.topRightCorner<3, 3>() = -space::skew(constants.S0);
  inertia.bottomRightCorner<3, 3>() =
      constants.J0.trace() * space::Matrix3::Identity() - constants.J0;
  const space::Twist frame =
      Eigen::Matrix<double, 6, 6>(inertia).llt().solve(Eigen::Matrix<double, 6, 1>(momentum));
  for (int k = 0; k < constants.coordinates; ++k) body.coordinates.v[k] = rates[k];
  space::Twist handle = frame;
  const space::SolidPlace& place = constants.places[0];
  for (std::size_t i = 0; i < place.at.size(); ++i) handle += rates[place.at[i]] * place.columns[i];
  for (int c = 0; c < space::kTwist; ++c) data.hub_coordinates.v[c] = handle[c];
}

}  // namespace

TEST_CASE("a soft bar in free flight bends as its mesh does at large rotations") {
  spatial::SolidBody bar =
      without_tip(make_bar(slender_grid(), rubber(), spatial::InterfaceKind::average));
  bar.frame = spatial::SolidFrame::mean_axis;
  bar.modes = 20;
  spatial::Model model = on_hub(bar, spatial::JointKind::fixed);
  model.hub.support = HubSupport::free;
  model.hub.mass = 1e-7;
  model.hub.inertia = 1e-9 * spatial::Tensor::Identity();
  const std::array<std::array<double, 3>, 8> expected{{{1.00072, 0.000185, 0.00039},
                                                       {0.999996, -0.000391, -0.000788},
                                                       {1.000713, 0.000559, 0.001163},
                                                       {1.000003, -0.000741, -0.001523},
                                                       {1.000705, 0.000893, 0.001858},
                                                       {0.999989, -0.001059, -0.002192},
                                                       {0.999988, -0.001325, -0.002744},
                                                       {0.999977, -0.001547, -0.003182}}};
  const std::array<double, 8> times{0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.4, 0.5};
  const auto fly = [&](bool is_stiffened) {
    std::get<spatial::SolidBody>(model.subsystems[0].bodies[0].shape).geometric_stiffening =
        is_stiffened;
    Run<Space> run(make_system(model), {Rk4{5e-5}});
    const std::vector<space::Position>& nodes = constants_of(run).nodes;
    Eigen::VectorXd v(3 * static_cast<Eigen::Index>(nodes.size()));
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const space::Position& x = nodes[i];
      v.segment<3>(3 * static_cast<Eigen::Index>(i)) =
          cross(space::Position(0.0, 0.0, 6.0), x) +
          space::Position(0.0, 0.5 * x.x() * x.x(), x.x() * x.x());
    }
    start_with(v, bar, run);
    std::array<double, 2> error{};
    double passed = 0.0;
    for (std::size_t k = 0; k < times.size(); ++k) {
      run.advance_for(times[k] - passed);
      passed = times[k];
      const space::Position A = place_of(run, {0.0, 0.0, 0.0}), B = place_of(run, {1.0, 0.0, 0.0}),
                            M = place_of(run, {0.5, 0.0, 0.0}), C = place_of(run, {0.5, 0.05, 0.0});
      const space::Position e1 = (B - A).normalized();
      const space::Position across = C - M;
      const space::Position e2 = (across - across.dot(e1) * e1).normalized();
      const space::Position sag = M - 0.5 * (A + B);
      error[0] = std::max(error[0], std::abs(sag.dot(e2) - expected[k][1]));
      error[1] = std::max(error[1], std::abs(sag.dot(cross(e1, e2)) - expected[k][2]));
    }
    return error;
  };
  const std::array<double, 2> stiffened = fly(true);
  CHECK(stiffened[0] < 0.012 * 0.003182);
  CHECK(stiffened[1] < 0.012 * 0.003182);
  const std::array<double, 2> without = fly(false);
  CHECK(std::max(without[0], without[1]) > 0.2 * 0.003182);
}

TEST_CASE("a bar that is spun up lags as its mesh does") {
  spatial::SolidMaterial material = rubber();
  material.youngs_modulus = 1e8;
  spatial::SolidBody bar = without_tip(make_bar(slender_grid(), material));
  bar.modes = 20;
  spatial::Model model = on_hub(bar, spatial::JointKind::fixed);
  model.hub.drive = SpinUp{20.0, 2.0};
  const std::array<double, 9> times{0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 2.0, 2.5, 3.0};
  const std::array<double, 9> lag{-0.002942, -0.010334, -0.017829, -0.020514, -0.017079,
                                  -0.009915, 0.000119,  4.7e-05,   -0.000157};
  const auto find_error = [&](bool is_stiffened) {
    std::get<spatial::SolidBody>(model.subsystems[0].bodies[0].shape).geometric_stiffening =
        is_stiffened;
    Run<Space> run(make_system(model), {Rk4{1e-4}});
    double error = 0.0, passed = 0.0;
    for (std::size_t k = 0; k < times.size(); ++k) {
      run.advance_for(times[k] - passed);
      passed = times[k];
      error = std::max(error, std::abs(place_of(run, {1.0, 0.0, 0.0}).y() - lag[k]));
    }
    return error;
  };
  CHECK(find_error(true) < 0.003 * 0.0205);
  CHECK(find_error(false) > 0.1 * 0.0205);
}

TEST_CASE("a soft bar swings on a hinge as by another program") {
  GridMesh grid = slender_grid();
  grid.cells = {8, 1, 1};
  grid.kind = spatial::ElementKind::hex20;
  spatial::SolidBody bar = without_tip(make_bar(grid, {1e7, 0.0, 1000.0}));
  bar.modes = 20;
  bar.geometric_stiffening = false;
  spatial::Model model = on_hub(bar, spatial::JointKind::revolute);
  model.hub.drive = FixedDrive{};
  model.gravity = Vector(0.0, 0.0, -9.81);
  const std::array<std::array<double, 3>, 6> expected{{{0.1, 0.9978985, -0.0682611},
                                                       {0.2, 0.9601008, -0.2826112},
                                                       {0.5, -0.0837537, -0.9978678},
                                                       {1.0, -1.0000147, -0.0069083},
                                                       {1.5, 0.2477136, -0.9702799},
                                                       {2.0, 0.9997228, -0.0276564}}};
  Run<Space> run(make_system(model), {Rk4{1e-4}});
  double passed = 0.0;
  for (const auto& [time, x, z] : expected) {
    run.advance_for(time - passed);
    passed = time;
    const space::SolidConstants& constants = constants_of(run);
    const Eigen::VectorXd u = calc_displacements(constants, bar_of(run).coordinates.q);
    space::Position mean = space::Position::Zero();
    double count = 0.0;
    for (std::size_t i = 0; i < constants.nodes.size(); ++i)
      if (std::abs(constants.nodes[i].x() - 1.0) < 1e-9) {
        mean +=
            constants.nodes[i] + space::Position(u.segment<3>(3 * static_cast<Eigen::Index>(i)));
        count += 1.0;
      }
    const space::Position tip =
        run.context.data.subsystems[0].joints[0].R * space::Position(mean / count);
    CHECK(tip.x() == doctest::Approx(x).epsilon(3e-5));
    CHECK(std::abs(tip.z() - z) < 3e-5);
  }
}
