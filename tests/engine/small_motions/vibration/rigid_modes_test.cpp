// Tests rigid motions and others beside coordinates that are stiffer by many orders of magnitude.

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "engine/modes.h"
#include "models/scenario.h"

namespace spoke {
namespace {

using doctest::Approx;
using Eigen::Matrix2d;
using Eigen::Matrix4d;

constexpr double kSpeed = 104.0, kLength = 0.5, kShaft = 0.01;    // rad/s, m, kg/m
constexpr double kDisc = 2.0, kPolar = 0.05, kTransverse = 0.03;  // kg, kg m^2
constexpr double kLag = 1000.0, kFlap = 700.0;                    // N m^2

Scenario read_rigid(const std::string& text) {
  return parse_scenario("world = \"space\"\n" + text + "[integration]\nduration = 1.0\n",
                        "rigid.toml");
}

/// A shaft along the axis of rotation with a disc at its end.
Scenario make_shaft(const std::string& axial, const std::string& torsion) {
  return read_rigid(
      "[hub]\ninertia = 1.0\n[hub.drive]\nkind = \"constant\"\nspeed = 104.0\n"
      "[[subsystem]]\nname = \"shaft\"\n"
      "[[subsystem.body]]\nname = \"rod\"\nkind = \"beam\"\nlength = 0.5\nbodies = 1\n"
      "elements = 4\n"
      "[subsystem.body.sections]\nmass_per_length = 0.01\nlag_stiffness = 1000.0\n"
      "flap_stiffness = 700.0\nlag_inertia = 1e-9\nflap_inertia = 1e-9\naxial_stiffness = " +
      axial + "\ntorsion_stiffness = " + torsion +
      "\n[[subsystem.body]]\nname = \"disc\"\nkind = \"rigid\"\nmass = 2.0\n"
      "inertia = [0.05, 0.03, 0.03]\n"
      "[[subsystem.joint]]\nname = \"root\"\nparent = \"hub\"\nchild = \"rod\"\n"
      "kind = \"fixed\"\norientation = [0.0, -1.5707963267948966, 0.0]\n"
      "[[subsystem.joint]]\nname = \"end\"\nparent = \"rod\"\nchild = \"disc\"\n"
      "kind = \"fixed\"\n");
}

/// Returns the growth rate of the deflection of the same shaft: place and slope of the disc in two
/// directions of the turning frame, the mass of the shaft by its static shape.
double calc_growth() {
  const auto bend = [](double stiffness) {
    Matrix2d K;
    K << 12.0, -6.0 * kLength, -6.0 * kLength, 4.0 * kLength * kLength;
    return Matrix2d(stiffness / std::pow(kLength, 3) * K);
  };
  Matrix2d shaft;
  shaft << 156.0, -22.0 * kLength, -22.0 * kLength, 4.0 * kLength * kLength;
  shaft *= kShaft * kLength / 420.0;
  const Matrix2d mass = shaft + Matrix2d(Eigen::Vector2d(kDisc, kTransverse).asDiagonal());
  const Matrix2d coriolis =
      2.0 * kSpeed * mass - Matrix2d(Eigen::Vector2d(0.0, kPolar * kSpeed).asDiagonal());
  const Matrix2d centrifugal =
      kSpeed * kSpeed * (Matrix2d(Eigen::Vector2d(0.0, kPolar).asDiagonal()) - mass);
  Matrix4d M = Matrix4d::Zero(), C = Matrix4d::Zero(), K = Matrix4d::Zero();
  M.topLeftCorner<2, 2>() = M.bottomRightCorner<2, 2>() = mass;
  C.topRightCorner<2, 2>() = -coriolis;
  C.bottomLeftCorner<2, 2>() = coriolis;
  K.topLeftCorner<2, 2>() = bend(kLag) + centrifugal;
  K.bottomRightCorner<2, 2>() = bend(kFlap) + centrifugal;
  Eigen::Matrix<double, 8, 8> A = Eigen::Matrix<double, 8, 8>::Zero();
  A.topRightCorner<4, 4>().setIdentity();
  A.bottomLeftCorner<4, 4>() = -M.inverse() * K;
  A.bottomRightCorner<4, 4>() = -M.inverse() * C;
  return A.eigenvalues().real().maxCoeff();
}

double find_growth(const ModesResult& result) {
  double most = 0.0;
  for (const Mode& mode : result.modes) most = std::max(most, mode.eigenvalue.real());
  return most;
}

std::size_t count_rigid(const ModesResult& result) {
  return static_cast<std::size_t>(std::count_if(
      result.modes.begin(), result.modes.end(),
      [](const Mode& mode) { return mode.eigenvalue == 0.0 && mode.name.starts_with("rigid"); }));
}

/// A free hub with blades that hardly stretch and twist.
std::string free_rotor_text(const std::string& hub) {
  return "[hub]\nradius = 0.2\n" + hub +
         "[blade]\ncount = 3\nlength = 2.0\nbodies = 2\nelements = 3\n"
         "[blade.sections]\nmass_per_length = 1.0\naxial_stiffness = 1e12\n"
         "flap_stiffness = 10.0\nlag_stiffness = 20.0\ntorsion_stiffness = 1e10\n"
         "lag_inertia = 1e-9\nflap_inertia = 1e-9\n";
}

/// Checks that there are so many rigid motions, and that no mode grows or decays.
void check_rigid(const Scenario& scenario, double speed, std::size_t count) {
  CAPTURE(speed);
  const ModesResult result = solve_modes(scenario, {.state = {.speed = speed}, .count = 8});
  CHECK(count_rigid(result) == count);
  for (const Mode& mode : result.modes) {
    CAPTURE(mode.name);
    CHECK(mode.eigenvalue.real() == 0.0);
    CHECK_FALSE(mode.grows());
  }
}

}  // namespace

TEST_CASE("rigid modes: a shaft between its critical speeds grows, however stiff it is otherwise") {
  const double growth = calc_growth();
  CHECK(growth == Approx(8.285).epsilon(1e-2));
  for (const auto& stiffness :
       {std::pair{"1e6", "1e4"}, std::pair{"1e9", "1e7"}, std::pair{"1e13", "1e11"}}) {
    CAPTURE(stiffness.first);
    const ModesResult result =
        solve_modes(make_shaft(stiffness.first, stiffness.second), {.count = 6});
    CHECK(count_rigid(result) == 0);
    CHECK(find_growth(result) == Approx(growth).epsilon(1e-3));
  }
}

TEST_CASE("rigid modes: a soft hinge at the end of a stiff rod vibrates") {
  const Scenario scenario = read_rigid(
      "[hub.drive]\nkind = \"fixed\"\n[[subsystem]]\nname = \"arm\"\n"
      "[[subsystem.body]]\nname = \"rod\"\nkind = \"beam\"\nlength = 1.0\nelements = 2\n"
      "[subsystem.body.sections]\nmass_per_length = 0.01\naxial_stiffness = 1e13\n"
      "flap_stiffness = 1e8\nlag_stiffness = 1e8\ntorsion_stiffness = 1e12\n"
      "flap_inertia = 1e-9\nlag_inertia = 1e-9\n"
      "[[subsystem.body]]\nname = \"vane\"\nkind = \"rigid\"\nmass = 2.0\n"
      "inertia = [0.1, 0.1, 0.1]\n"
      "[[subsystem.joint]]\nname = \"root\"\nparent = \"hub\"\nchild = \"rod\"\n"
      "kind = \"fixed\"\n"
      "[[subsystem.joint]]\nname = \"hinge\"\nparent = \"rod\"\nchild = \"vane\"\n"
      "kind = \"universal\"\naxes = [[0, 0, 1], [0, 1, 0]]\nstiffness = [1e-6, 0.0]\n");
  const ModesResult result = solve_modes(scenario, {.state = {.speed = 0.0}, .count = 2});
  CHECK(count_rigid(result) == 1);
  CHECK(result.modes.at(1).frequency == Approx(std::sqrt(1e-6 / 0.1)).epsilon(1e-6));
}

TEST_CASE("rigid modes: a follower force makes a column flutter, however stiff it is otherwise") {
  // Beck's column: P L^2/EI = 20.05.
  const auto column = [](const std::string& force) {
    return read_rigid(
        "[hub.drive]\nkind = \"fixed\"\n[[blades]]\nlength = 1.0\nbodies = 8\nelements = 2\n"
        "azimuth = 0.0\n"
        "[blades.sections]\nmass_per_length = 1.0\naxial_stiffness = 1e13\n"
        "flap_stiffness = 1.0\nlag_stiffness = 2.0\ntorsion_stiffness = 1e11\n"
        "lag_inertia = 1e-9\nflap_inertia = 1e-9\n"
        "[[load]]\nframe = \"section\"\nforce = [" +
        force + ", 0.0, 0.0]\n");
  };
  CHECK(find_growth(solve_modes(column("-15.0"), {.count = 4})) == 0.0);
  CHECK(find_growth(solve_modes(column("-26.0"), {.count = 4})) > 1.0);
}

TEST_CASE("rigid modes: a free rotor has its rigid motions, and none grow") {
  const Scenario rotor =
      read_rigid(free_rotor_text("support = \"free\"\nmass = 3.0\ninertia = [1.0, 2.0, 2.5]\n"));
  check_rigid(rotor, 0.0, 6);
  // Motions along the axis and about it are rigid; the others go round in the turning frame.
  for (const double speed : {0.01, 1.3, 50.0}) check_rigid(rotor, speed, 2);
  const Scenario light = read_rigid(
      free_rotor_text("support = \"free\"\nmass = 1e-7\ninertia = [1e-9, 1e-9, 1e-9]\n"));
  check_rigid(light, 0.0, 6);
  for (const double speed : {0.01, 3.0}) check_rigid(light, speed, 2);
}

TEST_CASE("rigid modes: a hub that a torque drives turns freely") {
  const Scenario rotor = read_rigid(
      free_rotor_text("[hub.drive]\nkind = \"torque\"\ntime = [0.0, 1.0]\ntorque = [0.0, 0.0]\n"));
  for (const double speed : {0.0, 0.01, 7.0, 60.0}) check_rigid(rotor, speed, 1);
}

TEST_CASE("rigid modes: of bodies on free joints at rest all are") {
  const Scenario bodies = read_rigid(
      "[hub.drive]\nkind = \"fixed\"\n[[subsystem]]\nname = \"s\"\n"
      "[[subsystem.body]]\nname = \"b\"\nkind = \"rigid\"\nmass = 2.0\n"
      "inertia = [0.1, 0.2, 0.25]\n"
      "[[subsystem.body]]\nname = \"c\"\nkind = \"rigid\"\nmass = 1.0\ncenter = [0.5, 0.0, 0.0]\n"
      "inertia = [0.1, 0.1, 0.1]\n"
      "[[subsystem.joint]]\nname = \"j\"\nparent = \"hub\"\nchild = \"b\"\nkind = \"spherical\"\n"
      "[[subsystem.joint]]\nname = \"k\"\nparent = \"b\"\nchild = \"c\"\nkind = \"universal\"\n"
      "axes = [[0, 0, 1], [0, 1, 0]]\noffset = [0.4, 0.0, 0.0]\n");
  CHECK(count_rigid(solve_modes(bodies, {.state = {.speed = 0.0}, .count = 5})) == 5);
}

TEST_CASE("rigid modes: a body that spins about its middle axis tumbles, about others it nods") {
  // Euler's equations: the square of the growth is w^2 (Iz - Ix) (Iy - Iz)/(Ix Iy).
  const auto turn = [](const std::string& inertia, double speed) {
    return solve_modes(
        read_rigid("[hub]\nsupport = \"free\"\nmass = 3.0\ninertia = " + inertia +
                   "\n[[subsystem]]\nname = \"wheel\"\n"
                   "[[subsystem.body]]\nname = \"ball\"\nkind = \"rigid\"\nmass = 1.0\n"
                   "inertia = [0.1, 0.1, 0.1]\n"
                   "[[subsystem.joint]]\nname = \"joint\"\nparent = \"hub\"\n"
                   "child = \"ball\"\nkind = \"spherical\"\n"),
        {.state = {.speed = speed}, .count = 9});
  };
  for (const double speed : {0.01, 5.0, 300.0}) {
    CAPTURE(speed);
    // Motions along the axis and about it, and turns of the ball against the hub.
    const ModesResult middle = turn("[1.0, 3.0, 2.5]", speed);
    CHECK(count_rigid(middle) == 5);
    CHECK(find_growth(middle) == Approx(speed * std::sqrt(1.5 * 0.5 / 3.0)).epsilon(1e-6));
    const ModesResult largest = turn("[1.0, 2.0, 2.5]", speed);
    CHECK(count_rigid(largest) == 5);
    CHECK(find_growth(largest) == 0.0);
    CHECK(largest.modes.at(5).frequency ==
          Approx(speed * std::sqrt(1.5 * 0.5 / 2.0)).epsilon(1e-6));
  }
}

}  // namespace spoke
