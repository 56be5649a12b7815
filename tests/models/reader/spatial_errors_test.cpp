// Messages for invalid models in space: hub, blades, sections.

#include <doctest/doctest.h>

#include <string>

#include "tests/models/reader/spatial_texts.h"

using namespace spoke;
using spoke::test::check_edits;
using spoke::test::kBladeText;

namespace {

const std::string kUnit =
    "1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, "
    "0, 0, 0, 0, 1";
const std::string kUnequal =
    "1, 0.5, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, "
    "0, 0, 0, 0, 0, 1";  // two entries that should be equal
const std::string kIndefinite =
    "1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, "
    "1, 0, 0, 0, 1";  // two equal rows
const std::string kStiffness =
    "axial_stiffness = [3e7, 2e7, 1e7]\nflap_stiffness = [3e3, 2e3, 1e3]\nlag_stiffness = [3e4, "
    "2e4, 1e4]\ntorsion_stiffness = [3e3, 2e3, 1e3]\n";

}  // namespace

TEST_CASE("what is of another world is refused") {
  check_edits(kBladeText,
              {
                  {"world = \"space\"\n", "world = \"flat\"\n",
                   "f.toml:2:9: world: is \"flat\", expected \"plane\" or \"space\""},
                  {"world = \"space\"\n", "world = \"plane\"\n[[subsystem]]\nname = \"a\"\n",
                   "f.toml:3:1: subsystem: belongs to another world, expected world = \"space\""},
                  {"[integration]\n", "[[drag]]\nlinear = 1\n[integration]\n",
                   "f.toml:33:1: drag: belongs to another world, expected world = \"plane\""},
                  {"world = \"space\"\n", "wold = \"space\"\n",
                   "f.toml:2:1: wold: unknown key, did you mean \"world\"?"},
                  {"axial_stiffness", "axial_stifness",
                   "f.toml:16:1: blade.sections.axial_stifness: unknown key, did you mean "
                   "\"axial_stiffness\"?"},
                  {"[[blade.joint]]\nname = \"flap\"", "[[blade.hinge]]\nname = \"flap\"",
                   "f.toml:21:9: blade.hinge: unknown key, expected \"length\", \"bodies\", "
                   "\"elements\", \"sections\", \"reference_frame\", \"geometric_stiffening\", "
                   "\"strain\", \"point_mass\", \"azimuth\", \"precone\", \"joint\", \"loop\", "
                   "\"coupling\", \"aerodynamics\" or \"count\""},
              });
}

TEST_CASE("strains are linear, or of second order with all that they stiffen") {
  check_edits(kBladeText,
              {{"count = 3", "count = 3\nstrain = \"green\"",
                "f.toml:12:10: blade.strain: is \"green\", expected \"automatic\", \"linear\" or "
                "\"nonlinear\""},
               {"count = 3", "count = 3\nstrain = \"nonlinear\"\ngeometric_stiffening = false",
                "f.toml:13:24: blade.geometric_stiffening: is false, expected true, or strain = "
                "\"linear\": strains of second order make the tension that stiffens"}});
}

TEST_CASE("hubs that cannot be are refused") {
  check_edits(
      kBladeText,
      {
          {"radius = 0.1\n", "axis = [0, 0, 0]\n",
           "f.toml:4:8: hub.axis: has length 0, expected a direction"},
          {"radius = 0.1\n", "axis = [0, 1]\n",
           "f.toml:4:8: hub.axis: is an array (2), expected an array of 3 numbers"},
          {"radius = 0.1\n", "radius = -0.1\n",
           "f.toml:4:10: hub.radius: is -0.1, expected a number of 0 or more (m)"},
          {"radius = 0.1\n", "inertia = 0\n",
           "f.toml:4:11: hub.inertia: is 0, expected a number greater than 0 (kg m^2)"},
          {"radius = 0.1\n", "inertia = [1, 2, 0]\n",
           "f.toml:4:11: hub.inertia: has the principal moments 0, 1 and 2 kg m^2, expected all of "
           "them greater than 0"},
          {"radius = 0.1\n", "inertia = [1, 2, 4]\n",
           "f.toml:4:11: hub.inertia: has the principal moments 1, 2 and 4 kg m^2, expected none "
           "greater than the sum of the others, as of a real body"},
          {"radius = 0.1\n", "inertia = [1, 1, 1, 2, 0, 0]\n",
           "f.toml:4:11: hub.inertia: has the principal moments -1, 1 and 3 kg m^2, expected all "
           "of them greater than 0"},
          {"radius = 0.1\n", "inertia = [1, 2]\n",
           "f.toml:4:11: hub.inertia: is an array (2), expected one moment of inertia, about every "
           "axis, 3 moments, or 6 entries xx, yy, zz, xy, xz, yz (kg m^2)"},
          {"radius = 0.1\n", "velocity = [1, 0, 0]\n",
           "f.toml:4:12: hub.velocity: belongs to a free hub, expected [hub.mount] to move an "
           "axle"},
          {"radius = 0.1\n", "angular_velocity = [1, 0, 0]\n",
           "f.toml:4:20: hub.angular_velocity: belongs to a free hub, expected initial_speed of a "
           "drive, or [hub.mount]"},
          {"radius = 0.1\n", "support = \"free\"\n",
           "f.toml:3:1: hub.mass: is missing, expected a number greater than 0 (kg)"},
          {"radius = 0.1\n", "support = \"free\"\nmass = 2\n",
           "f.toml:3:1: hub.inertia: is missing, expected one moment of inertia, about every "
           "axis, 3 moments, or 6 entries xx, yy, zz, xy, xz, yz (kg m^2)"},
          {"radius = 0.1\n", "support = \"free\"\nmass = 2\ninertia = \"3\"\n",
           "f.toml:6:11: hub.inertia: is \"3\", expected one moment of inertia, about every axis, "
           "3 moments, or 6 entries xx, yy, zz, xy, xz, yz (kg m^2)"},
          {"radius = 0.1\n", "support = \"free\"\nmass = 2\ninertia = [1, 1, 1]\n",
           "f.toml:8:8: hub.drive.kind: is \"constant\", which prescribes the rotation about an "
           "axle; expected, of a free hub, \"free\", \"torque\" or \"torque_by_speed\""},
          {"[hub.drive]\nkind = \"constant\"\nspeed = 4.0\n", "",
           "f.toml:3:1: hub.drive.kind: is missing, expected \"spin_up\", "
           "\"spin_up_hold_spin_down\", \"torque\", \"free\", \"table\", \"fixed\", \"constant\" "
           "or \"torque_by_speed\""},
          {"[gravity]\n", "[hub.mount]\n[gravity]\n",
           "f.toml:8:1: hub.mount: has neither translation nor rotation, expected at least one of "
           "them"},
          {"[gravity]\n", "[hub.mount]\nrotation = { amplitude = [0.1, 0, 0] }\n[gravity]\n",
           "f.toml:9:12: hub.mount.rotation.frequency: is missing, expected a number (rad/s)"},
          {"[gravity]\n", "[hub.mount]\nrotation = { time = [0, 1], x = [0] }\n[gravity]\n",
           "f.toml:9:33: hub.mount.rotation.x: has 1 number, expected 2, one for each of "
           "hub.mount.rotation.time"},
          {"[gravity]\n",
           "[hub.mount]\nrotation = { time = [0, 1], x = [0, 1], phase = 1 }\n[gravity]\n",
           "f.toml:9:49: hub.mount.rotation.phase: given along with time, expected only one of "
           "them"},
          {"[gravity]\n", "[hub.mount]\nrotation = {}\n[gravity]\n",
           "f.toml:9:12: hub.mount.rotation: has none of time, constant, rate and amplitude, "
           "expected one or more"},
          {"[gravity]\n", "[hub.mount]\nrotation = { rate = [0, 1, 0], phase = 1 }\n[gravity]\n",
           "f.toml:9:40: hub.mount.rotation.phase: would be ignored, expected only with amplitude"},
          {"[gravity]\n", "[hub.mount]\ntranslation = { rate = 2 }\n[gravity]\n",
           "f.toml:9:24: hub.mount.translation.rate: is 2, expected an array of 3 numbers (m/s)"},
          {"[gravity]\n", "[hub.mount]\ntranslation = { rate = [1, 0, 0], x = [1] }\n[gravity]\n",
           "f.toml:9:39: hub.mount.translation.x: would be ignored, expected only with time"},
          {"acceleration = [0, 0, -9.81]", "acceleration = [0, -9.81]",
           "f.toml:9:16: gravity.acceleration: is an array (2), expected an array of 3 numbers "
           "(m/s^2)"},
      });
}

TEST_CASE("sections that do not fit are refused") {
  check_edits(
      kBladeText,
      {
          {"station = [0.0, 3.0, 8.0]", "station = [0.0, 3.0, 2.0]",
           "f.toml:14:22: blade.sections.station.3: is 2.0, expected more than the value before "
           "it, 3"},
          {"station = [0.0, 3.0, 8.0]", "station = [0.5, 3.0, 8.0]",
           "f.toml:14:11: blade.sections.station: begins at 0.5, expected 0 (m, the root)"},
          {"station = [0.0, 3.0, 8.0]", "station = [0.0, 3.0, 7.0]",
           "f.toml:14:11: blade.sections.station: ends at 7, expected 8 (m, length)"},
          {"station = [0.0, 3.0, 8.0]", "station = [8.0]",
           "f.toml:14:11: blade.sections.station: has 1 value, expected 2 or more"},
          {"mass_per_length = [3.0, 2.0, 1.0]", "mass_per_length = [3.0, 2.0]",
           "f.toml:15:19: blade.sections.mass_per_length: has 2 values, expected 3, one for each "
           "station"},
          {"mass_per_length = [3.0, 2.0, 1.0]", "mass_per_length = [3.0, 0.0, 1.0]",
           "f.toml:15:25: blade.sections.mass_per_length.2: is 0.0, expected a number greater than "
           "0 (kg/m)"},
          {"mass_per_length = [3.0, 2.0, 1.0]\n", "",
           "f.toml:13:1: blade.sections.mass_per_length: is missing, expected 3 values, one for "
           "each station"},
          {"torsion_stiffness = [3e3, 2e3, 1e3]\n", "",
           "f.toml:13:1: blade.sections.torsion_stiffness: is missing, expected 3 values, one for "
           "each station"},
          {"torsion_stiffness = [3e3, 2e3, 1e3]", "torsion_stiffness = [3e3, -2e3, 1e3]",
           "f.toml:19:27: blade.sections.torsion_stiffness.2: is -2000.0, expected a number "
           "greater than 0 (N m^2)"},
          {"twist = [0.2, 0.1, 0.0]", "twist = [0.2, 0.1]",
           "f.toml:20:9: blade.sections.twist: has 2 values, expected 3, one for each station"},
          {"twist = [0.2, 0.1, 0.0]", "mass_center = [[0.1, 0], [0.1]]",
           "f.toml:20:26: blade.sections.mass_center.2: is an array (1), expected an array of 2 "
           "numbers (m)"},
          {"twist = [0.2, 0.1, 0.0]", "mass_center = [0.1, 0]",
           "f.toml:20:16: blade.sections.mass_center.1: is 0.1, expected an array of 2 numbers "
           "(m)"},
          {"twist = [0.2, 0.1, 0.0]", "lag_shear_stiffness = 0",
           "f.toml:20:23: blade.sections.lag_shear_stiffness: is 0, expected a number greater than "
           "0 (N)"},
          {"twist = [0.2, 0.1, 0.0]", "matrix_convention = \"beamdyn\"",
           "f.toml:20:21: blade.sections.matrix_convention: would be ignored, expected only with "
           "\"stiffness_6x6\" or \"mass_6x6\""},
          {"[blade.sections]\n", "[[blade.point_mass]]\nposition = 9\nmass = 1\n[blade.sections]\n",
           "f.toml:14:12: blade.point_mass.1.position: is 9, expected a number from 0 to 8 (m, "
           "from root to tip)"},
          {"[blade.sections]\n",
           "[[blade.point_mass]]\nposition = 1\nmass = 1\ninertia = [1, 1, 3]\n[blade.sections]\n",
           "f.toml:16:11: blade.point_mass.1.inertia: has the principal moments 1, 1 and 3 kg m^2, "
           "expected none greater than the sum of the others, as of a real body"},
          {"length = 8.0\n", "length = 8.0\nelements = 0\n",
           "f.toml:13:12: blade.elements: is 0, expected a whole number from 1 to 100000"},
          {"length = 8.0\n", "length = 8.0\nbodies = 90000\nelements = 90000\n",
           "f.toml:10:1: blade: makes 24300000000 elements, expected at most 20000000"},
          {"[gravity]", "[damping]\nmass_factor = 0.1\n[gravity]",
           "f.toml:9:15: damping.mass_factor: damps motion relative to each body's own frame, next "
           "to none of a beam of several bodies; expected 0, or bodies = 1: stiffness_factor damps "
           "any number of bodies alike"},
      });
}

TEST_CASE("section matrices that are none are refused") {
  check_edits(
      kBladeText,
      {
          {kStiffness,
           "flap_inertia = 0.1\nlag_inertia = 0.1\nstiffness_6x6 = [[" + kUnit + "], [" + kUnequal +
               "], [" + kUnit + "]]\n",
           "f.toml:18:128: blade.sections.stiffness_6x6.2: is not symmetric: row 1, column 2 is "
           "0.5, the other is 0; expected equal ones"},
          {kStiffness,
           "flap_inertia = 0.1\nlag_inertia = 0.1\nstiffness_6x6 = [[" + kUnit + "], [" + kUnit +
               "], [" + kIndefinite + "]]\n",
           "f.toml:18:238: blade.sections.stiffness_6x6.3: is not positive definite, expected a "
           "matrix that gives every motion energy"},
          {kStiffness,
           "flap_inertia = 0.1\nlag_inertia = 0.1\nstiffness_6x6 = [[" + kUnit + "], [" + kUnit +
               "]]\n",
           "f.toml:18:17: blade.sections.stiffness_6x6: has 2 values, expected 3, one for each "
           "station"},
          {kStiffness,
           "flap_inertia = 0.1\nlag_inertia = 0.1\nstiffness_6x6 = [[" + kUnit + "], [" + kUnit +
               "], [1, 2, 3]]\n",
           "f.toml:18:238: blade.sections.stiffness_6x6.3: is an array (3), expected an array of "
           "36 or 21 numbers (SI)"},
          {kStiffness,
           "flap_inertia = 0.1\nlag_inertia = 0.1\nstiffness_6x6 = [[" + kUnit + "], [" + kUnit +
               "], [" + kUnit + "]]\naxial_stiffness = 1\n",
           "f.toml:19:19: blade.sections.axial_stiffness: given along with stiffness_6x6, expected "
           "only one of them"},
          {kStiffness, "stiffness_6x6 = [[" + kUnit + "], [" + kUnit + "], [" + kUnit + "]]\n",
           "f.toml:13:1: blade.sections.flap_inertia: is missing, expected 3 values, one for each "
           "station"},
          {"mass_per_length = [3.0, 2.0, 1.0]\n",
           "mass_6x6 = [[" + kUnit + "], [" + kUnit + "], [" + kUnit + "]]\n",
           "f.toml:15:13: blade.sections.mass_6x6.1: is not the mass of a thin slice, expected m "
           "three times on the diagonal, the first moments of a centre in the section, and a polar "
           "inertia that is the sum of the two others; or matrix_convention = \"beamdyn\"?"},
          {kStiffness,
           "flap_inertia = 0.1\nlag_inertia = 0.1\nstiffness_6x6 = [[" + kUnit + "], [" + kUnit +
               "], [" + kUnit + "]]\nmatrix_convention = \"precomp\"\n",
           "f.toml:19:21: blade.sections.matrix_convention: is \"precomp\", expected \"spoke\" or "
           "\"beamdyn\""},
      });
}

TEST_CASE("blades given in both ways or wrongly are refused") {
  check_edits(
      kBladeText,
      {
          {"[integration]", "[[blades]]\n[integration]",
           "f.toml:11:9: blade.count: given along with [[blades]], expected only one of them"},
          {"count = 3", "count = 0",
           "f.toml:11:9: blade.count: is 0, expected a whole number from 1 to 100000"},
          {"count = 3\nlength = 8.0", "[[blades]]\nlength = 8.0\nprecone = \"up\"",
           "f.toml:13:11: blades.1.precone: is \"up\", expected a number (rad)"},
          {"count = 3\nlength = 8.0", "count = 3",
           "f.toml:10:1: blade.length: is missing, expected a number greater than 0 (m)"},
          {"count = 3\nlength = 8.0\n", "count = 3\nlength = 8.0\nreference_frame = \"free\"\n",
           "f.toml:13:19: blade.reference_frame: is \"free\", expected \"clamped\" or \"chord\""},
      });
}
