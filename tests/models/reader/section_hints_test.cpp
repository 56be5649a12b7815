#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "models/hints.h"
#include "tests/models/reader/spatial_texts.h"

using namespace spoke;
using namespace spoke::test;

namespace {

std::vector<std::string> hints_at(const std::string& sections) {
  return find_hints(parse_scenario(
      "world = \"space\"\n[hub.drive]\nkind = \"fixed\"\n[blade]\ncount = 2\nlength = "
      "20.0\n[blade.sections]\nmass_per_length = 25.0\nflap_stiffness = 4e6\n"
      "torsion_stiffness = 1e6\n" +
          sections + "[integration]\nduration = 1.0\nstep = 0.01\n",
      "f.toml"));
}

}  // namespace

TEST_CASE("a default inertia that no section has is asked about") {
  // sqrt(4e6 / 1e6) is 2 m; sqrt(1e12 / 1e6) is 1000 m.
  CHECK(hints_at("axial_stiffness = 1e6\nlag_stiffness = 4e6\n").empty());
  CHECK(hints_at("axial_stiffness = 1e6\nlag_stiffness = [4e6, 1e12]\n") ==
        std::vector<std::string>{
            "the default lag_inertia of blade 1 makes a radius of gyration of 1000 m at station 20 "
            "m, as that of lag_stiffness 1e+12 N m^2 and axial_stiffness 1e+06 N is, in a beam of "
            "20 m: give lag_inertia, or the stiffness that is meant"});
  CHECK(hints_at("axial_stiffness = 4.0\nlag_stiffness = 4e6\n").size() == 2);
  CHECK(hints_at("axial_stiffness = 4.0\nlag_stiffness = 4e6\nlag_inertia = 1.0\nflap_inertia = "
                 "1.0\n")
            .empty());
}
