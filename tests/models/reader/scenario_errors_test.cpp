// Messages for invalid scenarios: one line naming place, key, value and what was expected.

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "models/error.h"
#include "models/scenario.h"
#include "tests/models/reader/check_message.h"

using namespace spoke;
using test::check_message;

namespace {

// Line numbers of the cases below refer to this text.
const std::string kText = R"(title = "test"
[hub]
radius = 0.1
[hub.drive]
kind = "spin_up"
speed = 4.0
ramp = 15.0
[blade]
count = 3
length = 8.0
bodies = 4
elements = 4
density = 2766.67
area = 7.299e-5
second_moment = 8.214e-9
youngs_modulus = 6.895e10
[integration]
step = 0.005
duration = 20.0
[output]
interval = 0.05
)";

std::string error_of(const std::string& text, const Overrides& overrides = {}) {
  try {
    parse_scenario(text, "f.toml", overrides);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

/// Returns kText with one line replaced; the new text may have several lines or be empty.
std::string with(const std::string& line, const std::string& replacement) {
  std::string text = kText;
  const auto at = text.find(line + '\n');
  REQUIRE(at != std::string::npos);
  return text.replace(at, line.size(), replacement);
}

struct Edit {
  std::string line;         ///< line of kText
  std::string replacement;  ///< text in its place
  std::string message;      ///< expected
};

void check_edits(const std::vector<Edit>& edits) {
  for (const Edit& edit : edits) {
    CAPTURE(edit.replacement);
    check_message(error_of(with(edit.line, edit.replacement)), edit.message);
  }
}

/// Appends to kText; the appended text begins at line 22.
struct Addition {
  std::string text;
  std::string message;
};

void check_additions(const std::vector<Addition>& additions) {
  for (const Addition& addition : additions) {
    CAPTURE(addition.text);
    check_message(error_of(kText + addition.text), addition.message);
  }
}

}  // namespace

TEST_CASE("the text that the bad ones are made from is good") {
  CHECK(error_of(kText) == "accepted");
}

TEST_CASE("bad numbers are refused") {
  check_edits({
      {"length = 8.0", "length = -8.0",
       "f.toml:10:10: blade.length: is -8.0, expected a number greater than 0 (m)"},
      {"length = 8.0", "length = 0",
       "f.toml:10:10: blade.length: is 0, expected a number greater than 0 (m)"},
      {"length = 8.0", "length = \"8 m\"",
       "f.toml:10:10: blade.length: is \"8 m\", expected a number greater than 0 (m)"},
      {"length = 8.0", "length = true",
       "f.toml:10:10: blade.length: is true, expected a number greater than 0 (m)"},
      {"length = 8.0", "length = 1979-05-27",
       "f.toml:10:10: blade.length: is a date or time, expected a number greater than 0 (m)"},
      {"length = 8.0", "length = nan",
       "f.toml:10:10: blade.length: is nan, expected a finite number (m)"},
      {"length = 8.0", "length = inf",
       "f.toml:10:10: blade.length: is inf, expected a finite number (m)"},
      {"length = 8.0", "length = 1e300",
       "f.toml:10:10: blade.length: is 1e+300, expected 0 or a magnitude from 1e-40 to 1e+30 (m)"},
      {"area = 7.299e-5", "area = 1e-300",
       "f.toml:14:8: blade.area: is 1e-300, expected 0 or a magnitude from 1e-40 to 1e+30 (m^2)"},
      {"density = 2766.67", "density = -inf",
       "f.toml:13:11: blade.density: is -inf, expected a finite number (kg/m^3)"},
      {"radius = 0.1", "radius = -0.1",
       "f.toml:3:10: hub.radius: is -0.1, expected a number of 0 or more (m)"},
      {"radius = 0.1", "inertia = 0",
       "f.toml:3:11: hub.inertia: is 0, expected a number greater than 0 (kg m^2)"},
      {"interval = 0.05", "interval = -1",
       "f.toml:21:12: output.interval: is -1, expected a number of 0 or more (s)"},
      {"step = 0.005", "spectral_radius = 1.5",
       "f.toml:18:19: integration.spectral_radius: is 1.5, expected a number from 0 to 1"},
      {"step = 0.005", "tolerance = 0",
       "f.toml:18:13: integration.tolerance: is 0, expected a number greater than 0 (m, rad)"},
  });
}

TEST_CASE("bad sizes are refused") {
  check_edits({
      {"elements = 4", "elements = 0",
       "f.toml:12:12: blade.elements: is 0, expected a whole number from 1 to 100000"},
      {"bodies = 4", "bodies = -1",
       "f.toml:11:10: blade.bodies: is -1, expected a whole number from 1 to 100000"},
      {"bodies = 4", "bodies = 4.0",
       "f.toml:11:10: blade.bodies: is 4.0, expected a whole number from 1 to 100000"},
      {"bodies = 4", "bodies = 1000000000000",
       "f.toml:11:10: blade.bodies: is 1000000000000, expected a whole number from 1 to 100000"},
      {"count = 3", "count = 0",
       "f.toml:9:9: blade.count: is 0, expected a whole number from 1 to 100000"},
      {"elements = 4", "elements = 100001",
       "f.toml:12:12: blade.elements: is 100001, expected a whole number from 1 to 100000"},
      {"bodies = 4\nelements = 4", "bodies = 50000\nelements = 50000",
       "f.toml:8:1: blade: makes 7500000000 elements (blades x bodies x elements), expected at "
       "most "
       "20000000"},
      {"step = 0.005", "step = 1e-12",
       "f.toml:18:8: integration.step: makes 2e+13 steps, expected at most 1e+10"},
      {"step = 0.005", "step = 30",
       "f.toml:18:8: integration.step: the step is 30 s, expected at most the duration, 20 s"},
      {"step = 0.005\nduration = 20.0", "duration = 0.001",
       "f.toml:18:12: integration.duration: the step is 0.005 s, expected at most the duration, "
       "0.001 s"},
      {"step = 0.005", "max_iterations = 0",
       "f.toml:18:18: integration.max_iterations: is 0, expected a whole number from 1 to 1000"},
      {"duration = 20.0", "duration = 20.0\n[limits]\ndeflection = -0.1",
       "f.toml:21:14: limits.deflection: is -0.1, expected a number of 0 or more"},
      {"duration = 20.0", "duration = 20.0\n[limits]\non_energy_growth = 'fail'",
       "f.toml:21:20: limits.on_energy_growth: is \"fail\", expected \"warn\" or \"stop\""},
  });
}

TEST_CASE("the largest sizes are not refused by the reader") {
  CHECK(error_of(with("count = 3", "count = 100000")) == "accepted");
  CHECK(error_of(with("elements = 4", "elements = 100000")) == "accepted");
  CHECK(error_of(with("step = 0.005", "step = 2e-9")) == "accepted");
  CHECK(error_of(with("step = 0.005", "step = 20")) == "accepted");
}

TEST_CASE("unknown keys are refused with the nearest known one suggested") {
  check_edits({
      {"length = 8.0", "lenght = 8.0",
       "f.toml:10:1: blade.lenght: unknown key, did you mean \"length\"?"},
      {"title = \"test\"", "titel = \"test\"",
       "f.toml:1:1: titel: unknown key, did you mean \"title\"?"},
      {"[output]", "[outputs]", "f.toml:20:2: outputs: unknown key, did you mean \"output\"?"},
      {"[hub]", "[Hub]", "f.toml:2:2: Hub: unknown key, did you mean \"hub\"?"},
      {"speed = 4.0", "sped = 4.0",
       "f.toml:6:1: hub.drive.sped: unknown key, did you mean \"speed\"?"},
      {"step = 0.005", "timestep = 0.005",
       "f.toml:18:1: integration.timestep: unknown key, did you mean \"step\"?"},
      {"interval = 0.05", "file = \"a\"",
       "f.toml:21:1: output.file: unknown key, expected \"interval\""},
  });
}

TEST_CASE("missing keys are named with what they should be") {
  check_edits({
      {"length = 8.0", "",
       "f.toml:8:1: blade.length: is missing, expected a number greater than 0 (m)"},
      {"count = 3", "",
       "f.toml:8:1: blade.count: is missing, expected a whole number from 1 to 100000"},
      {"kind = \"spin_up\"", "",
       "f.toml:4:1: hub.drive.kind: is missing, expected \"spin_up\", \"spin_up_hold_spin_down\", "
       "\"torque\", \"free\", \"table\", \"fixed\", \"constant\" or \"torque_by_speed\""},
      {"ramp = 15.0", "",
       "f.toml:4:1: hub.drive.ramp: is missing, expected a number greater than 0 (s)"},
      {"radius = 0.1", "support = \"free\"",
       "f.toml:2:1: hub.mass: is missing, expected a number greater than 0 (kg)"},
      {"duration = 20.0", "",
       "f.toml:17:1: integration.duration: is missing, expected a number greater than 0 (s)"},
  });
  check_message(
      error_of("# nothing but a comment"),
      "f.toml:1:1: hub.drive.kind: is missing, expected \"spin_up\", "
      "\"spin_up_hold_spin_down\", \"torque\", \"free\", \"table\", \"fixed\", \"constant\" or "
      "\"torque_by_speed\"");
  check_message(error_of("hub.drive.kind = 'fixed'"),
                "f.toml:1:1: blade: is missing, expected [blade] or [[blades]]");
}

TEST_CASE("wrong words and wrong types are refused") {
  const std::string kinds =
      "expected \"spin_up\", \"spin_up_hold_spin_down\", \"torque\", \"free\", \"table\", "
      "\"fixed\", "
      "\"constant\" or \"torque_by_speed\"";
  check_edits({
      {"kind = \"spin_up\"", "kind = \"spinup\"",
       "f.toml:5:8: hub.drive.kind: is \"spinup\", " + kinds},
      {"kind = \"spin_up\"", "kind = 1", "f.toml:5:8: hub.drive.kind: is 1, " + kinds},
      {"radius = 0.1", "support = \"axel\"",
       "f.toml:3:11: hub.support: is \"axel\", expected \"axle\" or \"free\""},
      {"count = 3", "count = 3\nreference_frame = \"cord\"",
       "f.toml:10:19: blade.reference_frame: is \"cord\", expected \"clamped\" or \"chord\""},
      {"count = 3", "count = 3\ngeometric_stiffening = 1",
       "f.toml:10:24: blade.geometric_stiffening: is 1, expected true or false"},
      {"count = 3", "count = 3\nstrain = \"green\"",
       "f.toml:10:10: blade.strain: is \"green\", expected \"automatic\", \"linear\" or "
       "\"nonlinear\""},
      {"count = 3", "count = 3\nstrain = \"nonlinear\"\ngeometric_stiffening = false",
       "f.toml:11:24: blade.geometric_stiffening: is false, expected true, or strain = \"linear\": "
       "strains of second order make the tension that stiffens"},
      {"step = 0.005", "method = \"euler\"",
       "f.toml:18:10: integration.method: is \"euler\", expected \"generalized_alpha\" or \"rk4\""},
      {"title = \"test\"", "title = 3", "f.toml:1:9: title: is 3, expected text in quotes"},
  });
  check_message(error_of("gravity = 1\n" + kText),
                "f.toml:1:11: gravity: is 1, expected a table [gravity]");
}

TEST_CASE("keys of another kind of drive are refused") {
  check_edits({
      {"ramp = 15.0", "ramp = 15.0\ntorque = 3",
       "f.toml:8:10: hub.drive.torque: does not belong to kind \"spin_up\", expected only with "
       "kind "
       "\"torque\" or \"torque_by_speed\""},
      {"ramp = 15.0", "ramp = 15.0\nhold = 3",
       "f.toml:8:8: hub.drive.hold: does not belong to kind \"spin_up\", expected only with kind "
       "\"spin_up_hold_spin_down\""},
      {"kind = \"spin_up\"", "kind = \"free\"",
       "f.toml:6:9: hub.drive.speed: does not belong to kind \"free\", expected only with kind "
       "\"spin_up\", \"spin_up_hold_spin_down\", \"table\", \"constant\" or \"torque_by_speed\""},
      {"ramp = 15.0", "ramp = 15.0\ninitial_speed = 3",
       "f.toml:8:17: hub.drive.initial_speed: does not belong to kind \"spin_up\", expected only "
       "with kind \"torque\", \"free\" or \"torque_by_speed\""},
  });
}

TEST_CASE("bad tables of a drive are refused") {
  const std::string kind_and_rest = "kind = \"spin_up\"\nspeed = 4.0\nramp = 15.0";
  check_edits({
      {kind_and_rest, "kind = \"table\"\ntime = [0, 1]\nspeed = 4",
       "f.toml:7:9: hub.drive.speed: is 4, expected an array of numbers (rad/s)"},
      {kind_and_rest, "kind = \"table\"\nspeed = [0, 4]",
       "f.toml:4:1: hub.drive.time: is missing, expected an array of numbers (s)"},
      {kind_and_rest, "kind = \"table\"\ntime = [0, 2, 1]\nspeed = [0, 1, 2]",
       "f.toml:6:15: hub.drive.time.3: is 1, expected more than the value before it, 2"},
      {kind_and_rest, "kind = \"table\"\ntime = [0, 1, 2]\nspeed = [0, 1]",
       "f.toml:7:9: hub.drive.speed: has 2 numbers, expected 3, one for each of hub.drive.time"},
      {kind_and_rest, "kind = \"table\"\ntime = [0, 1]\nspeed = [0, nan]",
       "f.toml:7:13: hub.drive.speed.2: is nan, expected a finite number (rad/s)"},
      {kind_and_rest, "kind = \"table\"\ntime = []\nspeed = []",
       "f.toml:6:8: hub.drive.time: is an empty array, expected an array of numbers (s)"},
      {kind_and_rest, "kind = \"torque\"\ntorque = [1, 2]",
       "f.toml:6:10: hub.drive.torque: is an array (2), expected a number (N m), or with an array "
       "also the array time (s)"},
      {kind_and_rest, "kind = \"torque\"",
       "f.toml:4:1: hub.drive.torque: is missing, expected a number (N m)"},
  });
}

TEST_CASE("more loads than a machine could hold are refused") {
  std::string text = with("count = 3", "count = 1000");
  for (int k = 0; k < 2001; ++k) text += "[[load]]\nmoment = 1\n";
  check_message(
      error_of(text),
      "f.toml:4022:1: load.2001: makes 2001000 points (loads x blades x times) with those "
      "before it, expected at most 2000000");
}

TEST_CASE("bad loads and gravity are refused") {
  check_additions({
      {"[[load]]\n",
       "f.toml:22:1: load.1: has neither force nor moment, expected force = [x, y] or "
       "moment = M"},
      {"[[load]]\nforce = [1]\n",
       "f.toml:23:9: load.1.force: is an array (1), expected an array of 2 numbers (N)"},
      {"[[load]]\nforce = [1, \"x\"]\n",
       "f.toml:23:13: load.1.force.2: is \"x\", expected a number (N)"},
      {"[[load]]\nmoment = 1\nblade = 4\n",
       "f.toml:24:9: load.1.blade: is 4, expected a whole number from 1 to 3"},
      {"[[load]]\nmoment = 1\nblade = \"each\"\n",
       "f.toml:24:9: load.1.blade: is \"each\", expected \"all\""},
      {"[[load]]\nmoment = 1\n[[load]]\nmoment = 1\nposition = 8.5\n",
       "f.toml:26:12: load.2.position: is 8.5, expected a number from 0 to 8 (m, from root to tip "
       "of the blade)"},
      {"[[load]]\nmoment = 1\nframe = \"body\"\n",
       "f.toml:24:9: load.1.frame: is \"body\", expected \"inertial\", \"hub\" or \"section\""},
      {"[[load]]\nmoment = 1\nfactor = [0, 1]\n",
       "f.toml:22:1: load.1.time: is missing, expected an array of numbers (s)"},
      {"[load]\nmoment = 1\n", "f.toml:22:1: load: is a table, expected tables headed [[load]]"},
      {"[gravity]\nacceleration = 9.81\n",
       "f.toml:23:16: gravity.acceleration: is 9.81, expected an array of 2 numbers (m/s^2)"},
      {"[damping]\nmass_factor = -1\n",
       "f.toml:23:15: damping.mass_factor: is -1, expected a number of 0 or more (1/s)"},
      {"[damping]\nmass_factor = 0.1\n",
       "f.toml:23:15: damping.mass_factor: damps motion relative to each body's own frame, next to "
       "none of a blade of several bodies; expected 0, or bodies = 1: stiffness_factor damps any "
       "number of bodies alike, [[drag]] relative to the hub the motion in the hub's frame"},
  });
}

TEST_CASE("blades given in both ways or wrongly are refused") {
  check_additions({
      {"[[blades]]\n",
       "f.toml:9:9: blade.count: given along with [[blades]], expected only one of them"},
      {"[blades]\nlength = 3\n",
       "f.toml:22:1: blades: is a table, expected tables headed [[blades]]"},
      {"[[blades]]\ncount = 3\n",
       "f.toml:23:1: blades.1.count: unknown key, expected \"length\", \"bodies\", "
       "\"elements\", \"density\", \"area\", \"second_moment\", \"youngs_modulus\", "
       "\"geometric_stiffening\", \"reference_frame\", \"strain\", \"azimuth\", \"sections\", "
       "\"point_mass\" or \"loop\""},
  });
  check_edits({
      {"[blade]", "[[blade]]",
       "f.toml:8:1: blade: is an array of tables (1), expected a table [blade]"},
      {"count = 3\nlength = 8.0", "[[blades]]\n",
       "f.toml:9:1: blades.1.length: is missing, expected a number greater than 0 (m)"},
  });
  check_message(error_of("blades = []\nhub.drive.kind = 'free'"),
                "f.toml:1:10: blades: is an empty array, expected tables headed [[blades]]");
}

TEST_CASE("text that is not TOML is refused with its place") {
  const std::vector<Edit> edits = {
      {"length = 8.0", "length 8.0", "f.toml:10:8: not TOML: "},
      {"length = 8.0", "length = ", "f.toml:10:10: not TOML: "},
      {"[hub]", "[hub", "f.toml:2:5: not TOML: "},
      {"title = \"test\"", "title = \"test", "f.toml:1:14: not TOML: "},
      {"radius = 0.1", "radius = 0.1\nradius = 0.2", "f.toml:4:10: not TOML: "},
      {"radius = 0.1", "radius = 1e", "f.toml:3:12: not TOML: "},
      {"radius = 0.1", "radius = 99999999999999999999", "f.toml:3:30: not TOML: "},
      {"radius = 0.1", "radius = \xFF\xFE", "f.toml:3:9: not TOML: "},
      {"[hub]", "[hub.drive]", "f.toml:4:"},
  };
  for (const Edit& edit : edits) {
    const std::string message = error_of(with(edit.line, edit.replacement));
    CAPTURE(message);
    CHECK(message.starts_with(edit.message));
    CHECK(message.find(": not TOML: ") != std::string::npos);
    CHECK(message.find('\n') == std::string::npos);
  }
  check_message(error_of(std::string("title = \"a\0b\"", 13)),
                "f.toml: has a zero byte at 10, expected a text file (TOML in UTF-8)");
}

TEST_CASE("bad overrides are refused with the override as their place") {
  const auto error = [](const std::string& assignment) { return error_of(kText, {assignment}); };
  check_message(error("blade.bodies=-1"),
                "--set blade.bodies=-1: blade.bodies: is -1, expected a whole number from 1 to "
                "100000");
  check_message(
      error("blade.bodies=many"),
      "--set blade.bodies=many: blade.bodies: is \"many\", expected a whole number from 1 "
      "to 100000");
  check_message(error("blade.body=8"),
                "--set blade.body=8: blade.body: unknown key, did you mean \"bodies\"?");
  check_message(
      error("load.1.force=[0,1"),
      "--set load.1.force=[0,1: load.1.force: is \"[0,1\", expected an array of 2 numbers "
      "(N)");
  check_message(error("load.2.force=[0,1]"),
                "--set load.2.force=[0,1]: load: is an array of 0 values, expected the index 1 "
                "instead of \"2\"");
  check_message(error("blade"),
                "--set blade: has no '=', expected key=value, for example blade.bodies=8");
  check_message(error("hub.drive.kind=free"),
                "f.toml:6:9: hub.drive.speed: does not belong to kind \"free\", expected only with "
                "kind \"spin_up\", \"spin_up_hold_spin_down\", \"table\", \"constant\" or "
                "\"torque_by_speed\"");
  check_message(error("blades.1.length=7"),
                "f.toml:9:9: blade.count: given along with [[blades]], expected only one of them");
}

TEST_CASE("an error has the place that its sentence names as fields") {
  const auto place_of = [](const std::string& text, const Overrides& overrides) {
    try {
      parse_scenario(text, "f.toml", overrides);
    } catch (const InputError& error) {
      return error.place();
    }
    return InputPlace{};
  };
  const InputPlace in_file = place_of(with("length = 8.0", "length = -8.0"), {});
  CHECK(in_file.file == "f.toml");
  CHECK(in_file.line == 10);
  CHECK(in_file.column == 10);
  CHECK(in_file.key == "blade.length");
  const InputPlace overridden = place_of(kText, {"blade.length=-8"});
  CHECK(overridden.file.empty());
  CHECK(overridden.line == 0);
  CHECK(overridden.key == "blade.length");
  const InputPlace no_toml = place_of("a = 1\nb = [", {});
  CHECK(no_toml.line == 2);
  CHECK(no_toml.key.empty());
}
