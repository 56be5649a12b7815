// Messages for solids that cannot be.

#include <doctest/doctest.h>

#include <string>

#include "tests/models/reader/solid_texts.h"
#include "tests/models/reader/spatial_texts.h"

using namespace spoke;
using spoke::test::check_edits;
using spoke::test::kBracket;
using spoke::test::kInterfaces;
using spoke::test::kMeshes;
using spoke::test::kRoot;
using spoke::test::kSolidText;

TEST_CASE("what a solid is made of is checked") {
  check_edits(
      kSolidText,
      {
          {"mesh = \"" + kBracket + "\"\n", "",
           "f.toml:7:1: subsystem.1.body.1.mesh: is missing, expected a mesh of gmsh (.msh) or "
           "Abaqus (.inp); or mass, stiffness, nodes and format"},
          {kBracket, "nowhere.msh",
           "f.toml:10:8: subsystem.1.body.1.mesh: is \"nowhere.msh\", but there is no file "
           "nowhere.msh, expected a mesh of gmsh (.msh) or Abaqus (.inp)"},
          {"mesh = \"" + kBracket + "\"", "mesh = 3",
           "f.toml:10:8: subsystem.1.body.1.mesh: is 3, expected text in quotes"},
          {kBracket, kMeshes + "bracket.geo",
           kMeshes + "bracket.geo:1: begins with \"// An L-brac\", expected a mesh: $MeshFormat "
                     "(gmsh .msh) or *NODE (Abaqus .inp)"},
          {"name = \"bracket\"\nkind = \"solid\"", "name = \"bracket\"\nkind = \"solids\"",
           "f.toml:9:8: subsystem.1.body.1.kind: is \"solids\", expected \"beam\", \"rigid\" or "
           "\"solid\""},
          {"scale = { length = 1e-3 }", "scale = { length = -1e-3 }",
           "f.toml:11:20: subsystem.1.body.1.scale.length: is -0.001, expected a number greater "
           "than 0"},
          {"scale = { length = 1e-3 }", "scale = { mass = 1e-3 }",
           "f.toml:11:11: subsystem.1.body.1.scale.mass: unknown key, expected \"length\""},
          {"scale = { length = 1e-3 }", "scale = { length = 1.0 }",
           "f.toml:10:8: subsystem.1.body.1.mesh: has a mass of 7.99295e+09 kg, expected at most "
           "1e9 kg (of a file in mm: scale = { length = 1e-3 })"},
          {"material = { youngs_modulus = 7e10, poissons_ratio = 0.33, density = 2700 }\n", "",
           "f.toml:7:1: subsystem.1.body.1.material: is missing, expected youngs_modulus, "
           "poissons_ratio and density (or an .inp file with one isotropic material)"},
          {"poissons_ratio = 0.33", "poissons_ratio = 0.5",
           "f.toml:12:54: subsystem.1.body.1.material.poissons_ratio: is 0.5, expected a number "
           "greater than -1 and less than 0.5"},
          {"youngs_modulus = 7e10, ", "",
           "f.toml:12:12: subsystem.1.body.1.material.youngs_modulus: is missing, expected a "
           "number greater than 0 (Pa)"},
          {"density = 2700", "density = 0",
           "f.toml:12:70: subsystem.1.body.1.material.density: is 0, expected a number greater "
           "than 0 (kg/m^3)"},
          {"density = 2700", "density = 2.7e-9",
           "f.toml:12:70: subsystem.1.body.1.material.density: is 2.7e-09, expected 0.001 to 1e12 "
           "kg/m^3 (not t/mm^3)"},
          {"density = 2700", "rho = 2700",
           "f.toml:12:60: subsystem.1.body.1.material.rho: unknown key, expected "
           "\"youngs_modulus\", \"poissons_ratio\" or \"density\""},
      });
}

TEST_CASE("coordinates and damping of a solid are checked") {
  check_edits(
      kSolidText,
      {
          {"modes = 4", "modes = -1",
           "f.toml:13:9: subsystem.1.body.1.modes: is -1, expected a whole number from 0 to 10000"},
          {"modes = 4", "modes = 2.5",
           "f.toml:13:9: subsystem.1.body.1.modes: is 2.5, expected a whole number from 0 to "
           "10000"},
          {"modes = 4", "modes = 4\nup_to = 2000.0",
           "f.toml:14:9: subsystem.1.body.1.up_to: given along with modes, expected only one of "
           "them"},
          {"modes = 4", "up_to = 0.0",
           "f.toml:13:9: subsystem.1.body.1.up_to: is 0.0, expected a number greater than 0 (Hz)"},
          {"modes = 4", "coordinates = \"modal\"",
           "f.toml:13:15: subsystem.1.body.1.coordinates: is \"modal\", expected \"reduced\" or "
           "\"nodal\""},
          {"modes = 4", "modes = 4\ncoordinates = \"nodal\"",
           "f.toml:13:9: subsystem.1.body.1.modes: belongs to coordinates \"reduced\", expected "
           "none of \"nodal\""},
          {"modes = 4\ndamping = 0.01", "up_to = 10.0\ncoordinates = \"nodal\"",
           "f.toml:13:9: subsystem.1.body.1.up_to: belongs to coordinates \"reduced\", expected "
           "none of \"nodal\""},
          {"modes = 4\n", "coordinates = \"nodal\"\n",
           "f.toml:14:11: subsystem.1.body.1.damping: belongs to coordinates \"reduced\", expected "
           "none of \"nodal\": [damping] has a stiffness_factor"},
          {"modes = 4\ndamping = 0.01", "coordinates = \"nodal\"\nreference_frame = \"mean_axis\"",
           "f.toml:14:19: subsystem.1.body.1.reference_frame: is \"mean_axis\", which belongs to "
           "coordinates \"reduced\"; expected \"clamped\""},
          {"damping = 0.01", "damping = -0.01",
           "f.toml:14:11: subsystem.1.body.1.damping: is -0.01, expected a number of 0 or more"},
          {"damping = 0.01", "damping = [0.01, -0.02]",
           "f.toml:14:18: subsystem.1.body.1.damping.2: is -0.02, expected a number of 0 or more"},
          {"damping = 0.01", "damping = \"small\"",
           "f.toml:14:11: subsystem.1.body.1.damping: is \"small\", expected a number of 0 or "
           "more"},
          {"damping = 0.01", "reference_frame = \"chord\"",
           "f.toml:14:19: subsystem.1.body.1.reference_frame: is \"chord\", expected \"clamped\" "
           "or \"mean_axis\""},
          {"damping = 0.01", "geometric_stiffening = 1",
           "f.toml:14:24: subsystem.1.body.1.geometric_stiffening: is 1, expected true or false"},
          {"damping = 0.01", "length = 4.0",
           "f.toml:14:10: subsystem.1.body.1.length: does not belong to kind \"solid\""},
          {"damping = 0.01", "inertia = 4.0",
           "f.toml:14:11: subsystem.1.body.1.inertia: does not belong to kind \"solid\""},
          {"damping = 0.01", "mode = 4.0",
           "f.toml:14:1: subsystem.1.body.1.mode: unknown key, did you mean \"modes\"?"},
      });
}

TEST_CASE("matrices in place of a mesh are checked") {
  check_edits(
      kSolidText,
      {
          {"damping = 0.01", "mass = \"m.mtx\"",
           "f.toml:14:8: subsystem.1.body.1.mass: given along with mesh, expected only one of "
           "them"},
          {"damping = 0.01", "format = \"calculix\"",
           "f.toml:14:10: subsystem.1.body.1.format: given along with mesh, expected only one of "
           "them"},
          {"mesh = \"" + kBracket + "\"\n", "format = \"nastran\"\nmass = \"" + kBracket + "\"\n",
           "f.toml:10:10: subsystem.1.body.1.format: is \"nastran\", expected \"calculix\", "
           "\"abaqus\" or \"matrix_market\""},
          {"mesh = \"" + kBracket + "\"\n", "format = \"calculix\"\n",
           "f.toml:7:1: subsystem.1.body.1.mass: is missing, expected a file of the mass matrix"},
          {"mesh = \"" + kBracket + "\"\n", "mass = \"m.mtx\"\n",
           "f.toml:7:1: subsystem.1.body.1.format: is missing, expected \"calculix\", \"abaqus\" "
           "or \"matrix_market\""},
          {"mesh = \"" + kBracket + "\"\n",
           "format = \"calculix\"\nmass = \"" + kBracket + "\"\nstiffness = \"" + kBracket +
               "\"\nnodes = \"" + kBracket + "\"\n",
           "f.toml:15:12: subsystem.1.body.1.material: would be ignored, since the matrices have "
           "it; expected none"},
          {"mesh = \"" + kBracket +
               "\"\nscale = { length = 1e-3 }\nmaterial = { youngs_modulus = 7e10, poissons_ratio "
               "= 0.33, density = 2700 }\n",
           "geometric_stiffening = true\nformat = \"calculix\"\nmass = \"" + kBracket +
               "\"\nstiffness = \"" + kBracket + "\"\nnodes = \"" + kBracket + "\"\n",
           "f.toml:10:24: subsystem.1.body.1.geometric_stiffening: is true, but matrices do not "
           "tell the stresses; expected false, or files of geometric_stiffness"},
          {"mesh = \"" + kBracket +
               "\"\nscale = { length = 1e-3 }\nmaterial = { youngs_modulus = 7e10, poissons_ratio "
               "= 0.33, density = 2700 }\n",
           "format = \"calculix\"\nmass = \"" + kBracket + "\"\nstiffness = \"" + kBracket +
               "\"\nnodes = \"" + kBracket + "\"\ngeometric_stiffness = { own = [\"a\"] }\n",
           "f.toml:14:31: subsystem.1.body.1.geometric_stiffness.own: is an array (1), expected an "
           "array of 6 files"},
      });
}

TEST_CASE("interfaces of a solid are checked") {
  check_edits(
      kSolidText,
      {
          {kInterfaces, "",
           "f.toml:7:1: subsystem.1.body.1.interface: is missing, expected tables headed "
           "[[subsystem.body.interface]], of which the first one carries the frame"},
          {"name = \"root\"\n", "",
           "f.toml:15:1: subsystem.1.body.1.interface.1.name: is missing, expected a name"},
          {"name = \"root\"", "name = \"the root\"",
           "f.toml:16:8: subsystem.1.body.1.interface.1.name: is \"the root\", expected letters, "
           "digits, \"_\", \"-\" and \".\", 1 to 64 of them"},
          {"name = \"tip\"", "name = \"root\"",
           "f.toml:19:8: subsystem.1.body.1.interface.2.name: is \"root\" as another interface's, "
           "expected a name of its own"},
          {"nodes = \"ROOT\"", "nodes = \"ROT\"",
           "f.toml:17:9: subsystem.1.body.1.interface.1.nodes: is \"ROT\", did you mean \"ROOT\"?"},
          {"nodes = \"ROOT\"", "nodes = \"\"",
           "f.toml:17:9: subsystem.1.body.1.interface.1.nodes: is missing, expected the name of a "
           "set of the mesh, { plane = { ... } }, { cylinder = { ... } } or { box = { ... } }"},
          {"nodes = \"ROOT\"\n", "",
           "f.toml:15:1: subsystem.1.body.1.interface.1.nodes: is missing, expected the name of a "
           "set of the mesh, { plane = { ... } }, { cylinder = { ... } } or { box = { ... } }"},
          {"nodes = \"ROOT\"", "nodes = 3",
           "f.toml:17:9: subsystem.1.body.1.interface.1.nodes: is 3, expected the name of a set of "
           "the mesh, { plane = { ... } }, { cylinder = { ... } } or { box = { ... } }"},
          {"nodes = \"ROOT\"", "nodes = { sphere = { radius = 3 } }",
           "f.toml:17:11: subsystem.1.body.1.interface.1.nodes.sphere: unknown key, expected "
           "\"plane\", \"cylinder\" or \"box\""},
          {"nodes = \"ROOT\"", "nodes = { }",
           "f.toml:17:9: subsystem.1.body.1.interface.1.nodes: has 0 keys, expected one: plane, "
           "cylinder or box"},
          {"nodes = \"ROOT\"", "nodes = { plane = { point = [0, 0, 0.4], normal = [0, 0, 0] } }",
           "f.toml:17:51: subsystem.1.body.1.interface.1.nodes.plane.normal: has length 0, "
           "expected a direction"},
          {"nodes = \"ROOT\"", "nodes = { plane = { normal = [0, 0, 1] } }",
           "f.toml:17:19: subsystem.1.body.1.interface.1.nodes.plane.point: is missing, expected "
           "an array of 3 numbers (m)"},
          {"nodes = \"ROOT\"", "nodes = { plane = { point = [0, 0, 4], normal = [0, 0, 1] } }",
           "f.toml:17:9: subsystem.1.body.1.interface.1.nodes: chooses no nodes, expected some of "
           "the surface, which lies from (0, 0, 0) to (0.4, 0.1, 0.4) m"},
          {"nodes = \"ROOT\"",
           "nodes = { plane = { point = [0, 0, 0.4], normal = [0, 0, 1], tolerance = 0 } }",
           "f.toml:17:74: subsystem.1.body.1.interface.1.nodes.plane.tolerance: is 0, expected a "
           "number greater than 0 (m)"},
          {"nodes = \"ROOT\"",
           "nodes = { cylinder = { point = [0, 0, 0.4], axis = [0, 0, 1], radius = -1 } }",
           "f.toml:17:72: subsystem.1.body.1.interface.1.nodes.cylinder.radius: is -1, expected a "
           "number greater than 0 (m)"},
          {"nodes = \"ROOT\"",
           "nodes = { cylinder = { point = [0, 0, 0.4], axis = [0, 0, 0], radius = 1 } }",
           "f.toml:17:52: subsystem.1.body.1.interface.1.nodes.cylinder.axis: has length 0, "
           "expected a direction"},
          {"nodes = \"ROOT\"", "nodes = { box = { from = [0, 0, 0.4], to = [1, 1, 0] } }",
           "f.toml:17:51: subsystem.1.body.1.interface.1.nodes.box.to.3: is 0, expected at least "
           "0.4 (m), as in from"},
          {"nodes = \"ROOT\"", "nodes = { box = { from = [0, 0, 0.4], to = [1, 1] } }",
           "f.toml:17:44: subsystem.1.body.1.interface.1.nodes.box.to: is an array (2), expected "
           "an array of 3 numbers (m)"},
          {"nodes = \"TIP\"", "nodes = \"ROOT\"",
           "f.toml:20:9: subsystem.1.body.1.interface.2.nodes: shares node 2 with interface "
           "\"root\", expected nodes of its own (or both interfaces of kind \"average\")"},
          {"kind = \"average\"", "kind = \"rbe3\"",
           "f.toml:21:8: subsystem.1.body.1.interface.2.kind: is \"rbe3\", expected \"rigid\" or "
           "\"average\""},
          {"kind = \"average\"", "point = [0.4, 0.05]",
           "f.toml:21:9: subsystem.1.body.1.interface.2.point: is an array (2), expected an array "
           "of 3 numbers (m)"},
          {"kind = \"average\"", "weights = [1]",
           "f.toml:21:1: subsystem.1.body.1.interface.2.weights: unknown key, expected \"name\", "
           "\"nodes\", \"kind\" or \"point\""},
          {"modes = 4\ndamping = 0.01\n" + kInterfaces, "modes = 0\n" + kRoot,
           "f.toml:13:9: subsystem.1.body.1.modes: is 0, which leaves no coordinates; expected 1 "
           "or more, or a further interface, or kind = \"rigid\""},
          {"nodes = \"ROOT\"",
           "nodes = { box = { from = [-0.001, -0.001, 0.399], to = [0.001, 0.101, 0.401] } }",
           "f.toml:17:9: subsystem.1.body.1.interface.1.nodes: chooses 5 nodes on one line, "
           "expected three or more that are not on one line"},
      });
}
