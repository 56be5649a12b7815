// Messages for joints, loads and sensors on solids.

#include <doctest/doctest.h>

#include <string>

#include "tests/models/reader/solid_texts.h"
#include "tests/models/reader/spatial_texts.h"

using namespace spoke;
using spoke::test::check_edits;
using spoke::test::kSolidText;

TEST_CASE("joints and loops name interfaces of solids") {
  const std::string hole =
      "[[subsystem.body.interface]]\nname = \"hole\"\nnodes = { cylinder = { point = [0.26, 0.05, "
      "0], axis = [0, 0, 1], radius = 0.025 } }\n";
  check_edits(
      kSolidText,
      {
          {"parent = \"bracket\"", "parent = \"bracket\"\ninterface = \"tp\"",
           "f.toml:33:13: subsystem.1.joint.2.interface: is \"tp\", did you mean \"tip\"?"},
          {"parent = \"bracket\"", "parent = \"bracket\"\nstation = 0.2",
           "f.toml:33:11: subsystem.1.joint.2.station: belongs to beams, expected interface on a "
           "parent that is a solid"},
          {"parent = \"bracket\"", "parent = \"bracket\"\nnode = 2",
           "f.toml:33:8: subsystem.1.joint.2.node: would be ignored, expected only on a parent "
           "that is a beam: give offset"},
          {"parent = \"hub\"", "parent = \"hub\"\ninterface = \"tip\"",
           "f.toml:29:13: subsystem.1.joint.1.interface: would be ignored, expected only on a "
           "parent that is a solid"},
          {"[[subsystem.body]]\nname = \"rotor\"", hole + "[[subsystem.body]]\nname = \"rotor\"",
           "f.toml:34:1: subsystem.1.joint.2.interface: is missing, expected \"root\", \"tip\" or "
           "\"hole\""},
          {"[[load]]",
           "[[subsystem.loop]]\nname = \"l\"\nkind = \"spherical\"\nfrom = { body = \"bracket\", "
           "interface = \"tp\" }\nto = \"hub\"\n[[load]]",
           "f.toml:39:40: subsystem.1.loop.1.from.interface: is \"tp\", did you mean \"tip\"?"},
          {"[[load]]",
           "[[subsystem.loop]]\nname = \"l\"\nkind = \"spherical\"\nfrom = { body = \"bracket\", "
           "station = 1 }\nto = \"hub\"\n[[load]]",
           "f.toml:39:38: subsystem.1.loop.1.from.station: belongs to beams, expected interface on "
           "a solid"},
          {"[[load]]",
           "[[subsystem.loop]]\nname = \"l\"\nkind = \"spherical\"\nfrom = { body = \"rotor\", "
           "interface = \"tip\" }\nto = \"hub\"\n[[load]]",
           "f.toml:39:38: subsystem.1.loop.1.from.interface: would be ignored, expected only on a "
           "solid"},
          {"[[load]]",
           "[[subsystem.loop]]\nname = \"l\"\nkind = \"spherical\"\nfrom = { body = \"bracket\" "
           "}\nto = { body = \"bracket\", interface = \"tip\" }\n[[load]]",
           "f.toml:40:6: subsystem.1.loop.1.to: is at the same interface of the same solid as "
           "from, expected another place"},
      });
}

TEST_CASE("loads on solids are checked") {
  check_edits(
      kSolidText,
      {
          {"nodes = \"TIP\"\ntraction", "interface = \"top\"\ntraction",
           "f.toml:39:13: load.1.interface: is \"top\", did you mean \"tip\"?"},
          {"nodes = \"TIP\"\ntraction", "nodes = \"TOP\"\ntraction",
           "f.toml:39:9: load.1.nodes: is \"TOP\", did you mean \"TIP\"?"},
          {"nodes = \"TIP\"\ntraction", "interface = \"tip\"\nnodes = \"TIP\"\ntraction",
           "f.toml:40:9: load.1.nodes: given along with interface, expected only one of them"},
          {"nodes = \"TIP\"\ntraction", "position = 0.3\ntraction",
           "f.toml:39:12: load.1.position: belongs to beams, expected interface or nodes on a "
           "solid"},
          {"nodes = \"TIP\"\ntraction", "point = [1, 0, 0]\ntraction",
           "f.toml:39:9: load.1.point: belongs to rigid bodies, expected interface or nodes on a "
           "solid"},
          {"nodes = \"TIP\"\ntraction = [0, 0, 100.0]",
           "nodes = { box = { from = [-0.001, -0.001, -0.001], to = [0.001, 0.001, 0.001] } "
           "}\ntraction = [0, 0, 100.0]",
           "f.toml:40:12: load.1.traction: is on nodes without faces, expected those of a surface, "
           "or force"},
          {"nodes = \"TIP\"\ntraction = [0, 0, 100.0]",
           "nodes = { box = { from = [-0.001, -0.001, -0.001], to = [0.001, 0.2, 0.001] } "
           "}\nmoment = [0, 0, 100.0]",
           "f.toml:40:10: load.1.moment: acts on nodes that are on one line, expected nodes that "
           "determine a turn"},
          {"traction = [0, 0, 100.0]", "traction = [0, 0, 100.0]\nforce = [1, 0, 0]",
           "f.toml:40:12: load.1.traction: given along with force or moment, expected only one of "
           "them"},
          {"traction = [0, 0, 100.0]", "traction = 100.0",
           "f.toml:40:12: load.1.traction: is 100.0, expected an array of 3 numbers (Pa)"},
          {"traction = [0, 0, 100.0]\n", "",
           "f.toml:36:1: load.1: has neither force nor moment, expected one of them as [x, y, z]"},
          {"body = \"bracket\"\nnodes", "body = \"rotor\"\nnodes",
           "f.toml:39:9: load.1.nodes: belongs to solids, expected point on a rigid body"},
          {"body = \"bracket\"\nnodes = \"TIP\"\ntraction",
           "body = \"rotor\"\ninterface = \"tip\"\nforce",
           "f.toml:39:13: load.1.interface: belongs to solids, expected point on a rigid body"},
          {"body = \"bracket\"\nnodes = \"TIP\"", "body = \"rotor\"",
           "f.toml:39:12: load.1.traction: belongs to solids, expected force"},
          {"[[load]]\nsubsystem = \"arm\"\nbody = \"bracket\"\nnodes = \"TIP\"\ntraction",
           "[[distributed_load]]\nsubsystem = \"arm\"\nbody = \"bracket\"\nforce_per_length",
           "f.toml:38:8: distributed_load.1.body: is a solid, expected a beam; [[load]] has nodes "
           "and traction for solids"},
      });
}

TEST_CASE("sensors on solids are checked") {
  check_edits(
      kSolidText,
      {
          {"quantity = \"displacement\"", "quantity = \"displacement\"\ninterface = \"tipp\"",
           "f.toml:43:13: sensor.1.interface: is \"tipp\", did you mean \"tip\"?"},
          {"quantity = \"displacement\"", "quantity = \"displacement\"\nnode = 100000",
           "f.toml:43:8: sensor.1.node: is 100000, expected the number of one of the 1009 nodes of "
           "the mesh"},
          {"quantity = \"displacement\"", "quantity = \"displacement\"\nnode = 0",
           "f.toml:43:8: sensor.1.node: is 0, expected a whole number from 1 to 2147483647"},
          {"quantity = \"displacement\"",
           "quantity = \"displacement\"\nnode = 3\ninterface = \"tip\"",
           "f.toml:43:8: sensor.1.node: given along with interface, expected only one of them"},
          {"quantity = \"displacement\"", "quantity = \"displacement\"\nposition = 0.3",
           "f.toml:43:12: sensor.1.position: belongs to beams, expected interface or node on a "
           "solid"},
          {"quantity = \"displacement\"", "quantity = \"section_force\"\nposition = 0.3",
           "f.toml:45:8: sensor.1.body: is a solid, expected a beam; \"interface_force\" is the "
           "force on a solid"},
          {"quantity = \"displacement\"", "quantity = \"interface_force\"",
           "f.toml:41:1: sensor.1.interface: is missing, expected the name of an interface"},
          {"quantity = \"displacement\"", "quantity = \"interface_force\"\nnode = 3",
           "f.toml:43:8: sensor.1.node: does not belong to quantity \"interface_force\", expected "
           "only with quantity \"displacement\", \"velocity\", \"acceleration\", \"von_mises\" or "
           "\"wind\""},
          {"quantity = \"displacement\"", "quantity = \"von_mises\"\nframe = \"hub\"",
           "f.toml:43:9: sensor.1.frame: does not belong to quantity \"von_mises\", expected only "
           "with quantity \"displacement\", \"velocity\", \"acceleration\", \"section_force\", "
           "\"joint_reaction\", \"hub_reaction\", \"loop_reaction\", \"loop_opening\" or "
           "\"interface_force\""},
          {"quantity = \"displacement\"", "quantity = \"von_mises\"\nposition = 0.1",
           "f.toml:43:12: sensor.1.position: does not belong to quantity \"von_mises\", expected "
           "only with quantity \"displacement\", \"velocity\", \"acceleration\", "
           "\"section_force\", \"air_flow\", \"air_load\" or \"wind\""},
          {"quantity = \"displacement\"", "quantity = \"joint_reaction\"\ninterface = \"tip\"",
           "f.toml:43:13: sensor.1.interface: does not belong to quantity \"joint_reaction\", "
           "expected only with quantity \"displacement\", \"velocity\", \"acceleration\", "
           "\"interface_force\", \"von_mises\" or \"wind\""},
          {"quantity = \"displacement\"\nsubsystem = \"arm\"\nbody = \"bracket\"",
           "quantity = \"von_mises\"\nsubsystem = \"arm\"\nbody = \"rotor\"",
           "f.toml:44:8: sensor.1.body: is no solid, which quantity \"von_mises\" belongs to"},
          {"quantity = \"displacement\"\nsubsystem = \"arm\"\nbody = \"bracket\"",
           "quantity = \"von_mises\"\nsubsystem = \"arm\"",
           "f.toml:41:1: sensor.1.body: is missing, expected the name of one of the subsystem"},
          {"quantity = \"displacement\"\nsubsystem = \"arm\"\nbody = \"bracket\"",
           "quantity = \"von_mises\"",
           "f.toml:41:1: sensor.1: is on blades, of which none is a solid; expected subsystem and "
           "body"},
          {"quantity = \"displacement\"\nsubsystem = \"arm\"\nbody = \"bracket\"",
           "quantity = \"velocity\"\nsubsystem = \"arm\"\nbody = \"rotor\"\ninterface = \"tip\"",
           "f.toml:45:13: sensor.1.interface: belongs to solids, expected position on a beam"},
          {"quantity = \"displacement\"\nsubsystem = \"arm\"\nbody = \"bracket\"",
           "quantity = \"velocity\"\nsubsystem = \"arm\"\nbody = \"rotor\"\nnode = 2",
           "f.toml:45:8: sensor.1.node: belongs to solids, expected position on a beam"},
          {"quantity = \"displacement\"", "quantity = \"von_misses\"",
           "f.toml:42:12: sensor.1.quantity: is \"von_misses\", expected \"displacement\", "
           "\"velocity\", \"acceleration\", \"section_force\", \"joint_reaction\", "
           "\"hub_reaction\", \"momentum\", \"blade_momentum\", \"kinetic_energy\", "
           "\"loop_reaction\", \"loop_opening\", \"interface_force\", "
           "\"von_mises\", \"air_flow\", \"air_load\", \"strain_energy\", \"coupling_force\" or "
           "\"wind\""},
      });
}

TEST_CASE("copies of subsystems are checked, and solids in the plane refused") {
  check_edits(
      kSolidText,
      {
          {"name = \"arm\"", "name = \"arm\"\ncount = 0",
           "f.toml:7:9: subsystem.1.count: is 0, expected a whole number from 1 to 100000"},
          {"name = \"arm\"", "name = \"arm\"\ncount = 2.5",
           "f.toml:7:9: subsystem.1.count: is 2.5, expected a whole number from 1 to 100000"},
          {"name = \"arm\"", "name = \"arm\"\nazimuth = \"x\"",
           "f.toml:7:11: subsystem.1.azimuth: is \"x\", expected a number (rad)"},
          {"name = \"arm\"", "name = \"" + std::string(64, 'a') + "\"\ncount = 2",
           "f.toml:6:8: subsystem.1.name: is "
           "\"aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa1\", expected "
           "letters, digits, \"_\", \"-\" and \".\", 1 to 64 of them"},
          {"[[load]]\nsubsystem = \"arm\"", "[[load]]\nsubsystem = \"arm1\"",
           "f.toml:37:13: load.1.subsystem: is \"arm1\", did you mean \"arm\"?"},
          {"world = \"space\"", "world = \"plane\"",
           "f.toml:9:8: subsystem.1.body.1.kind: is \"solid\", and solids belong to world = "
           "\"space\""},
      });
}
