#include "engine/simulation/model_identity.h"

#include <doctest/doctest.h>

#include "tests/models/reader/loop_texts.h"

using namespace spoke;

namespace {

/// Returns what differs between a scenario, as saved, and the same with overrides.
std::string difference_by(const std::string& text, const Overrides& overrides) {
  const auto identity = [](const Scenario& scenario) {
    return make_identity(scenario, Formulation::structured, scenario.integration.step);
  };
  return find_difference(identity(parse_scenario(text, "f")),
                         identity(parse_scenario(text, "f", overrides)));
}

}  // namespace

TEST_CASE("closed loops and anchors are part of a model's identity") {
  const std::string& text = test::kPitchLinkText;
  CHECK(difference_by(text, {"integration.duration=1"}).empty());
  CHECK(difference_by(text, {"blade.loop.1.length=0.3"}) ==
        "blades.1.loop.1.length is absent in the saved state and 0.3 here");
  CHECK(difference_by(text, {"blade.loop.1.to=hub"}) ==
        "blades.1.loop.1.to.anchor is \"swashplate\" in the saved state and absent here");
  CHECK(difference_by(text, {"anchor.1.turns_with_hub=false"}) ==
        "anchor.1.turns_with_hub is true in the saved state and false here");
  CHECK(difference_by(text, {"integration.loop_redundancy=1e-6"}) ==
        "integration.loop_redundancy is 1e-09 in the saved state and 1e-06 here");
}
