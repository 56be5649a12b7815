// A rotor in the plane moves alike in both worlds.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "tests/engine/bodies/space/system/runs.h"

using namespace spoke;
using namespace spoke::test;

namespace {

const RunSetup kSetup{make_generalized_alpha(0.8, 0.005), 1e-10};
constexpr int kSteps = 600;

using Trace = std::vector<Eigen::VectorXd>;

Trace planar_trace(ReferenceFrame frame, BeamStrain strain = BeamStrain::linear) {
  Rotor rotor = read_model("wu_haug_rotor.toml").rotor;
  for (Blade& blade : rotor.blades) {
    blade.reference_frame = frame;
    blade.strain = strain;
  }
  Run<Plane> run(make_system(rotor), kSetup);
  run.advance(kSteps);
  return run.trace;
}

Trace spatial_trace(ReferenceFrame frame, const spatial::Vector& axis,
                    Formulation formulation = Formulation::structured, int steps = kSteps,
                    BeamStrain strain = BeamStrain::linear) {
  spatial::Model model = *read_model("spatial_wu_haug.toml").space;
  for (spatial::Blade& blade : model.blades) {
    blade.beam.reference_frame = frame;
    blade.beam.strain = strain;
  }
  model.hub.axis = axis;
  RunSetup setup = kSetup;
  setup.formulation = formulation;
  Run<Space> run(make_system(model), setup);
  run.advance(steps);
  return run.trace;
}

/// How far apart they are, over as many steps as `space` has.
struct Departure {
  double within = 0.0;  ///< of the tips in the plane [m]
  double out = 0.0;     ///< of it [m]
};

Departure compare(const Trace& plane, const Trace& space) {
  Departure most;
  for (std::size_t n = 0; n < space.size(); ++n)
    for (Eigen::Index i = 0; i < 3; ++i) {
      const Eigen::Vector3d tip = space[n].segment<3>(3 * i);
      most.within =
          std::max(most.within, (tip.head<2>() - plane[n].segment<2>(2 * i)).cwiseAbs().maxCoeff());
      most.out = std::max(most.out, std::abs(tip.z()));
    }
  return most;
}

}  // namespace

TEST_CASE("a rotor that could leave the plane moves as one that cannot") {
  for (const ReferenceFrame frame : {ReferenceFrame::clamped, ReferenceFrame::chord}) {
    CAPTURE(name_of(frame));
    const Trace plane = planar_trace(frame);
    CHECK(plane.back().norm() > 0.1);
    const Departure most = compare(plane, spatial_trace(frame, spatial::Vector::UnitZ()));
    CHECK(most.within < 1e-8);
    CHECK(most.out < 1e-12);
  }
}

TEST_CASE("strains of second order in the plane are those of a model in space") {
  for (const ReferenceFrame frame : {ReferenceFrame::clamped, ReferenceFrame::chord}) {
    CAPTURE(name_of(frame));
    const Trace plane = planar_trace(frame, BeamStrain::nonlinear);
    const Departure most =
        compare(plane, spatial_trace(frame, spatial::Vector::UnitZ(), Formulation::structured,
                                     kSteps, BeamStrain::nonlinear));
    CHECK(most.within < 1e-8);
    CHECK(most.out < 1e-12);
  }
}

TEST_CASE("a rotor that could leave the plane moves so by the dense formulations too") {
  const Trace plane = planar_trace(ReferenceFrame::chord);
  for (const Formulation formulation : {Formulation::subsystem, Formulation::augmented}) {
    CAPTURE(name_of(formulation));
    const Departure most = compare(
        plane, spatial_trace(ReferenceFrame::chord, spatial::Vector::UnitZ(), formulation, 60));
    CHECK(most.within < 1e-8);
    CHECK(most.out < 1e-12);
  }
}

TEST_CASE("a rotor moves alike about whatever axis") {
  const ReferenceFrame frame = ReferenceFrame::clamped;
  const Trace upright = spatial_trace(frame, spatial::Vector::UnitZ());
  for (const spatial::Vector& axis : {spatial::Vector(1.0, -2.0, 0.7), spatial::Vector(0, 0, -1)}) {
    const Trace turned = spatial_trace(frame, axis);
    double most = 0.0;
    for (std::size_t n = 0; n < upright.size(); ++n)
      most = std::max(most, (upright[n] - turned[n]).cwiseAbs().maxCoeff());
    CHECK(most < 1e-9);
  }
}
