// Messages for air, aerofoils and the aerodynamics of blades that cannot be.

#include <doctest/doctest.h>

#include "tests/models/reader/air_texts.h"
#include "tests/models/reader/spatial_texts.h"

using namespace spoke;
using spoke::test::check_edits;
using spoke::test::kAirText;

TEST_CASE("the aerodynamics of blades that cannot be are refused") {
  check_edits(
      kAirText,
      {
          {"station = [1.0, 4.0, 8.0]", "station = [1.0]",
           "f.toml:17:11: blade.aerodynamics.station: has 1 value, expected 2 or more"},
          {"station = [1.0, 4.0, 8.0]", "station = [1.0, 4.0, 8.5]",
           "f.toml:17:22: blade.aerodynamics.station.3: is 8.5, expected at most the blade's "
           "length, 8 (m)"},
          {"station = [1.0, 4.0, 8.0]", "station = [4.0, 1.0, 8.0]",
           "f.toml:17:17: blade.aerodynamics.station.2: is 1.0, expected more than the value "
           "before it, 4"},
          {"station = [1.0, 4.0, 8.0]", "station = [-1.0, 4.0, 8.0]",
           "f.toml:17:12: blade.aerodynamics.station.1: is -1.0, expected a number of 0 or more "
           "(m)"},
          {"station = [1.0, 4.0, 8.0]", "station = [1.0, 4.0, nan]",
           "f.toml:17:22: blade.aerodynamics.station.3: is nan, expected a finite number (m)"},
          {"station = [1.0, 4.0, 8.0]", "station = \"all\"",
           "f.toml:17:11: blade.aerodynamics.station: is \"all\", expected an array of numbers "
           "(m)"},
          {"station = [1.0, 4.0, 8.0]\n", "",
           "f.toml:16:1: blade.aerodynamics.station: is missing, expected an array of numbers (m)"},
          {"chord = [0.6, 0.5, 0.3]", "chord = [0.6, 0.5]",
           "f.toml:18:9: blade.aerodynamics.chord: has 2 values, expected 3, one for each station"},
          {"chord = [0.6, 0.5, 0.3]", "chord = [0.6, -0.5, 0.3]",
           "f.toml:18:15: blade.aerodynamics.chord.2: is -0.5, expected a number of 0 or more (m)"},
          {"chord = [0.6, 0.5, 0.3]", "chord = -1",
           "f.toml:18:9: blade.aerodynamics.chord: is -1, expected a number of 0 or more (m)"},
          {"chord = [0.6, 0.5, 0.3]\n", "",
           "f.toml:16:1: blade.aerodynamics.chord: is missing, expected one number for each "
           "station"},
          {"chord = [0.6, 0.5, 0.3]", "chords = [0.6, 0.5, 0.3]",
           "f.toml:18:1: blade.aerodynamics.chords: unknown key, did you mean \"chord\"?"},
          {"twist = [0.2, 0.1, 0.0]", "twist = [0.2]",
           "f.toml:19:9: blade.aerodynamics.twist: has 1 value, expected 3, one for each station"},
          {"twist = [0.2, 0.1, 0.0]", "twist = [0.2, inf, 0.0]",
           "f.toml:19:15: blade.aerodynamics.twist.2: is inf, expected a finite number (rad)"},
          {"center = [0.0, 0.01, 0.02]", "center = [0.0, 0.01, 0.02, 0.03]",
           "f.toml:20:10: blade.aerodynamics.center: has 4 values, expected 3, one for each "
           "station"},
          {"airfoil = [\"thick\", \"plate\", \"plate\"]", "airfoil = [\"thick\", \"plate\"]",
           "f.toml:21:11: blade.aerodynamics.airfoil: has 2 values, expected 3, one for each "
           "station"},
          {"airfoil = [\"thick\", \"plate\", \"plate\"]", "airfoil = [\"thick\", 3, \"plate\"]",
           "f.toml:21:11: blade.aerodynamics.airfoil: is an array (3), expected an array of names "
           "of aerofoils, or one name"},
          {"airfoil = [\"thick\", \"plate\", \"plate\"]", "airfoil = []",
           "f.toml:21:11: blade.aerodynamics.airfoil: is an empty array, expected an array of "
           "values"},
          {"airfoil = [\"thick\", \"plate\", \"plate\"]",
           "airfoil = [\"thick\", \"plat\", \"plate\"]",
           "f.toml:21:21: blade.aerodynamics.airfoil.2: is \"plat\", but there is no [[airfoil]] "
           "of that name and no file plat"},
          {"airfoil = [\"thick\", \"plate\", \"plate\"]", "airfoil = \"DU40.dat\"",
           "f.toml:21:11: blade.aerodynamics.airfoil.1: is \"DU40.dat\", but there is no "
           "[[airfoil]] of that name and no file DU40.dat"},
          {"airfoil = [\"thick\", \"plate\", \"plate\"]\n", "",
           "f.toml:16:1: blade.aerodynamics.airfoil: is missing, expected an array of names of "
           "aerofoils, or one name"},
          {"leading_edge = \"+y\"", "leading_edge = \"+z\"",
           "f.toml:22:16: blade.aerodynamics.leading_edge: is \"+z\", expected \"+y\" or \"-y\""},
          {"leading_edge = \"+y\"", "leading_edge = 1",
           "f.toml:22:16: blade.aerodynamics.leading_edge: is 1, expected \"+y\" or \"-y\""},
          {"[blade.aerodynamics]", "[[blade.aerodynamics]]",
           "f.toml:16:1: blade.aerodynamics: is an array of tables (1), expected a table "
           "[blade.aerodynamics]"},
      });
}

TEST_CASE("aerofoils that cannot be are refused") {
  check_edits(
      kAirText,
      {
          {"name = \"thick\"\n", "", "f.toml:23:1: airfoil.1.name: is missing, expected a name"},
          {"name = \"thick\"", "name = \"\"",
           "f.toml:24:8: airfoil.1.name: is missing, expected a name"},
          {"name = \"thick\"", "name = \"plate\"",
           "f.toml:21:12: blade.aerodynamics.airfoil.1: is \"thick\", but there is no [[airfoil]] "
           "of that name and no file thick"},
          {"name = \"thick\"", "name = \"thick\"\nfile = \"a.dat\"",
           "f.toml:23:1: airfoil.1: has polars more than once, expected one of file, polar, or "
           "angle with lift and drag"},
          {"angle = [-3.141592653589793, 0.0, 3.141592653589793]\nlift = [0.0, 0.0, 0.0]\ndrag = "
           "[0.5, 0.5, 0.5]\n",
           "",
           "f.toml:23:1: airfoil.1: has no polar, expected one of file, polar, or angle with lift "
           "and drag"},
          {"angle = [-3.141592653589793, 0.0, 3.141592653589793]\nlift = [0.0, 0.0, 0.0]\ndrag = "
           "[0.5, 0.5, 0.5]",
           "file = \"none.dat\"",
           "f.toml:25:8: airfoil.1.file: is \"none.dat\", but there is no file none.dat, expected "
           "a file of polars"},
          {"angle = [-3.141592653589793, 0.0, 3.141592653589793]\nlift = [0.0, 0.0, 0.0]\ndrag = "
           "[0.5, 0.5, 0.5]",
           "file = 3", "f.toml:25:8: airfoil.1.file: is 3, expected text in quotes"},
          {"angle = [-3.141592653589793, 0.0, 3.141592653589793]",
           "angle = [-3.141592653589793, 3.141592653589793]",
           "f.toml:25:9: airfoil.1.angle: has 2 values, expected 3 or more"},
          {"angle = [-3.141592653589793, 0.0, 3.141592653589793]",
           "angle = [-3.0, 0.0, 3.141592653589793]",
           "f.toml:25:10: airfoil.1.angle.1: is -3, expected -pi as the first, -3.141592653589793 "
           "(rad)"},
          {"angle = [-3.141592653589793, 0.0, 3.141592653589793]", "angle = [-180.0, 0.0, 180.0]",
           "f.toml:25:10: airfoil.1.angle.1: is -180, expected -pi as the first, "
           "-3.141592653589793 "
           "(rad): degrees?"},
          {"angle = [-3.141592653589793, 0.0, 3.141592653589793]",
           "angle = [-3.141592653589793, 3.141592653589793, 0.0]",
           "f.toml:25:49: airfoil.1.angle.3: is 0, expected more than the one before, "
           "3.141592653589793 (rad)"},
          {"angle = [-3.141592653589793, 0.0, 3.141592653589793]", "angle = \"all\"",
           "f.toml:25:9: airfoil.1.angle: is \"all\", expected an array of numbers (rad)"},
          {"lift = [0.0, 0.0, 0.0]", "lift = [0.0, 0.0]",
           "f.toml:26:8: airfoil.1.lift: has 2 values, expected one for each of 3 angles of "
           "attack"},
          {"lift = [0.0, 0.0, 0.0]", "lift = [0.0, 0.0, 0.4]",
           "f.toml:26:19: airfoil.1.lift.3: is 0.4 at pi, expected 0 as at -pi"},
          {"lift = [0.0, 0.0, 0.0]", "lift = [0.0, nan, 0.0]",
           "f.toml:26:14: airfoil.1.lift.2: is nan, expected a finite number"},
          {"lift = [0.0, 0.0, 0.0]\n", "",
           "f.toml:23:1: airfoil.1.lift: is missing, expected an array of numbers"},
          {"drag = [0.5, 0.5, 0.5]", "drag = [0.5, -0.1, 0.5]",
           "f.toml:27:14: airfoil.1.drag.2: is -0.1, expected 0 to 100"},
          {"drag = [0.5, 0.5, 0.5]", "drag = [0.5]",
           "f.toml:27:8: airfoil.1.drag: has 1 values, expected one for each of 3 angles of "
           "attack"},
          {"drag = [0.5, 0.5, 0.5]", "drag = [0.5, 0.5, 0.5]\nmoment = [0.0]",
           "f.toml:28:10: airfoil.1.moment: has 1 values, expected one for each of 3 angles of "
           "attack"},
          {"drag = [0.5, 0.5, 0.5]", "drag = [0.5, 0.5, 0.5]\nreynolds = -1.0",
           "f.toml:28:12: airfoil.1.reynolds: is -1.0, expected a number of 0 or more"},
          {"lift = [0.0, -1.2, 0.0, 1.2, 0.0]", "lift = [0.0, -120.0, 0.0, 1.2, 0.0]",
           "f.toml:39:14: airfoil.2.polar.2.lift.2: is -120, expected -100 to 100"},
          {"reynolds = 1e6", "reynolds = 1e5",
           "f.toml:37:12: airfoil.2.polar.2.reynolds: is 1e+05, expected more than that of the "
           "polar before"},
          {"reynolds = 1e6\n", "",
           "f.toml:36:1: airfoil.2.polar.2.reynolds: is missing, expected one, as there are "
           "several polars"},
          {"reynolds = 1e6", "reynold = 1e6",
           "f.toml:37:1: airfoil.2.polar.2.reynold: unknown key, did you mean \"reynolds\"?"},
      });
}

TEST_CASE("air that cannot be is refused") {
  check_edits(
      kAirText,
      {
          {"density = 1.2", "density = 0.0",
           "f.toml:42:11: air.density: is 0.0, expected a number greater than 0 (kg/m^3)"},
          {"density = 1.2", "density = \"thick\"",
           "f.toml:42:11: air.density: is \"thick\", expected a number greater than 0 (kg/m^3)"},
          {"density = 1.2", "densty = 1.2",
           "f.toml:42:1: air.densty: unknown key, did you mean \"density\"?"},
          {"viscosity = 1.5e-5", "viscosity = -1e-5",
           "f.toml:43:13: air.viscosity: is -1e-05, expected a number greater than 0 (m^2/s)"},
          {"[air]\ndensity = 1.2\nviscosity = 1.5e-5\n", "",
           "f.toml:41:1: wind: acts in air, expected [air] along with it"},
          {"[air]", "[[air]]",
           "f.toml:41:1: air: is an array of tables (1), expected a table [air]"},
          {"velocity = [0.0, 0.0, 8.0]", "velocity = [0.0, 8.0]",
           "f.toml:45:12: wind.velocity: is an array (2), expected an array of 3 numbers (m/s)"},
          {"velocity = [0.0, 0.0, 8.0]", "velocity = 8.0",
           "f.toml:45:12: wind.velocity: is 8.0, expected an array of 3 numbers (m/s)"},
          {"velocity = [0.0, 0.0, 8.0]", "file = \"none.bts\"",
           "f.toml:45:8: wind.file: is \"none.bts\", but there is no file none.bts, expected a "
           "file of TurbSim (.bts) or a table of wind"},
          {"velocity = [0.0, 0.0, 8.0]", "velocity = [0.0, 0.0, 8.0]\nshear_exponent = 0.2",
           "f.toml:45:12: wind.velocity: is along up, expected a wind across it, which has a "
           "profile of heights"},
          {"velocity = [0.0, 0.0, 8.0]", "velocty = [0.0, 0.0, 8.0]",
           "f.toml:45:1: wind.velocty: unknown key, did you mean \"velocity\"?"},
          {"induction = \"momentum\"", "induction = \"vortex\"",
           "f.toml:47:13: aerodynamics.induction: is \"vortex\", expected \"momentum\" or "
           "\"none\""},
          {"inflow = \"dynamic\"", "inflow = \"steady\"",
           "f.toml:48:10: aerodynamics.inflow: is \"steady\", expected \"dynamic\" or "
           "\"quasi_steady\""},
          {"inflow = \"dynamic\"", "inflow_factor = 0.9",
           "f.toml:48:17: aerodynamics.inflow_factor: is 0.9, expected a number from 1 to 2"},
          {"stall = \"dynamic\"", "stall = \"quasi_steady\"",
           "f.toml:49:9: aerodynamics.stall: is \"quasi_steady\", expected \"dynamic\" or "
           "\"static\""},
          {"stall = \"dynamic\"", "stal = \"dynamic\"",
           "f.toml:49:1: aerodynamics.stal: unknown key, did you mean \"stall\"?"},
          {"world = \"space\"\n", "world = \"plane\"\n",
           "f.toml:41:1: air: belongs to another world, expected world = \"space\""},
          {"[blade.aerodynamics]\nstation = [1.0, 4.0, 8.0]\nchord = [0.6, 0.5, 0.3]\ntwist = "
           "[0.2, 0.1, 0.0]\ncenter = [0.0, 0.01, 0.02]\nairfoil = [\"thick\", \"plate\", "
           "\"plate\"]\nleading_edge = \"+y\"\n",
           "",
           "f.toml:34:1: air: acts on no blade, expected [blade.aerodynamics] of one or more, or "
           "drag of a body"},
          {"[[sensor]]\nname = \"mid\"\nquantity = \"air_flow\"",
           "[[sensor]]\nname = \"mid\"\nquantity = \"air_flows\"",
           "f.toml:52:12: sensor.1.quantity: is \"air_flows\", expected \"displacement\", "
           "\"velocity\", \"acceleration\", \"section_force\", \"joint_reaction\", "
           "\"hub_reaction\", \"momentum\", \"blade_momentum\", \"kinetic_energy\", "
           "\"loop_reaction\", \"loop_opening\", \"interface_force\", \"von_mises\", \"air_flow\", "
           "\"air_load\", \"strain_energy\", \"coupling_force\" or \"wind\""},
          {"position = 4.0", "position = 9.0",
           "f.toml:54:12: sensor.1.position: is 9, expected a number from 0 to 8 (m, from root to "
           "tip)"},
          {"position = 4.0", "joint = 1",
           "f.toml:54:9: sensor.1.joint: does not belong to quantity \"air_flow\", expected only "
           "with quantity \"joint_reaction\""},
          {"position = 4.0", "frame = \"hub\"",
           "f.toml:54:9: sensor.1.frame: does not belong to quantity \"air_flow\", expected only "
           "with quantity \"displacement\", \"velocity\", \"acceleration\", \"section_force\", "
           "\"joint_reaction\", \"hub_reaction\", \"loop_reaction\", \"loop_opening\" or "
           "\"interface_force\""},
          {"blade = 1\n", "subsystem = \"arm\"\n",
           "f.toml:53:13: sensor.1.subsystem: does not belong to quantity \"air_flow\", expected "
           "none"},
          {"blade = 1\n", "blade = 4\n",
           "f.toml:53:9: sensor.1.blade: is 4, expected a whole number from 1 to 3"},
      });
}
