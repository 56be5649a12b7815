// Messages for invalid supports, suspensions and bushings, and for what stands on them.

#include <doctest/doctest.h>

#include "tests/models/reader/spatial_texts.h"
#include "tests/models/reader/support_texts.h"

using namespace spoke;
using spoke::test::check_edits;
using spoke::test::kFuselageText;
using spoke::test::kSupportText;
using spoke::test::kSuspensionText;

TEST_CASE("bases of supports that cannot be are refused") {
  check_edits(
      kSupportText,
      {
          {"from = \"ground\"", "from = \"sky\"",
           "f.toml:18:8: support.from: is \"sky\", expected \"ground\" or \"free\""},
          {"from = \"ground\"", "form = \"ground\"",
           "f.toml:18:1: support.form: unknown key, did you mean \"from\"?"},
          {"from = \"ground\"", "mass = 5.0",
           "f.toml:18:8: support.mass: belongs to a fuselage, expected only with from = \"free\""},
          {"from = \"ground\"", "from = \"ground\"\nattitude = [0, 0, 1]",
           "f.toml:19:12: support.attitude: belongs to a fuselage, expected only with from = "
           "\"free\""},
          {"from = \"ground\"", "from = \"free\"",
           "f.toml:17:1: support.mass: is missing, expected a number greater than 0 (kg)"},
          {"from = \"ground\"", "from = \"free\"\nmass = 5.0",
           "f.toml:17:1: support.inertia: is missing, expected one moment of inertia, about every "
           "axis, 3 moments, or 6 entries xx, yy, zz, xy, xz, yz (kg m^2)"},
          {"[support]\nfrom = \"ground\"", "[[support]]\nfrom = \"ground\"",
           "f.toml:17:1: support: is an array of tables (1), expected a table [support]"},
          {"[hub.drive]\nkind = \"constant\"\nspeed = 4.0", "support = \"free\"",
           "f.toml:5:11: hub.support: is \"free\", but the hub is on a support, which carries its "
           "axle; expected \"axle\""},
          {"[hub]\n", "[hub]\nmass_ = 1\n",
           "f.toml:3:1: hub.mass_: unknown key, did you mean \"mass\"?"},
          {"[hub.drive]",
           "[hub.suspension]\nstiffness = [1, 1, 1, 0, 0, 0]\nmass = 1\ninertia = 1\n[hub.drive]",
           "f.toml:5:1: hub.suspension: given along with [support], expected only one of them"},
          {"world = \"space\"\n", "world = \"plane\"\n",
           "f.toml:17:1: support: belongs to another world, expected world = \"space\""},
          {"world = \"space\"\n", "",
           "f.toml:16:1: support: belongs to another world, expected world = \"space\""},
          {"[integration]",
           "[[subsystem]]\nname = \"support\"\n[[subsystem.body]]\nname = \"a\"\nkind = "
           "\"rigid\"\nmass = 1\ninertia = 1\n[[subsystem.joint]]\nparent = \"hub\"\nchild = "
           "\"a\"\nkind = \"fixed\"\n[integration]",
           "f.toml:49:8: subsystem.1.name: is \"support\", which is the name of [support]; "
           "expected another one"},
          {"from = \"ground\"", "count = 3",
           "f.toml:18:1: support.count: unknown key, did you mean \"joint\"?"},
      });
}

TEST_CASE("trees of supports that are none are refused") {
  check_edits(
      kSupportText,
      {
          {"name = \"nacelle\"\nkind", "name = \"tower\"\nkind",
           "f.toml:30:8: support.body.2.name: is \"tower\" as another body's, expected a name of "
           "its own"},
          {"name = \"nacelle\"\nkind", "name = \"hub\"\nkind",
           "f.toml:30:8: support.body.2.name: is \"hub\", which is the hub's; expected another "
           "name"},
          {"name = \"nacelle\"\nkind", "name = \"ground\"\nkind",
           "f.toml:30:8: support.body.2.name: is \"ground\", which is what the support stands on; "
           "expected another name"},
          {"name = \"nacelle\"\nkind", "name = \"the nacelle\"\nkind",
           "f.toml:30:8: support.body.2.name: is \"the nacelle\", expected letters, digits, \"_\", "
           "\"-\" and \".\", 1 to 64 of them"},
          {"name = \"nacelle\"\nkind", "kind",
           "f.toml:29:1: support.body.2.name: is missing, expected a name"},
          {"kind = \"rigid\"", "kind = \"shell\"",
           "f.toml:31:8: support.body.2.kind: is \"shell\", expected \"beam\", \"rigid\" or "
           "\"solid\""},
          {"kind = \"rigid\"", "kind = \"rigid\"\nlength = 2",
           "f.toml:32:10: support.body.2.length: does not belong to kind \"rigid\""},
          {"mass = 50.0\n", "",
           "f.toml:29:1: support.body.2.mass: is missing, expected a number greater than 0 (kg)"},
          {"mass = 50.0", "mass = 0",
           "f.toml:32:8: support.body.2.mass: is 0, expected a number greater than 0 (kg)"},
          {"inertia = [5.0, 6.0, 7.0]", "inertia = [5.0, 6.0, 0.0]",
           "f.toml:33:11: support.body.2.inertia: has the principal moments 0, 5 and 6 kg m^2, "
           "expected all of them greater than 0"},
          {"length = 20.0", "length = -20",
           "f.toml:22:10: support.body.1.length: is -20, expected a number greater than 0 (m)"},
          {"parent = \"tower\"", "parent = \"towr\"",
           "f.toml:40:10: support.joint.2.parent: is \"towr\", did you mean \"tower\"?"},
          {"parent = \"tower\"", "parent = \"hub\"",
           "f.toml:40:10: support.joint.2.parent: is \"hub\", expected \"ground\", \"nacelle\" or "
           "\"tower\""},
          {"parent = \"tower\"", "parent = \"mount\"",
           "f.toml:40:10: support.joint.2.parent: is \"mount\", did you mean \"ground\"?"},
          {"parent = \"tower\"", "parent = \"nacelle\"",
           "f.toml:41:9: support.joint.2.child: is \"nacelle\", the parent; expected another body"},
          {"child = \"tower\"", "parent = \"nacelle\"\nchild = \"tower\"",
           "f.toml:35:10: support.joint.1.parent: is \"nacelle\", which makes a circle of bodies, "
           "expected ways that lead to \"ground\""},
          {"child = \"tower\"", "child = \"mast\"",
           "f.toml:35:9: support.joint.1.child: is \"mast\", expected \"nacelle\" or \"tower\""},
          {"child = \"tower\"\n", "",
           "f.toml:34:1: support.joint.1.child: is missing, expected a name"},
          {"child = \"tower\"", "child = \"nacelle\"",
           "f.toml:41:9: support.joint.2.child: is \"nacelle\", the child of joint 1 already; "
           "expected a tree, closed by [[support.loop]]"},
          {"parent = \"tower\"", "parent = \"tower\"\nstation = 21",
           "f.toml:41:11: support.joint.2.station: is 21, expected a number from 0 to 20 (m, from "
           "root to tip of the parent)"},
          {"parent = \"tower\"", "parent = \"tower\"\nnode = 17",
           "f.toml:41:8: support.joint.2.node: is 17, expected a whole number from 0 to 16"},
          {"parent = \"tower\"", "parent = \"tower\"\ninterface = \"top\"",
           "f.toml:41:13: support.joint.2.interface: would be ignored, expected only on a parent "
           "that is a solid"},
          {"child = \"tower\"", "child = \"tower\"\nstation = 1",
           "f.toml:36:11: support.joint.1.station: would be ignored, expected only on a parent "
           "that is a beam: give offset"},
          {"[integration]",
           "[[support.body]]\nname = \"lost\"\nkind = \"rigid\"\nmass = 1\ninertia = "
           "1\n[integration]",
           "f.toml:48:1: support.body.3: is no child of a joint, expected [[support.joint]] with "
           "child = \"lost\""},
          {"name = \"yaw\"", "name = \"axle\"",
           "f.toml:39:8: support.joint.2.name: is \"axle\", which is the hub's; expected another "
           "name"},
          {"stiffness = 4e4", "motion = { mean = 0.1 }",
           "f.toml:44:10: support.joint.2.motion: follows the azimuth, but a support does not turn "
           "with the hub; expected constant, time and value, or by = \"program\""},
          {"kind = \"revolute\"\naxis = [1, 0, 0]\nstiffness = 4e4",
           "kind = \"cylindrical\"\naxis = [1, 0, 0]\nmotion = [{ constant = 0 }, { cosine = 0.1 "
           "}]",
           "f.toml:44:29: support.joint.2.motion.2: follows the azimuth, but a support does not "
           "turn with the hub; expected constant, time and value, or by = \"program\""},
          {"stiffness = 4e4", "stiffness = -4e4",
           "f.toml:44:13: support.joint.2.stiffness: is -40000.0, expected a number of 0 or more "
           "(N m/rad)"},
          {"name = \"yaw\"", "azimuth = 0.1",
           "f.toml:39:1: support.joint.2.azimuth: unknown key, expected \"name\", \"kind\", "
           "\"axis\", \"axes\", \"offset\", \"orientation\", \"stiffness\", \"damping\", \"free\", "
           "\"rest\", "
           "\"relaxation\", \"stop\", \"friction\", \"initial\", \"initial_speed\", \"hold\", "
           "\"torque\", \"force\", \"motion\", \"parent\", \"child\", \"station\", \"node\" or "
           "\"interface\""},
      });
}

TEST_CASE("axles that stand nowhere are refused") {
  check_edits(
      kSupportText,
      {
          {"body = \"nacelle\"\n", "",
           "f.toml:45:1: support.axle.body: is missing, expected the name of the body that carries "
           "the axle"},
          {"[support.axle]\nbody = \"nacelle\"\noffset = [0.0, 0.0, 2.0]\n", "",
           "f.toml:17:1: support.axle.body: is missing, expected the name of the body that carries "
           "the axle"},
          {"body = \"nacelle\"\n", "body = \"nacele\"\n",
           "f.toml:46:8: support.axle.body: is \"nacele\", did you mean \"nacelle\"?"},
          {"body = \"nacelle\"\n", "body = \"ground\"\n",
           "f.toml:46:8: support.axle.body: is \"ground\", expected \"tower\" or \"nacelle\""},
          {"body = \"nacelle\"\n", "body = \"hub\"\n",
           "f.toml:46:8: support.axle.body: is \"hub\", expected \"tower\" or \"nacelle\""},
          {"body = \"nacelle\"\n", "body = 2\n",
           "f.toml:46:8: support.axle.body: is 2, expected text in quotes"},
          {"body = \"nacelle\"\n", "body = \"nacelle\"\nstation = 1\n",
           "f.toml:47:11: support.axle.station: would be ignored, expected only on a parent that "
           "is a beam: give offset"},
          {"body = \"nacelle\"\n", "body = \"nacelle\"\nnode = 1\n",
           "f.toml:47:8: support.axle.node: would be ignored, expected only on a parent that is a "
           "beam: give offset"},
          {"body = \"nacelle\"\n", "body = \"nacelle\"\ninterface = \"flange\"\n",
           "f.toml:47:13: support.axle.interface: would be ignored, expected only on a parent that "
           "is a solid"},
          {"body = \"nacelle\"\n", "body = \"tower\"\nstation = 20.5\n",
           "f.toml:47:11: support.axle.station: is 20.5, expected a number from 0 to 20 (m, from "
           "root to tip of the parent)"},
          {"body = \"nacelle\"\n", "body = \"tower\"\nstation = -1\n",
           "f.toml:47:11: support.axle.station: is -1, expected a number of 0 or more (m)"},
          {"body = \"nacelle\"\n", "body = \"tower\"\nnode = 17\n",
           "f.toml:47:8: support.axle.node: is 17, expected a whole number from 0 to 16"},
          {"body = \"nacelle\"\n", "body = \"tower\"\nnode = 1\nstation = 2\n",
           "f.toml:47:8: support.axle.node: given along with station, expected only one"},
          {"offset = [0.0, 0.0, 2.0]", "offset = [0.0, 2.0]",
           "f.toml:47:10: support.axle.offset: is an array (2), expected an array of 3 numbers "
           "(m)"},
          {"offset = [0.0, 0.0, 2.0]", "orientation = 0.1",
           "f.toml:47:15: support.axle.orientation: is 0.1, expected an array of 3 numbers (rad)"},
          {"offset = [0.0, 0.0, 2.0]", "ofset = [0.0, 0.0, 2.0]",
           "f.toml:47:1: support.axle.ofset: unknown key, did you mean \"offset\"?"},
      });
}

TEST_CASE("fuselages that cannot fly are refused") {
  check_edits(
      kFuselageText,
      {
          {"mass = 500.0\n", "",
           "f.toml:8:1: support.mass: is missing, expected a number greater than 0 (kg)"},
          {"mass = 500.0", "mass = 0",
           "f.toml:10:8: support.mass: is 0, expected a number greater than 0 (kg)"},
          {"inertia = [200.0, 900.0, 800.0]\n", "",
           "f.toml:8:1: support.inertia: is missing, expected one moment of inertia, about every "
           "axis, 3 moments, or 6 entries xx, yy, zz, xy, xz, yz (kg m^2)"},
          {"inertia = [200.0, 900.0, 800.0]", "inertia = [200.0, 900.0, 0.0]",
           "f.toml:11:11: support.inertia: has the principal moments 0, 200 and 900 kg m^2, "
           "expected all of them greater than 0"},
          {"inertia = [200.0, 900.0, 800.0]", "inertia = [200.0, 900.0, 1800.0]",
           "f.toml:11:11: support.inertia: has the principal moments 200, 900 and 1800 kg m^2, "
           "expected none greater than the sum of the others, as of a real body"},
          {"attitude = [0.0, 0.1, 0.0]", "attitude = 0.1",
           "f.toml:13:12: support.attitude: is 0.1, expected an array of 3 numbers (rad)"},
          {"position = [0.0, 0.0, 100.0]", "position = [0.0, 0.0]",
           "f.toml:12:12: support.position: is an array (2), expected an array of 3 numbers (m)"},
          {"velocity = [30.0, 0.0, 0.0]", "speed = 30",
           "f.toml:14:1: support.speed: unknown key, expected \"from\", \"mass\", \"center\", "
           "\"inertia\", \"position\", \"attitude\", \"velocity\", \"angular_velocity\", \"body\", "
           "\"joint\", \"loop\", \"coupling\" or \"axle\""},
          {"velocity = [30.0, 0.0, 0.0]", "angular_velocity = \"fast\"",
           "f.toml:14:20: support.angular_velocity: is \"fast\", expected an array of 3 numbers "
           "(rad/s)"},
          {"from = \"free\"\n", "",
           "f.toml:9:8: support.mass: belongs to a fuselage, expected only with from = \"free\""},
          {"offset = [0.0, 0.0, 1.2]", "body = \"boom\"",
           "f.toml:16:8: support.axle.body: is \"boom\", expected \"fuselage\""},
          {"offset = [0.0, 0.0, 1.2]", "station = 1",
           "f.toml:16:11: support.axle.station: would be ignored, expected only on a parent that "
           "is a beam: give offset"},
          {"[hub.drive]", "[hub.mount]\nrotation = { rate = [0, 0, 1] }\n[hub.drive]",
           "f.toml:5:1: hub.mount: moves the ground, expected none of a support that is free"},
          {"[hub]\nmass = 10.0", "[hub]\nmass = 0",
           "f.toml:3:8: hub.mass: is 0, expected a number greater than 0 (kg) of a hub that moves "
           "on a support and carries nothing"},
          {"[hub]\nmass = 10.0\n", "[hub]\n",
           "f.toml:2:1: hub.mass: is 0, expected a number greater than 0 (kg) of a hub that moves "
           "on a support and carries nothing"},
          {"[support.axle]",
           "[[support.body]]\nname = \"fuselage\"\nkind = \"rigid\"\nmass = 1\ninertia = "
           "1\n[[support.joint]]\nchild = \"fuselage\"\nkind = \"fixed\"\n[support.axle]",
           "f.toml:16:8: support.body.1.name: is \"fuselage\", which is what the support stands "
           "on; expected another name"},
          {"[integration]", "[[anchor]]\nname = \"plate\"\n[integration]",
           "f.toml:17:1: anchor.1.frame: is \"mount\", which a support that is free has not; "
           "expected \"hub\""},
          {"from = \"free\"\nmass = 500.0\ninertia = [200.0, 900.0, 800.0]\nposition = [0.0, 0.0, "
           "100.0]\nattitude = [0.0, 0.1, 0.0]\nvelocity = [30.0, 0.0, 0.0]\n",
           "from = \"ground\"\n",
           "f.toml:8:1: support.body: is missing, expected tables headed [[support.body]]"},
      });
}

TEST_CASE("suspensions that hold or carry nothing are refused") {
  check_edits(
      kSuspensionText,
      {
          {"stiffness = [2e4, 1e4, 0, 0, 0, 0]\n", "",
           "f.toml:8:1: hub.suspension.stiffness: is missing, expected an array of 6 numbers (N/m, "
           "N m/rad)"},
          {"stiffness = [2e4, 1e4, 0, 0, 0, 0]", "stiffness = 2e4",
           "f.toml:9:13: hub.suspension.stiffness: is 20000.0, expected an array of 6 numbers "
           "(N/m, N m/rad)"},
          {"stiffness = [2e4, 1e4, 0, 0, 0, 0]", "stiffness = [2e4, 1e4, 0]",
           "f.toml:9:13: hub.suspension.stiffness: is an array (3), expected an array of 6 numbers "
           "(N/m, N m/rad)"},
          {"stiffness = [2e4, 1e4, 0, 0, 0, 0]", "stiffness = [2e4, -1e4, 0, 0, 0, 0]",
           "f.toml:9:19: hub.suspension.stiffness.2: is -10000.0, expected a number of 0 or more "
           "(N/m, N m/rad)"},
          {"damping = [20.0, 10.0, 0, 0, 0, 5.0]", "damping = [20.0, 10.0, 0, 0, 0, -5.0]",
           "f.toml:10:33: hub.suspension.damping.6: is -5.0, expected a number of 0 or more (N "
           "s/m, N m s/rad)"},
          {"damping = [20.0, 10.0, 0, 0, 0, 5.0]", "damping = [20.0, 10.0, 0, 0, 0]",
           "f.toml:10:11: hub.suspension.damping: is an array (5), expected an array of 6 numbers "
           "(N s/m, N m s/rad)"},
          {"stiffness = [2e4, 1e4, 0, 0, 0, 0]\ndamping = [20.0, 10.0, 0, 0, 0, 5.0]",
           "stiffness = [0, 0, 0, 0, 0, 0]",
           "f.toml:9:13: hub.suspension.stiffness: is 0, as damping is, in all directions, which "
           "are held then; expected one that moves"},
          {"mass = 40.0\n", "",
           "f.toml:8:1: hub.suspension.mass: is missing, expected a number greater than 0 (kg)"},
          {"mass = 40.0", "mass = 0",
           "f.toml:11:8: hub.suspension.mass: is 0, expected a number greater than 0 (kg)"},
          {"inertia = 3.0\n", "",
           "f.toml:8:1: hub.suspension.inertia: is missing, expected one moment of inertia, about "
           "every axis, 3 moments, or 6 entries xx, yy, zz, xy, xz, yz (kg m^2)"},
          {"inertia = 3.0", "inertia = 0",
           "f.toml:12:11: hub.suspension.inertia: is 0, expected a number greater than 0 (kg m^2)"},
          {"inertia = 3.0", "inertia = [1, 1, 3]",
           "f.toml:12:11: hub.suspension.inertia: has the principal moments 1, 1 and 3 kg m^2, "
           "expected none greater than the sum of the others, as of a real body"},
          {"mass = 40.0", "mass = 40.0\noffset = [0, 0, 1]",
           "f.toml:12:1: hub.suspension.offset: unknown key, expected \"stiffness\", \"damping\", "
           "\"mass\", \"center\" or \"inertia\""},
          {"mass = 40.0", "mass = 40.0\ncenter = 1",
           "f.toml:12:10: hub.suspension.center: is 1, expected an array of 3 numbers (m)"},
          {"world = \"space\"\n", "",
           "f.toml:7:1: hub.suspension: belongs to another world, expected world = \"space\""},
          {"[hub.drive]\nkind = \"constant\"\nspeed = 4.0", "support = \"free\"",
           "f.toml:5:11: hub.support: is \"free\", but the hub is on a support, which carries its "
           "axle; expected \"axle\""},
          {"[hub.suspension]\n", "[[hub.suspension]]\n",
           "f.toml:8:1: hub.suspension: is an array of tables (1), expected a table "
           "[hub.suspension]"},
      });
}

TEST_CASE("bushings that cannot be are refused") {
  check_edits(
      kSupportText,
      {
          {"kind = \"fixed\"", "kind = \"bushing\"",
           "f.toml:34:1: support.joint.1.stiffness: is 0, as damping is, in all directions, so "
           "that the bushing holds them all; expected one that moves, or kind \"fixed\""},
          {"kind = \"fixed\"",
           "kind = \"bushing\"\nstiffness = [0, 0, 0, 0, 0, 0]\ndamping = [0, 0, 0, 0, 0, 0]",
           "f.toml:37:13: support.joint.1.stiffness: is 0, as damping is, in all directions, so "
           "that the bushing holds them all; expected one that moves, or kind \"fixed\""},
          {"kind = \"fixed\"", "kind = \"bushing\"\nfree = [\"x\", \"around y\"]",
           "f.toml:37:8: support.joint.1.free: has \"around y\", expected an array of directions: "
           "\"x\", \"y\", \"z\", \"about x\", \"about y\", \"about z\""},
          {"kind = \"fixed\"", "kind = \"bushing\"\nfree = [\"x\"]\nstiffness = [1, 0, 0, 0, 0, 0]",
           "f.toml:37:8: support.joint.1.free: has \"x\", which has a spring or a damper; expected "
           "directions without"},
          {"kind = \"fixed\"", "kind = \"bushing\"\nfree = [\"x\"]\nrest = [0.1, 0, 0, 0, 0, 0]",
           "f.toml:38:9: support.joint.1.rest.1: is 0.1 in a direction without a spring; expected "
           "0"},
          {"kind = \"fixed\"", "kind = \"bushing\"\nstiffness = 5",
           "f.toml:37:13: support.joint.1.stiffness: is 5, expected an array of 6 numbers (N/m, N "
           "m/rad)"},
          {"kind = \"fixed\"", "kind = \"bushing\"\nstiffness = [1, 1, 1, 1, 1, -1]",
           "f.toml:37:29: support.joint.1.stiffness.6: is -1, expected a number of 0 or more (N/m, "
           "N m/rad)"},
          {"kind = \"fixed\"",
           "kind = \"bushing\"\nstiffness = [1, 1, 1, 0, 0, 0]\ndamping = [0, 0, 0]",
           "f.toml:38:11: support.joint.1.damping: is an array (3), expected an array of 6 numbers "
           "(N s/m, N m s/rad)"},
          {"kind = \"fixed\"",
           "kind = \"bushing\"\nstiffness = [1, 0, 0, 0, 0, 0]\ninitial = [0, 0.1, 0, 0, 0, 0]",
           "f.toml:38:15: support.joint.1.initial.2: is 0.1 in a direction that is held, since it "
           "has neither stiffness nor damping; expected 0"},
          {"kind = \"fixed\"",
           "kind = \"bushing\"\nstiffness = [1, 0, 0, 0, 0, 0]\nrest = [0, 0, 0, 0, 0, 0.1]",
           "f.toml:38:24: support.joint.1.rest.6: is 0.1 in a direction that is held, since it has "
           "neither stiffness nor damping; expected 0"},
          {"kind = \"fixed\"",
           "kind = \"bushing\"\nstiffness = [1, 0, 0, 0, 0, 0]\ninitial_speed = [0, 0, 0, 2, 0, 0]",
           "f.toml:38:27: support.joint.1.initial_speed.4: is 2 in a direction that is held, since "
           "it has neither stiffness nor damping; expected 0"},
          {"kind = \"fixed\"",
           "kind = \"bushing\"\nstiffness = [1, 0, 0, 0, 0, 0]\naxis = [1, 0, 0]",
           "f.toml:38:8: support.joint.1.axis: does not belong to kind \"bushing\", expected only "
           "with kind \"revolute\", \"prismatic\" or \"cylindrical\""},
          {"kind = \"fixed\"", "kind = \"bushing\"\nstiffness = [1, 0, 0, 0, 0, 0]\nmotion = []",
           "f.toml:38:10: support.joint.1.motion: does not belong to kind \"bushing\", expected "
           "only with kind \"revolute\", \"universal\", \"prismatic\" or \"cylindrical\""},
          {"kind = \"fixed\"", "kind = \"bushing\"\nstiffness = [1, 0, 0, 0, 0, 0]\nstop = []",
           "f.toml:38:8: support.joint.1.stop: does not belong to kind \"bushing\", expected only "
           "with kind \"revolute\", \"universal\", \"prismatic\" or \"cylindrical\""},
          {"kind = \"fixed\"",
           "kind = \"bushing\"\nstiffness = [1, 0, 0, 0, 0, 0]\ntorque = [1, 0, 0, 0, 0, 0]",
           "f.toml:38:10: support.joint.1.torque: does not belong to kind \"bushing\", expected "
           "only with kind \"revolute\", \"universal\", \"spherical\" or \"cylindrical\""},
      });
}

TEST_CASE("an anchor beside the axle needs a drive that prescribes the hub's angle") {
  const std::string anchor = "[[anchor]]\nname = \"plate\"\nframe = \"axle\"\n[integration]";
  std::string text = kSupportText;
  text.replace(text.find("[integration]"), 13, anchor);
  check_edits(text,
              {{"kind = \"constant\"\nspeed = 4.0", "kind = \"free\"",
                "f.toml:49:9: anchor.1.frame: is \"axle\", but no drive prescribes the hub's "
                "angle, so that its forces would turn the hub; expected a drive that does, or "
                "\"hub\""}});
}

TEST_CASE("loops across the axle of a support are refused") {
  check_edits(kSupportText,
              {
                  {"[integration]",
                   "[[blade.loop]]\nname = \"link\"\nkind = \"distance\"\nfrom = { station = 8.0 "
                   "}\nto = \"mount\"\n[integration]",
                   "f.toml:52:6: blade.loop.1.to: is \"mount\", which a hub on a support has not; "
                   "expected \"hub\" or a body"},
                  {"[integration]",
                   "[[anchor]]\nname = \"plate\"\nturns_with_hub = true\n[[blade.loop]]\nname = "
                   "\"link\"\nkind = \"distance\"\nfrom = { station = 8.0 }\nto = { anchor = "
                   "\"plate\" }\n[integration]",
                   "f.toml:55:17: blade.loop.1.to.anchor: is \"plate\", an anchor of the frame "
                   "\"mount\", but the hub is on a support; expected one of the frame \"hub\" or "
                   "\"axle\""},
                  {"[integration]",
                   "[[subsystem]]\nname = \"arm\"\n[[subsystem.body]]\nname = \"a\"\nkind = "
                   "\"rigid\"\nmass = 1\ninertia = 1\n[[subsystem.joint]]\nparent = \"hub\"\nchild "
                   "= \"a\"\nkind = \"spherical\"\n[[subsystem.loop]]\nname = \"link\"\nkind = "
                   "\"distance\"\nfrom = { body = \"a\", point = [1, 0, 0] }\nto = { body = "
                   "\"mount\", point = [2, 0, 0] }\n[integration]",
                   "f.toml:63:6: subsystem.1.loop.1.to: is \"mount\", which a hub on a support has "
                   "not; expected \"hub\" or a body"},
                  {"[integration]",
                   "[[support.loop]]\nname = \"stay\"\nkind = \"distance\"\nfrom = { body = "
                   "\"tower\", station = 9 }\nto = \"hub\"\n[integration]",
                   "f.toml:52:6: support.loop.1.to: is \"hub\", expected \"ground\", or a table "
                   "with body or anchor"},
                  {"[integration]",
                   "[[support.loop]]\nname = \"stay\"\nkind = \"distance\"\nfrom = { body = "
                   "\"tower\", station = 9 }\nto = \"mount\"\n[integration]",
                   "f.toml:52:6: support.loop.1.to: is \"mount\", expected \"ground\", or a table "
                   "with body or anchor"},
                  {"[integration]",
                   "[[support.loop]]\nname = \"stay\"\nkind = \"distance\"\nfrom = { body = "
                   "\"tower\", station = 9 }\nto = { body = \"mount\" }\n[integration]",
                   "f.toml:52:15: support.loop.1.to.body: is \"mount\", did you mean \"ground\"?"},
                  {"[integration]",
                   "[[support.loop]]\nname = \"stay\"\nkind = \"distance\"\nfrom = { body = "
                   "\"tower\", station = 9 }\nto = { point = [0, 0, 0] }\n[integration]",
                   "f.toml:52:6: support.loop.1.to.body: is missing, expected the name of a body, "
                   "\"ground\", or anchor"},
                  {"[integration]",
                   "[[support.loop]]\nname = \"stay\"\nkind = \"distance\"\nfrom = { body = "
                   "\"tower\", station = 29 }\nto = \"ground\"\n[integration]",
                   "f.toml:51:36: support.loop.1.from.station: is 29, expected a number from 0 to "
                   "20 (m, from root to tip)"},
                  {"[integration]",
                   "[[support.loop]]\nname = \"stay\"\nkind = \"distance\"\nfrom = \"ground\"\nto "
                   "= \"ground\"\n[integration]",
                   "f.toml:51:8: support.loop.1.from: is on no body, expected a place on one; what "
                   "carries the other end belongs to \"to\""},
                  {"[integration]",
                   "[[anchor]]\nname = \"plate\"\nframe = \"hub\"\n[[support.loop]]\nname = "
                   "\"stay\"\nkind = \"distance\"\nfrom = { body = \"tower\", station = 9 }\nto = "
                   "{ anchor = \"plate\" }\n[integration]",
                   "f.toml:55:17: support.loop.1.to.anchor: is \"plate\", an anchor of the frame "
                   "\"hub\", but the loop is of the support; expected one of the frame \"mount\""},
                  {"[integration]",
                   "[[anchor]]\nname = \"plate\"\nturns_with_hub = true\n[[support.loop]]\nname = "
                   "\"stay\"\nkind = \"distance\"\nfrom = { body = \"tower\", station = 9 }\nto = "
                   "{ anchor = \"plate\" }\n[integration]",
                   "f.toml:55:17: support.loop.1.to.anchor: is \"plate\", which turns with the "
                   "hub, but the loop is of the support; expected one that does not"},
              });
}

TEST_CASE("loads and sensors that have no place on a support are refused") {
  check_edits(
      kSupportText,
      {
          {"[integration]",
           "[[load]]\nsubsystem = \"suport\"\nbody = \"tower\"\nforce = [1, 0, 0]\n[integration]",
           "f.toml:49:13: load.1.subsystem: is \"suport\", did you mean \"support\"?"},
          {"[integration]",
           "[[load]]\nsubsystem = \"support\"\nbody = \"mast\"\nforce = [1, 0, 0]\n[integration]",
           "f.toml:50:8: load.1.body: is \"mast\", expected \"tower\" or \"nacelle\""},
          {"[integration]",
           "[[load]]\nsubsystem = \"support\"\nbody = \"hub\"\nforce = [1, 0, 0]\n[integration]",
           "f.toml:50:8: load.1.body: is \"hub\", expected a body of the support; [[hub_load]] "
           "acts on the hub"},
          {"[integration]",
           "[[load]]\nsubsystem = \"support\"\nbody = \"tower\"\nposition = 21\nforce = [1, 0, "
           "0]\n[integration]",
           "f.toml:51:12: load.1.position: is 21, expected a number from 0 to 20 (m, from root to "
           "tip)"},
          {"[integration]",
           "[[distributed_load]]\nsubsystem = \"support\"\nbody = \"nacelle\"\nforce_per_length = "
           "[1, 0, 0]\n[integration]",
           "f.toml:50:8: distributed_load.1.body: is rigid, expected a beam"},
          {"[integration]",
           "[[sensor]]\nquantity = \"velocity\"\nsubsystem = \"support\"\nbody = "
           "\"ground\"\n[integration]",
           "f.toml:51:8: sensor.1.body: is \"ground\", expected \"tower\", \"nacelle\" or \"hub\""},
          {"[integration]",
           "[[sensor]]\nquantity = \"velocity\"\nsubsystem = \"support\"\n[integration]",
           "f.toml:48:1: sensor.1.body: is missing, expected the name of one of the subsystem"},
          {"[integration]",
           "[[sensor]]\nquantity = \"section_force\"\nsubsystem = \"support\"\nbody = "
           "\"tower\"\nposition = 21\n[integration]",
           "f.toml:52:12: sensor.1.position: is 21, expected a number from 0 to 20 (m, from root "
           "to tip)"},
          {"[integration]",
           "[[sensor]]\nquantity = \"section_force\"\nsubsystem = \"support\"\nbody = "
           "\"hub\"\nposition = 0\n[integration]",
           "f.toml:51:8: sensor.1.body: is rigid, expected a beam"},
          {"[integration]",
           "[[sensor]]\nquantity = \"joint_reaction\"\nsubsystem = \"support\"\nbody = "
           "\"hub\"\njoint = 1\n[integration]",
           "f.toml:52:9: sensor.1.joint: belongs to blades; of a body it is the one that carries "
           "it"},
      });
}
