// The Princeton beam: a thin strip that a weight at its tip bends about both axes and twists.

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "engine/equilibrium.h"
#include "models/scenario.h"
#include "tests/engine/small_motions/steady/elastic_rod.h"

namespace spoke {
namespace {

using Eigen::Vector3d;

// E. H. Dowell and J. J. Traybar, AMS Reports 1194 and 1257, Princeton University (1975): aluminium
// 7075, 20 by 1/2 by 1/8 inch, and the largest weight of 3 pounds.
constexpr double kLength = 0.508, kWidth = 12.7e-3, kThickness = 3.175e-3;
constexpr double kYoung = 71.7e9, kShear = kYoung / (2.0 * 1.31), kWeight = 13.345;

/// The broad side along y.
const test::ElasticRod kBeam{
    kLength,
    kYoung* kWidth* kThickness,
    {kShear * kWidth * std::pow(kThickness, 3) / 3.0 * (1.0 - 0.63 * kThickness / kWidth),
     kYoung* kWidth* std::pow(kThickness, 3) / 12.0,
     kYoung* kThickness* std::pow(kWidth, 3) / 12.0}};

/// Returns the weight at an angle from the broad side.
Vector3d weight_at(double angle) {
  return kWeight * Vector3d(0.0, -std::cos(angle), -std::sin(angle));
}

BladeEquilibrium bend(int bodies, const Vector3d& force) {
  std::ostringstream text;
  text.precision(17);
  text << "world = \"space\"\n[hub.drive]\nkind = \"fixed\"\n[[blades]]\nazimuth = 0.0\nlength = "
       << kLength << "\nbodies = " << bodies
       << "\nelements = 2\n[blades.sections]\nmass_per_length = 0.113\naxial_stiffness = "
       << kBeam.axial << "\ntorsion_stiffness = " << kBeam.stiffness.x()
       << "\nflap_stiffness = " << kBeam.stiffness.y()
       << "\nlag_stiffness = " << kBeam.stiffness.z() << "\n[[load]]\nframe = \"hub\"\nforce = ["
       << force.x() << ", " << force.y() << ", " << force.z() << "]\n[integration]\nduration = 1\n";
  return solve_equilibrium(parse_scenario(text.str(), "princeton.toml")).blades.at(0);
}

/// Errors of the tip: of its place by the largest displacement, of its rotation.
struct TipError {
  double place = 0.0, turn = 0.0;
};

TipError compare(const BladeEquilibrium& blade, const test::RodTip& known) {
  const Vector3d& vector = blade.tip_rotation;
  const Eigen::AngleAxisd turn(vector.norm(), vector.normalized());
  return {(blade.tip_displacement - known.displacement).norm() / known.displacement.norm(),
          Eigen::Quaterniond(turn).angularDistance(known.rotation)};
}

}  // namespace

TEST_CASE("a rod bent in a plane is the elastica") {
  // Slope and place of the tip at P L^2/EI = 2 (Bisshopp and Drucker 1945; Mattiasson 1981).
  const test::ElasticRod rod{1.0, 1e12, {1.0, 1.0, 1.0}};
  const test::RodTip tip = solve_rod(rod, {0.0, 0.0, 2.0});
  CHECK(tip.displacement.z() == doctest::Approx(0.49346).epsilon(1e-4));
  CHECK(-tip.displacement.x() == doctest::Approx(0.16064).epsilon(1e-4));
}

TEST_CASE("published: the Princeton beam at several angles, beside an elastic rod") {
  for (const double degrees : {15.0, 30.0, 45.0, 60.0, 75.0}) {
    CAPTURE(degrees);
    const Vector3d weight = weight_at(degrees * std::numbers::pi / 180.0);
    const test::RodTip known = solve_rod(kBeam, weight);
    CHECK(known.displacement.norm() > 0.05 * kLength);
    const TipError coarse = compare(bend(8, weight), known),
                   fine = compare(bend(16, weight), known);
    CAPTURE(fine.place);
    CAPTURE(fine.turn);
    CHECK(fine.place < 1e-3);
    CHECK(fine.turn < 1e-3);
    CHECK(coarse.place / fine.place > 3.5);  // order 2: 4 in the limit
    CHECK(coarse.turn / fine.turn > 3.5);
  }
}

}  // namespace spoke
