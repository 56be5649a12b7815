#include "engine/formulation.h"

#include <doctest/doctest.h>

#include <cmath>

#include "tests/engine/rotors.h"
#include "tests/message_of.h"
#include "tests/relative_difference.h"

using namespace spoke;
using namespace spoke::test;

namespace {

/// The three formulations on one random state of one random rotor.
void check_agreement(const RandomRotor& kind, double tolerance, std::mt19937& random) {
  const Rotor rotor = make_random_rotor(kind, random);
  SystemContext<Plane> structured, subsystem, augmented;
  make_context(rotor, Formulation::structured, Rk4{1e-5}, structured);
  make_context(rotor, Formulation::subsystem, Rk4{1e-5}, subsystem);
  make_context(rotor, Formulation::augmented, Rk4{1e-5}, augmented);
  randomize_state(random, structured);
  copy_state(structured, subsystem);
  copy_state(structured, augmented);
  const Evaluation a = evaluate(6.0, structured);
  const Evaluation b = evaluate(6.0, subsystem);
  const Evaluation c = evaluate(6.0, augmented);
  REQUIRE(a.accelerations.allFinite());
  CHECK(relative_difference(a.accelerations, c.accelerations) < tolerance);
  CHECK(relative_difference(b.accelerations, c.accelerations) < tolerance);
  CHECK(relative_difference(a.wrenches, c.wrenches) < tolerance);
  CHECK(relative_difference(b.wrenches, c.wrenches) < tolerance);
  const double scale = c.wrenches.lpNorm<Eigen::Infinity>();
  CHECK((a.hub_reaction - c.hub_reaction).lpNorm<Eigen::Infinity>() < tolerance * scale);
  CHECK((b.hub_reaction - c.hub_reaction).lpNorm<Eigen::Infinity>() < tolerance * scale);
}

/// The three formulations on one random state with the block of an implicit step.
void check_implicit(const Rotor& rotor, std::mt19937& random) {
  const Method method = make_generalized_alpha(0.8, 0.01);
  SystemContext<Plane> first, second, third;
  make_context(rotor, Formulation::structured, method, first);
  make_context(rotor, Formulation::subsystem, method, second);
  make_context(rotor, Formulation::augmented, method, third);
  randomize_state(random, first);
  copy_state(first, second);
  copy_state(first, third);
  const Evaluation a = evaluate(6.0, first, true);
  const Evaluation b = evaluate(6.0, second, true);
  const Evaluation c = evaluate(6.0, third, true);
  CHECK(relative_difference(a.accelerations, c.accelerations) < 1e-11);
  CHECK(relative_difference(b.accelerations, c.accelerations) < 1e-11);
}

/// The condensed mass left at a clamped frame is that of a fraction of its first element, so its
/// conditioning grows with E^3: every formulation loses those digits alike.
double tolerance_for(int elements) { return 1e-11 * std::max(1.0, std::pow(elements / 4.0, 3)); }

}  // namespace

TEST_CASE("the formulations agree in every acceleration and multiplier") {
  std::mt19937 random(20170941);
  for (const int elements : {1, 2, 3, 4, 5, 8, 16})
    for (const HubSupport support : {HubSupport::axle, HubSupport::free})
      for (const bool is_driven : {true, false})
        for (int round = 0; round < (elements > 8 ? 2 : 8); ++round) {
          CAPTURE(elements);
          CAPTURE(is_driven);
          check_agreement({elements, support, is_driven}, tolerance_for(elements), random);
        }
}

TEST_CASE("the formulations agree on a fine mesh to what its conditioning leaves") {
  std::mt19937 random(64);
  check_agreement({64, HubSupport::axle, true}, tolerance_for(64), random);
}

TEST_CASE("the formulations agree in the implicit evaluation") {
  std::mt19937 random(7);
  for (int round = 0; round < 10; ++round)
    check_implicit(make_random_rotor({4, HubSupport::free, false}, random), random);
}

TEST_CASE("a formulation is found by its name, others are told") {
  CHECK(formulations().size() == 3);
  for (const Formulation formulation : formulations())
    CHECK(formulation_of(name_of(formulation)) == formulation);
  CHECK(message_of([] { formulation_of("dense"); }) ==
        "formulation: \"dense\", expected one of \"structured\", \"subsystem\", \"augmented\"");
}
