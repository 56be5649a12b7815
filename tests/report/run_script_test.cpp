#include "engine/report/run_script.h"

#include <doctest/doctest.h>

#include <fstream>
#include <iterator>
#include <string>

TEST_CASE("the embedded script is its sources, letter by letter") {
  std::string sources;
  for (const char* name : {"time_plots.js", "rotor_view.js", "run_page.js"}) {
    std::ifstream stream(std::string(SPOKE_REPORT_DIR) + '/' + name, std::ios::binary);
    sources.append(std::istreambuf_iterator<char>(stream), {});
  }
  CHECK(sources.size() > 10000);
  CHECK(spoke::report::run_script() == sources);
  CHECK(sources.find("</script") == std::string::npos);
}
