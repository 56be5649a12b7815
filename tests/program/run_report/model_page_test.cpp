#include "program/run_report/model_page.h"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "tests/engine/bodies/space/system/models.h"
#include "tests/program/run_report/scenarios.h"

using namespace spoke;
using namespace spoke::run_report;
using namespace spoke::test;
using nlohmann::json;

namespace {

json data_of(const std::string& html) {
  const std::string begin = "id=\"model-data\">";
  const std::size_t from = html.find(begin) + begin.size();
  return json::parse(html.substr(from, html.find("</script>", from) - from));
}

}  // namespace

TEST_CASE("the page of a model has its scene, how its joints stand, and lists them") {
  const Scenario scenario = parse_scenario(make_text(kFlyingHub, kTree), "test");
  const std::string html = make_model_page(Simulation(scenario));
  const json data = data_of(html);
  CHECK(data["scene"]["joints"].size() == 5);
  // Seven numbers for each of five groups, 4 bytes each, in base64
  CHECK(data["groups"].get<std::string>().size() == 188);
  for (const char* part : {"<td>arm / mirror</td><td>spherical</td>", "<td>arm / whip</td>",
                           "sprung, sprung", "[0.3, 0.1, 0]"}) {
    CAPTURE(part);
    CHECK(html.find(part) != std::string::npos);
  }
}

TEST_CASE("the page of a planar rotor has its bodies and no joints") {
  const std::string html = make_model_page(Simulation(test_scenario()));
  CHECK(data_of(html)["scene"]["isPlanar"] == true);
  CHECK(html.find("two &lt;/script&gt; blades") != std::string::npos);
  CHECK(html.find("<td>blade 2 / body 2</td>") != std::string::npos);
  CHECK(html.find("Joints</h2>") == std::string::npos);
}
