// Damping by direction and by mode, as the modes show it: mu W / 2, and the ratios asked for.

#include "engine/modes.h"

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "engine/linearize.h"
#include "engine/simulation.h"
#include "models/damping.h"
#include "models/scenario.h"

using namespace spoke;
using doctest::Approx;

namespace {

/// A straight uniform cantilever of 1 m, whose flap, lag, stretch and twist have frequencies of
/// their own; `sections`: more of its sections, `more`: tables behind it.
std::string cantilever(int bodies, const std::string& sections, const std::string& more) {
  return "world = \"space\"\n[hub]\n[hub.drive]\nkind = \"constant\"\nspeed = 0.0\n"
         "[[blades]]\nazimuth = 0.3\nlength = 1.0\nbodies = " +
         std::to_string(bodies) +
         "\nelements = 4\n[blades.sections]\nmass_per_length = 1.0\naxial_stiffness = 900.0\n"
         "lag_stiffness = 2.0\nflap_stiffness = 1.0\ntorsion_stiffness = 0.02\n"
         "lag_inertia = 1e-4\nflap_inertia = 1e-4\n" +
         sections + more + "[integration]\nduration = 1.0\n";
}

/// A blade that is tapered, twisted, swept and bent, its centres off the axis.
const std::string kGeneral = R"(world = "space"
[hub]
radius = 0.2
[hub.drive]
kind = "constant"
speed = 0.0
[[blades]]
length = 8.0
bodies = 3
elements = 3
azimuth = 0.4
precone = 0.1
reference_frame = "chord"
[blades.sections]
station = [0.0, 3.0, 8.0]
mass_per_length = [12.0, 9.0, 4.0]
axial_stiffness = [3e7, 2e7, 1e7]
lag_stiffness = [3e5, 2e5, 1e5]
flap_stiffness = [3e4, 2e4, 1e4]
torsion_stiffness = [3e4, 2e4, 1e4]
lag_inertia = [0.1, 0.08, 0.03]
flap_inertia = [0.02, 0.01, 0.004]
twist = [0.3, 0.1, 0.0]
sweep = [0.0, 0.0, 0.4]
prebend = [0.0, 0.1, 0.5]
tension_center = [[0.01, 0.02], [0.01, 0.02], [0.0, 0.01]]
mass_center = [[0.03, 0.0], [0.02, 0.01], [0.0, 0.0]]
[[blades.point_mass]]
position = 5.0
mass = 3.0
offset = [0.0, 0.1, 0.0]
[[blades.joint]]
name = "pitch"
station = 3.0
kind = "revolute"
axis = [1.0, 0.0, 0.0]
motion = { mean = 0.0 }
)";

ModesResult modes_of(const std::string& text, int count, double speed = 0.0) {
  return solve_modes(parse_scenario(text, "t.toml"), {.state = {.speed = speed}, .count = count});
}

std::vector<double> ratios_of(const ModesResult& result) {
  std::vector<double> ratios;
  for (const Mode& mode : result.modes) ratios.push_back(mode.damping_ratio);
  return ratios;
}

void check_ratios(const ModesResult& result, const std::vector<double>& wanted,
                  double error = 1e-8) {
  const std::vector<double> found = ratios_of(result);
  REQUIRE(found.size() >= wanted.size());
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    CAPTURE(k);
    CHECK(found[k] == Approx(wanted[k]).epsilon(error));
  }
}

/// Checks that each kind of mode has the damping ratio mu W / 2 of its direction.
void check_factors(const ModesResult& result, const std::vector<std::pair<std::string, double>>& mu,
                   double error) {
  for (const auto& each : mu) {
    const auto& [kind, factor] = each;
    CAPTURE(each.first);
    int found = 0;
    for (const Mode& mode : result.modes) {
      if (mode.kind != kind) continue;
      CHECK(mode.damping_ratio == Approx(0.5 * factor * std::abs(mode.eigenvalue)).epsilon(error));
      ++found;
    }
    CHECK(found > 0);
  }
}

}  // namespace

TEST_CASE("damping: each direction has its own factor") {
  for (const int bodies : {1, 3}) {
    const std::string keys = "[damping]\nflap = 1e-3\nlag = 2e-3\naxial = 3e-4\ntorsion = 4e-4\n";
    check_factors(modes_of(cantilever(bodies, "", keys), 14),
                  {{"flap", 1e-3}, {"lag", 2e-3}, {"axial", 3e-4}, {"torsion", 4e-4}}, 1e-9);
  }
}

TEST_CASE("damping: mu is in the order of BeamDyn's sections") {
  // Shears, stretch, bending in the edge (about its x), in flap (about its y), twist.
  const std::string keys = "[damping]\nmu = [9e-3, 8e-3, 3e-4, 2e-3, 1e-3, 4e-4]\n";
  const std::vector<std::pair<std::string, double>> slender{
      {"flap", 1e-3}, {"lag", 2e-3}, {"axial", 3e-4}, {"torsion", 4e-4}};
  check_factors(modes_of(cantilever(2, "", keys), 14), slender, 1e-9);
  // A beam that is soft in shear moves by it alone.
  const std::string soft = "flap_shear_stiffness = 1e-4\nlag_shear_stiffness = 3e-4\n";
  check_factors(modes_of(cantilever(2, soft, keys), 4), {{"flap", 9e-3}, {"lag", 8e-3}}, 1e-3);
}

TEST_CASE("damping: shear is damped as bending unless it is given") {
  const std::string soft = "flap_shear_stiffness = 20.0\nlag_shear_stiffness = 30.0\n";
  const auto with = [&](const std::string& keys) {
    return ratios_of(modes_of(cantilever(2, soft, "[damping]\n" + keys), 6));
  };
  const std::vector<double> found = with("flap = 1e-3\nlag = 2e-3\n");
  const std::vector<double> given =
      with("flap = 1e-3\nlag = 2e-3\nflap_shear = 1e-3\nlag_shear = 2e-3\n");
  const std::vector<double> other = with("flap = 1e-3\nlag = 2e-3\nflap_shear = 0.0\n");
  CHECK(found == given);
  CHECK(other[0] < 0.95 * found[0]);
}

TEST_CASE("damping: equal factors are a stiffness_factor, whatever couples") {
  const std::string tail = "[integration]\nduration = 1.0\n";
  const auto proportional =
      modes_of(kGeneral + "[damping]\nstiffness_factor = 2e-3\n" + tail, 8, 3.0);
  const auto equal =
      modes_of(kGeneral + "[damping]\nmu = [2e-3, 2e-3, 2e-3, 2e-3, 2e-3, 2e-3]\n" + tail, 8, 3.0);
  for (std::size_t k = 0; k < 8; ++k)
    CHECK(std::abs(equal.modes[k].eigenvalue - proportional.modes[k].eigenvalue) <
          1e-9 * std::abs(proportional.modes[k].eigenvalue));
}

TEST_CASE("damping: modes have the ratios asked for") {
  const std::vector<double> ratios{0.005, 0.02, 0.0, 0.01, 0.5};
  const std::string keys = "[damping]\nratios = [0.005, 0.02, 0.0, 0.01, 0.5]\n";
  for (const int bodies : {1, 2, 5}) {
    CAPTURE(bodies);
    check_ratios(modes_of(cantilever(bodies, "", keys), 6), ratios);
  }
  const std::string general = kGeneral + keys + "above = 0.03\n[integration]\nduration = 1.0\n";
  std::vector<double> all = ratios;
  all.push_back(0.03);
  check_ratios(modes_of(general, 6), all);
}

TEST_CASE("damping: modes above the ratios are damped by their frequency") {
  const std::string keys = "[damping]\nratios = [0.005, 0.02]\n";
  const auto check_rest = [](const ModesResult& result, double above) {
    const double next = std::abs(result.modes[2].eigenvalue);
    for (std::size_t k = 2; k < result.modes.size(); ++k)
      CHECK(result.modes[k].damping_ratio ==
            Approx(above * std::abs(result.modes[k].eigenvalue) / next).epsilon(1e-8));
  };
  check_rest(modes_of(cantilever(2, "", keys), 6), 0.02);
  check_rest(modes_of(cantilever(2, "", keys + "above = 0.001\n"), 6), 0.001);
  check_rest(modes_of(cantilever(2, "", keys + "above = 0.0\n"), 6), 0.0);
}

TEST_CASE("damping: ratios, directions and a stiffness_factor add up") {
  const auto result = modes_of(
      cantilever(
          2, "",
          "[damping]\nstiffness_factor = 1e-3\nflap = 2e-3\nlag = 5e-4\nratios = [0.01, 0.02]\n"),
      2);
  CHECK(result.modes[0].kind == "flap");
  CHECK(result.modes[0].damping_ratio ==
        Approx(0.01 + 0.5 * 3e-3 * std::abs(result.modes[0].eigenvalue)).epsilon(1e-3));
  CHECK(result.modes[1].damping_ratio ==
        Approx(0.02 + 0.5 * 1.5e-3 * std::abs(result.modes[1].eigenvalue)).epsilon(1e-3));
}

TEST_CASE(
    "damping: a blade of the plane has its ratios and factors, and unequal blades their own") {
  const auto planar = [](const std::string& keys) {
    return "[hub]\nradius = 0.1\n[hub.drive]\nkind = \"constant\"\nspeed = 0.0\n"
           "[[blades]]\nlength = 1.0\nbodies = 3\nelements = 2\nreference_frame = \"chord\"\n"
           "density = 1.0\narea = 1.0\nsecond_moment = 2e-3\nyoungs_modulus = 900.0\n"
           "[[blades]]\nlength = 1.4\nbodies = 2\nelements = 4\ndensity = 1.0\narea = 1.0\n"
           "second_moment = 2e-3\nyoungs_modulus = 900.0\nazimuth = 3.0\n[damping]\n" +
           keys + "[integration]\nduration = 1.0\n";
  };
  const ModesResult found = modes_of(planar("ratios = [0.01, 0.03, 0.02]\nabove = 0.04\n"), 4);
  REQUIRE(found.modes.size() == 8);
  std::vector<double> by_blade[2];
  for (const Mode& mode : found.modes)
    by_blade[mode.of == "blade 1" ? 0 : 1].push_back(mode.damping_ratio);
  for (const std::vector<double>& ratios : by_blade) {
    REQUIRE(ratios.size() == 4);
    const std::vector<double> wanted{0.01, 0.03, 0.02, 0.04};
    for (std::size_t k = 0; k < 4; ++k) CHECK(ratios[k] == Approx(wanted[k]).epsilon(1e-8));
  }
  check_factors(modes_of(planar("lag = 2e-3\naxial = 1e-3\n"), 5), {{"lag", 2e-3}, {"axial", 1e-3}},
                1e-9);
}

TEST_CASE("damping: a beam of a subsystem has its ratios") {
  const std::string text =
      "world = \"space\"\n[hub]\n[hub.drive]\nkind = \"constant\"\nspeed = 0.0\n"
      "[[subsystem]]\nname = \"arm\"\n[[subsystem.body]]\nname = \"block\"\nkind = \"rigid\"\n"
      "mass = 1.0\ninertia = [1.0, 1.0, 1.0]\n"
      "[[subsystem.body]]\nname = \"beam\"\nkind = \"beam\"\n"
      "length = 1.0\nbodies = 2\nelements = 3\n[subsystem.body.sections]\nmass_per_length = 1.0\n"
      "axial_stiffness = 900.0\nlag_stiffness = 2.0\nflap_stiffness = 1.0\n"
      "torsion_stiffness = 0.02\nlag_inertia = 1e-4\nflap_inertia = 1e-4\n"
      "[[subsystem.joint]]\nparent = \"hub\"\nchild = \"block\"\nkind = \"fixed\"\n"
      "[[subsystem.joint]]\nparent = \"block\"\nchild = \"beam\"\nkind = \"fixed\"\n"
      "[damping]\nratios = [0.005, 0.02, 0.01]\n[integration]\nduration = 1.0\n";
  check_ratios(modes_of(text, 3), {0.005, 0.02, 0.01});
}

TEST_CASE("damping: the linear system has the damping of the modes") {
  const std::string text = cantilever(2, "", "[damping]\nratios = [0.01, 0.02]\nlag = 1e-3\n");
  const ModesResult modes = modes_of(text, 4);
  const LinearSystem system = solve_linear_system(parse_scenario(text, "t.toml"), {});
  const Eigen::VectorXcd roots = Eigen::MatrixXd(system.A).eigenvalues();
  for (const Mode& mode : modes.modes)
    CHECK((roots.array() - mode.eigenvalue).abs().minCoeff() < 1e-8 * std::abs(mode.eigenvalue));
}

TEST_CASE("damping: the limit of rk4 in the plane is that of each direction") {
  const auto limit = [](const std::string& keys) {
    const std::string text =
        "[hub]\n[hub.drive]\nkind = \"constant\"\nspeed = 0.0\n[blade]\ncount = 1\nlength = 1.0\n"
        "bodies = 2\nelements = 4\ndensity = 1.0\narea = 1.0\nsecond_moment = 1e-3\n"
        "youngs_modulus = 1000.0\n[damping]\n" +
        keys + "[integration]\nduration = 1.0\n";
    return Simulation(parse_scenario(text, "t.toml")).linear_properties().rk4_largest_step;
  };
  const double proportional = limit("stiffness_factor = 1e-2\n");
  CHECK(limit("lag = 1e-2\naxial = 1e-2\n") == Approx(proportional).epsilon(1e-9));
  const double free = limit("stiffness_factor = 0.0\n");
  CHECK(proportional < 0.5 * free);
  const double axial = limit("axial = 1e-2\n"), lag = limit("lag = 1e-2\n");
  CHECK(std::min(axial, lag) == Approx(proportional).epsilon(1e-9));
  CHECK(std::max(axial, lag) > 1.5 * proportional);
}
