#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "models/hints.h"
#include "tests/contains.h"
#include "tests/models/reader/spatial_texts.h"

using namespace spoke;
using namespace spoke::test;

namespace {

/// An arm of 3 kg at 0.5 m from its pin, on a rod or alone.
std::vector<std::string> hints_at(const std::string& inertia, bool has_rod) {
  const std::string rod =
      ", { name = 'rod', kind = 'beam', length = 1.0, sections = { mass_per_length = 1.0, "
      "axial_stiffness = 1e7, flap_stiffness = 1e3, lag_stiffness = 1e3, torsion_stiffness = 1e3 } "
      "}";
  return find_hints(parse_scenario(
      "world = 'space'\n[hub.drive]\nkind = 'fixed'\n[[subsystem]]\nname = 'g'\n"
      "body = [ { name = 'arm', kind = 'rigid', mass = 3.0, center = [0.5, 0, 0], inertia = " +
          inertia + " }" + (has_rod ? rod : "") +
          " ]\njoint = [ { name = 'pin', parent = 'hub', child = 'arm', kind = 'revolute', "
          "axis = [0, 1, 0] }" +
          (has_rod ? ", { parent = 'hub', child = 'rod', kind = 'fixed' }" : "") +
          " ]\n[integration]\nduration = 1.0\nstep = 0.01\n",
      "f.toml"));
}

}  // namespace

TEST_CASE("a body of next to no inertia beside flexible ones is told, with its joint") {
  // 3 kg times 0.25 m^2 is 0.75 kg m^2; the largest ratio allowed is 1e5.
  CHECK(hints_at("1e-9", false).empty());
  CHECK(hints_at("1e-4", true).empty());
  const std::vector<std::string> hints = hints_at("1e-9", true);
  REQUIRE(hints.size() == 1);
  CHECK(contains(hints[0], "the inertia of g / arm about its centre of mass"));
  CHECK(contains(hints[0], "joint pin"));
  CHECK(contains(hints[0], "7.5e-06 kg m^2 or more"));
  // A slender rod along its own axis has little inertia about that axis, which its mass has not
  // either.
  CHECK(hints_at("[1e-12, 0.1, 0.1]", true).empty());
}
