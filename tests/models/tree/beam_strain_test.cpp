#include "models/tree/beam_strain.h"

#include <doctest/doctest.h>

#include "models/scenario.h"
#include "models/tree/tree.h"

using namespace spoke;
using spoke::spatial::BeamStrain;

namespace {

/// A rotor of one blade on a hub that its drive turns.
spatial::Model make_rotor() {
  return *parse_scenario(R"(world = "space"
[hub.drive]
kind = "constant"
speed = 4.0
[blade]
count = 1
length = 8.0
[blade.sections]
mass_per_length = 3.0
axial_stiffness = 1e7
flap_stiffness = 1e3
lag_stiffness = 9e3
torsion_stiffness = 1e3
[integration]
duration = 1.0
step = 0.01
)",
                         "f.toml")
              .space;
}

BeamStrain strain_in(const spatial::Model& model) {
  return build_trees(model).front().beams.front().strain;
}

}  // namespace

TEST_CASE("beams on a hub that turns them have linear strains, all others nonlinear ones") {
  spatial::Model model = make_rotor();
  CHECK(model.blades[0].beam.strain == BeamStrain::automatic);
  CHECK(strain_in(model) == BeamStrain::linear);
  model.hub.drive = TorqueDrive{Curve{1.0}};
  CHECK(strain_in(model) == BeamStrain::linear);
  model.hub.drive = FreeDrive{2.0};
  CHECK(strain_in(model) == BeamStrain::linear);
  model.hub.drive = FreeDrive{};
  CHECK(strain_in(model) == BeamStrain::nonlinear);
  model.hub.drive = FixedDrive{};
  CHECK(strain_in(model) == BeamStrain::nonlinear);
  CHECK(find_unknown_tension(model, model.blades[0]) == "no drive turns the hub");
}

TEST_CASE("a joint that moves and a loop ask for nonlinear strains") {
  spatial::Model model = make_rotor();
  model.blades[0].joints.push_back({1.0, {}});
  CHECK(strain_in(model) == BeamStrain::linear);
  spatial::Joint& joint = model.blades[0].joints[0].joint;
  joint.name = "flap";
  joint.kind = spatial::JointKind::revolute;
  joint.axes[0] = spatial::Vector::UnitY();
  CHECK(strain_in(model) == BeamStrain::nonlinear);
  CHECK(find_unknown_tension(model, model.blades[0]) == "joint flap moves it");
  model.blades[0].joints.clear();
  Loop loop;
  loop.from.carrier = LoopPlace::Carrier::body;
  loop.to.carrier = LoopPlace::Carrier::hub;
  model.blades[0].loops.push_back(loop);
  CHECK(strain_in(model) == BeamStrain::nonlinear);
  CHECK(find_unknown_tension(model, model.blades[0]) == "a loop pulls at it");
}

TEST_CASE("an axis beside the centres asks for nonlinear strains") {
  spatial::Model model = make_rotor();
  spatial::Sections& sections = model.blades[0].beam.sections;
  // The radius of gyration of the section is sqrt(1e4/1e7) = 0.0316 m.
  sections.mass_center = {{0.009, 0.0}, {0.0, 0.0}};
  CHECK(strain_in(model) == BeamStrain::linear);
  sections.mass_center = {{0.011, 0.0}, {0.0, 0.0}};
  CHECK(strain_in(model) == BeamStrain::nonlinear);
  sections.mass_center.clear();
  sections.tension_center = {{0.0, 0.0}, {0.0, 0.011}};
  CHECK(strain_in(model) == BeamStrain::nonlinear);
  CHECK(has_axis_beside(model.blades[0].beam));
}

TEST_CASE("what a description says of its strains is not chosen anew") {
  spatial::Model model = make_rotor();
  model.blades[0].beam.strain = BeamStrain::nonlinear;
  CHECK(strain_in(model) == BeamStrain::nonlinear);
  model.hub.drive = FixedDrive{};
  model.blades[0].beam.strain = BeamStrain::linear;
  CHECK(strain_in(model) == BeamStrain::linear);
  model.blades[0].beam.strain = BeamStrain::automatic;
  model.blades[0].beam.geometric_stiffening = false;
  CHECK(strain_in(model) == BeamStrain::linear);
}
