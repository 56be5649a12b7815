// Messages for invalid joints, trees and loads in space.

#include <doctest/doctest.h>

#include <string>

#include "tests/models/reader/spatial_texts.h"

using namespace spoke;
using spoke::test::check_edits;
using spoke::test::kBladeText;
using spoke::test::kTreeText;

TEST_CASE("joints of a blade that cannot be are refused") {
  check_edits(
      kBladeText,
      {
          {"station = 0.5", "station = 8.0",
           "f.toml:29:11: blade.joint.2.station: is 8, expected 0 or more, and less than the "
           "length, 8 (m)"},
          {"station = 0.5", "station = -1",
           "f.toml:29:11: blade.joint.2.station: is -1, expected a number of 0 or more (m)"},
          {"station = 0.5", "station = 0.3",
           "f.toml:29:11: blade.joint.2.station: is 0.3, where the joint before it is; expected a "
           "part of the blade between two joints, or one joint of kind \"universal\" or "
           "\"spherical\""},
          {"station = 0.5", "station = 0.2",
           "f.toml:29:11: blade.joint.2.station: is 0.2, expected more than that of the joint "
           "before it, 0.3"},
          {"name = \"pitch\"", "name = \"flap\"",
           "f.toml:28:8: blade.joint.2.name: is \"flap\" as another joint's, expected a name of "
           "its own"},
          {"name = \"pitch\"", "name = \"the pitch\"",
           "f.toml:28:8: blade.joint.2.name: is \"the pitch\", expected letters, digits, \"_\", "
           "\"-\" and \".\", 1 to 64 of them"},
          {"kind = \"revolute\"\naxis = [0, -1, 0]", "kind = \"hinge\"\naxis = [0, -1, 0]",
           "f.toml:24:8: blade.joint.1.kind: is \"hinge\", expected \"fixed\", \"revolute\", "
           "\"universal\", \"spherical\", \"prismatic\", \"cylindrical\" or \"bushing\""},
          {"axis = [0, -1, 0]", "axis = [0, 0, 0]",
           "f.toml:25:8: blade.joint.1.axis: has length 0, expected a direction"},
          {"axis = [0, -1, 0]\n", "",
           "f.toml:21:1: blade.joint.1.axis: is missing, expected an array of 3 numbers"},
          {"kind = \"revolute\"\naxis = [0, -1, 0]", "kind = \"spherical\"\naxis = [0, -1, 0]",
           "f.toml:25:8: blade.joint.1.axis: does not belong to kind \"spherical\", expected only "
           "with kind \"revolute\", \"prismatic\" or \"cylindrical\""},
          {"kind = \"revolute\"\naxis = [0, -1, 0]\ndamping = 10.0",
           "kind = \"universal\"\naxes = [[0, 1, 0], [0, 2, 0]]",
           "f.toml:25:8: blade.joint.1.axes: are parallel, expected two directions that differ"},
          {"kind = \"revolute\"\naxis = [0, -1, 0]\ndamping = 10.0",
           "kind = \"universal\"\naxes = [[0, 1, 0], [0, 0, 0]]",
           "f.toml:25:20: blade.joint.1.axes.2: has length 0, expected a direction"},
          {"kind = \"revolute\"\naxis = [0, -1, 0]\ndamping = 10.0",
           "kind = \"universal\"\naxes = [[0, 1, 0]]",
           "f.toml:25:8: blade.joint.1.axes: is an array (1), expected 2 arrays of 3 numbers"},
          {"kind = \"revolute\"\naxis = [0, -1, 0]\ndamping = 10.0",
           "kind = \"universal\"\naxes = [[0, 1, 0], [0, 0, 1]]\ndamping = 10.0",
           "f.toml:26:11: blade.joint.1.damping: is 10.0, expected an array of 2 numbers (N m "
           "s/rad)"},
          {"damping = 10.0", "damping = -10.0",
           "f.toml:26:11: blade.joint.1.damping: is -10.0, expected a number of 0 or more (N m "
           "s/rad)"},
          {"damping = 10.0", "force = 3",
           "f.toml:26:9: blade.joint.1.force: does not belong to kind \"revolute\", expected only "
           "with kind \"prismatic\" or \"cylindrical\""},
          {"damping = 10.0", "torque = { time = [0, 1], value = [0] }",
           "f.toml:26:35: blade.joint.1.torque.value: has 1 number, expected 2, one for each of "
           "blade.joint.1.torque.time"},
          {"damping = 10.0", "stop = { lower = 0.2, upper = 0.1, stiffness = 1e5, width = 0.01 }",
           "f.toml:26:31: blade.joint.1.stop.upper: is 0.1, expected more than lower, 0.2"},
          {"damping = 10.0", "stop = { lower = 0.1, upper = 0.2, stiffness = 1e5 }",
           "f.toml:26:8: blade.joint.1.stop.width: is missing, expected a number greater than 0 "
           "(rad)"},
          {"damping = 10.0", "friction = { force = 2 }",
           "f.toml:26:12: blade.joint.1.friction.speed: is missing, expected a number greater than "
           "0 (rad/s)"},
          {"damping = 10.0", "friction = { force = 2, speed = 0.1, static = 1, stribeck = 1 }",
           "f.toml:26:47: blade.joint.1.friction.static: is 1, expected force or more, 2"},
          {"damping = 10.0", "friction = { force = 2, speed = 0.1, static = 3 }",
           "f.toml:26:12: blade.joint.1.friction.stribeck: is missing, expected the speed over "
           "which the force falls from static to force"},
          {"damping = 10.0", "friction = { force = 2, speed = 0.1, stribeck = 3 }",
           "f.toml:26:49: blade.joint.1.friction.stribeck: would be ignored, expected only with "
           "static"},
          {"motion = { mean = 0.1 }",
           "motion = { mean = 0.1 }\nfriction = { force = 2, speed = 1 }",
           "f.toml:33:12: blade.joint.2.friction: given along with motion, expected only one of "
           "them: what is prescribed needs no spring, damper, stop, effort or start"},
          {"motion = { mean = 0.1 }", "motion = { mean = 0.1 }\nstiffness = 3.0",
           "f.toml:33:13: blade.joint.2.stiffness: given along with motion, expected only one of "
           "them: what is prescribed needs no spring, damper, stop, effort or start"},
          {"motion = { mean = 0.1 }", "motion = { mean = 0.1 }\ninitial = 0.1",
           "f.toml:33:11: blade.joint.2.initial: given along with motion, expected only one of "
           "them: what is prescribed needs no spring, damper, stop, effort or start"},
          {"motion = { mean = 0.1 }", "motion = { mean = 0.1, constant = 0.1 }",
           "f.toml:32:19: blade.joint.2.motion.mean: given along with constant, expected only one "
           "kind of motion"},
          {"motion = { mean = 0.1 }", "motion = { by = \"hand\" }",
           "f.toml:32:17: blade.joint.2.motion.by: is \"hand\", expected \"program\""},
          {"motion = { mean = 0.1 }", "motion = {}",
           "f.toml:32:10: blade.joint.2.motion: is empty, expected constant, time and value, mean, "
           "cosine and sine, or by = \"program\""},
          {"motion = { mean = 0.1 }", "motion = { time = [0, 1], value = [0, 1, 2] }",
           "f.toml:32:35: blade.joint.2.motion.value: has 3 numbers, expected 2, one for each of "
           "blade.joint.2.motion.time"},
          {"motion = { mean = 0.1 }", "motion = { cosin = 0.1 }",
           "f.toml:32:12: blade.joint.2.motion.cosin: unknown key, did you mean \"cosine\"?"},
          {"kind = \"revolute\"\naxis = [0, -1, 0]\ndamping = 10.0",
           "kind = \"cylindrical\"\naxis = [1, 0, 0]\nstop = {}",
           "f.toml:26:8: blade.joint.1.stop: is a table, expected an array of 2 tables, one for "
           "each coordinate; {} for one that has none"},
          {"kind = \"revolute\"\naxis = [0, -1, 0]\ndamping = 10.0",
           "kind = \"cylindrical\"\naxis = [1, 0, 0]\nmotion = [{ mean = 1 }]",
           "f.toml:26:10: blade.joint.1.motion: is an array of tables (1), expected 2 tables, one "
           "for each coordinate; {} for one that has none"},
          {"kind = \"revolute\"\naxis = [0, -1, 0]\ndamping = 10.0",
           "kind = \"universal\"\naxes = [[0, 1, 0], [1, 0, 0]]\ntorque = { time = [0, 1], value = "
           "[[0, 1]] }",
           "f.toml:26:35: blade.joint.1.torque.value: has 1 array, expected 2, one for each of "
           "time"},
      });
}

TEST_CASE("trees that are none are refused") {
  check_edits(
      kTreeText,
      {
          {"name = \"arm\"\n", "", "f.toml:6:1: subsystem.1.name: is missing, expected a name"},
          {"name = \"mirror\"", "name = \"boom\"",
           "f.toml:19:8: subsystem.1.body.2.name: is \"boom\" as another body's, expected a name "
           "of its own"},
          {"name = \"mirror\"", "name = \"hub\"",
           "f.toml:19:8: subsystem.1.body.2.name: is \"hub\", which is the hub's; expected another "
           "name"},
          {"name = \"mirror\"\n", "",
           "f.toml:18:1: subsystem.1.body.2.name: is missing, expected a name"},
          {"parent = \"boom\"", "parent = \"bom\"",
           "f.toml:28:10: subsystem.1.joint.2.parent: is \"bom\", did you mean \"boom\"?"},
          {"parent = \"boom\"", "parent = \"mast\"",
           "f.toml:28:10: subsystem.1.joint.2.parent: is \"mast\", expected \"hub\", \"boom\" or "
           "\"mirror\""},
          {"child = \"mirror\"", "child = \"miror\"",
           "f.toml:29:9: subsystem.1.joint.2.child: is \"miror\", did you mean \"mirror\"?"},
          {"child = \"mirror\"", "child = \"boom\"",
           "f.toml:29:9: subsystem.1.joint.2.child: is \"boom\", the parent; expected another "
           "body"},
          {"parent = \"boom\"", "parent = \"mirror\"",
           "f.toml:29:9: subsystem.1.joint.2.child: is \"mirror\", the parent; expected another "
           "body"},
          {"child = \"mirror\"\n", "",
           "f.toml:27:1: subsystem.1.joint.2.child: is missing, expected a name"},
          {"parent = \"hub\"\nchild = \"boom\"", "parent = \"mirror\"\nchild = \"boom\"",
           "f.toml:24:10: subsystem.1.joint.1.parent: is \"mirror\", which makes a circle of "
           "bodies, expected ways that lead to \"hub\""},
          {"[integration]",
           "[[subsystem.joint]]\nparent = \"hub\"\nchild = \"mirror\"\nkind = "
           "\"fixed\"\n[integration]",
           "f.toml:34:9: subsystem.1.joint.3.child: is \"mirror\", the child of joint 2 already; "
           "expected a tree, closed by [[subsystem.loop]]"},
          {"[integration]",
           "[[subsystem.body]]\nname = \"lost\"\nkind = \"rigid\"\nmass = 1\ninertia = [1, 1, "
           "1]\n[integration]",
           "f.toml:32:1: subsystem.1.body.3: is no child of a joint, expected [[subsystem.joint]] "
           "with child = \"lost\""},
          {"parent = \"boom\"", "parent = \"boom\"\nstation = 5",
           "f.toml:29:11: subsystem.1.joint.2.station: is 5, expected a number from 0 to 4 (m, "
           "from root to tip of the parent)"},
          {"parent = \"boom\"", "parent = \"boom\"\nnode = 17",
           "f.toml:29:8: subsystem.1.joint.2.node: is 17, expected a whole number from 0 to 16"},
          {"parent = \"boom\"", "parent = \"boom\"\nnode = 3\nstation = 1",
           "f.toml:29:8: subsystem.1.joint.2.node: given along with station, expected only one"},
          {"parent = \"hub\"\n", "parent = \"hub\"\nstation = 1\n",
           "f.toml:25:11: subsystem.1.joint.1.station: would be ignored, expected only on a parent "
           "that is a beam: give offset"},
          {"parent = \"hub\"\n", "parent = \"hub\"\nnode = 1\n",
           "f.toml:25:8: subsystem.1.joint.1.node: would be ignored, expected only on a parent "
           "that is a beam: give offset"},
          {"inertia = [1.0, 2.0, 3.0]", "inertia = [1.0, 2.0, 0.0]",
           "f.toml:22:11: subsystem.1.body.2.inertia: has the principal moments 0, 1 and 2 kg m^2, "
           "expected all of them greater than 0"},
          {"inertia = [1.0, 2.0, 3.0]", "inertia = [1.0, 2.0, 4.0]",
           "f.toml:22:11: subsystem.1.body.2.inertia: has the principal moments 1, 2 and 4 kg m^2, "
           "expected none greater than the sum of the others, as of a real body"},
          {"mass = 5.0", "mass = 0",
           "f.toml:21:8: subsystem.1.body.2.mass: is 0, expected a number greater than 0 (kg)"},
          {"mass = 5.0", "length = 5.0",
           "f.toml:21:10: subsystem.1.body.2.length: does not belong to kind \"rigid\""},
          {"kind = \"rigid\"", "kind = \"shell\"",
           "f.toml:20:8: subsystem.1.body.2.kind: is \"shell\", expected \"beam\", \"rigid\" or "
           "\"solid\""},
          {"stiffness = 4.0", "stiffness = [4.0, 4.0, 4.0]",
           "f.toml:31:13: subsystem.1.joint.2.stiffness: is an array (3), expected a number of 0 "
           "or more (N m/rad)"},
          {"stiffness = 4.0", "rest = 1",
           "f.toml:31:8: subsystem.1.joint.2.rest: does not belong to kind \"spherical\", expected "
           "only with kind \"revolute\", \"universal\", \"prismatic\", \"cylindrical\" or "
           "\"bushing\""},
          {"stiffness = 4.0", "initial = 0.1",
           "f.toml:31:11: subsystem.1.joint.2.initial: is 0.1, expected an array of 3 numbers "
           "(rad)"},
          {"stiffness = 4.0", "torque = [1, 2]",
           "f.toml:31:10: subsystem.1.joint.2.torque: is an array (2), expected an array of 3 "
           "numbers (N m)"},
          {"[[subsystem]]\nname = \"arm\"",
           "[[subsystem]]\nname = \"arm\"\n[[subsystem.body]]\nname = \"a\"\nkind = "
           "\"rigid\"\nmass = 1\ninertia = [1, 1, 1]\n[[subsystem.joint]]\nparent = \"hub\"\nchild "
           "= \"a\"\nkind = \"fixed\"\n[[subsystem]]\nname = \"arm\"",
           "f.toml:18:8: subsystem.2.name: is \"arm\" as another subsystem's, expected a name of "
           "its own"},
          {"mass = 100.0", "mass = 100.0\ndrive = { kind = \"free\", initial_speed = 2 }",
           "f.toml:5:42: hub.drive.initial_speed: belongs to an axle, expected, of a free hub, "
           "angular_velocity"},
          {"mass = 100.0",
           "mass = 100.0\nmount = { rotation = { amplitude = [0, 0, 1], frequency = 1 } }",
           "f.toml:5:9: hub.mount: belongs to an axle, expected none of a free hub"},
      });
}

TEST_CASE("loads that have no place are refused") {
  check_edits(
      kTreeText,
      {
          {"[integration]",
           "[[load]]\nsubsystem = \"arms\"\nbody = \"boom\"\nforce = [1, 0, 0]\n[integration]",
           "f.toml:33:13: load.1.subsystem: is \"arms\", did you mean \"arm\"?"},
          {"[integration]",
           "[[load]]\nsubsystem = \"arm\"\nbody = \"bom\"\nforce = [1, 0, 0]\n[integration]",
           "f.toml:34:8: load.1.body: is \"bom\", did you mean \"boom\"?"},
          {"[integration]", "[[load]]\nforce = [1, 0, 0]\n[integration]",
           "f.toml:32:1: load.1: is on blades, of which there are none; expected subsystem and "
           "body"},
          {"[integration]", "[[load]]\nsubsystem = \"arm\"\nbody = \"boom\"\n[integration]",
           "f.toml:32:1: load.1: has neither force nor moment, expected one of them as [x, y, z]"},
          {"[integration]",
           "[[load]]\nsubsystem = \"arm\"\nbody = \"boom\"\nforce = [1, 0]\n[integration]",
           "f.toml:35:9: load.1.force: is an array (2), expected an array of 3 numbers (N)"},
          {"[integration]",
           "[[load]]\nsubsystem = \"arm\"\nbody = \"boom\"\nposition = 5\nforce = [1, 0, "
           "0]\n[integration]",
           "f.toml:35:12: load.1.position: is 5, expected a number from 0 to 4 (m, from root to "
           "tip)"},
          {"[integration]",
           "[[load]]\nsubsystem = \"arm\"\nbody = \"mirror\"\nposition = 1\nforce = [1, 0, "
           "0]\n[integration]",
           "f.toml:35:12: load.1.position: belongs to beams, expected point on a rigid body"},
          {"[integration]",
           "[[load]]\nsubsystem = \"arm\"\nbody = \"boom\"\npoint = [1, 0, 0]\nforce = [1, 0, "
           "0]\n[integration]",
           "f.toml:35:9: load.1.point: belongs to rigid bodies, expected position on a beam"},
          {"[integration]",
           "[[load]]\nsubsystem = \"arm\"\nbody = \"mirror\"\nframe = \"section\"\nforce = [1, 0, "
           "0]\n[integration]",
           "f.toml:35:9: load.1.frame: is \"section\", expected \"inertial\", \"hub\" or \"body\" "
           "on a rigid body"},
          {"[integration]",
           "[[load]]\nsubsystem = \"arm\"\nblade = 1\nbody = \"boom\"\nforce = [1, 0, "
           "0]\n[integration]",
           "f.toml:34:9: load.1.blade: given along with subsystem, expected only one of them"},
          {"[integration]",
           "[[distributed_load]]\nsubsystem = \"arm\"\nbody = \"mirror\"\nforce_per_length = [1, "
           "0, 0]\n[integration]",
           "f.toml:34:8: distributed_load.1.body: is rigid, expected a beam"},
          {"[integration]",
           "[[distributed_load]]\nsubsystem = \"arm\"\nbody = \"boom\"\nfrom = 3\nto = "
           "2\nforce_per_length = [1, 0, 0]\n[integration]",
           "f.toml:36:6: distributed_load.1.to: is 2, expected a number greater than 3 and at most "
           "4 (m, beyond from, up to the tip)"},
          {"[integration]",
           "[[distributed_load]]\nsubsystem = \"arm\"\nbody = \"boom\"\nfrom = 4\nforce_per_length "
           "= [1, 0, 0]\n[integration]",
           "f.toml:35:8: distributed_load.1.from: is 4, expected less than the length, 4 (m)"},
          {"[integration]", "[[hub_load]]\nposition = [1, 0, 0]\ntorque = [1, 0, 0]\n[integration]",
           "f.toml:33:12: hub_load.1.position: would be ignored, expected only with \"force\""},
          {"[integration]", "[[hub_load]]\nframe = \"body\"\ntorque = [1, 0, 0]\n[integration]",
           "f.toml:33:9: hub_load.1.frame: is \"body\", expected \"hub\" or \"inertial\""},
          {"[integration]", "[[hub_load]]\ntorque = 3\n[integration]",
           "f.toml:33:10: hub_load.1.torque: is 3, expected an array of 3 numbers (N m)"},
      });
}
