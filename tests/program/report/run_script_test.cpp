#include "program/report/run_script.h"

#include <doctest/doctest.h>

#include <fstream>
#include <initializer_list>
#include <iterator>
#include <string>

#include "program/report/model_script.h"
#include "program/report/modes_script.h"
#include "program/report/static_script.h"
#include "program/report/study_script.h"

namespace {

std::string read_scripts(std::initializer_list<const char*> names) {
  std::string sources;
  for (const char* name : names) {
    std::ifstream stream(std::string(SPOKE_REPORT_DIR) + '/' + name, std::ios::binary);
    sources.append(std::istreambuf_iterator<char>(stream), {});
  }
  return sources;
}

}  // namespace

TEST_CASE("the embedded scripts are their sources, letter by letter") {
  const std::string scene =
      read_scripts({"page_tools.js", "space_math.js", "solid_surfaces.js", "scene.js",
                    "scene_colors.js", "camera.js", "scene_marks.js", "scene_view.js"});
  CHECK(scene.size() > 10000);
  CHECK(spoke::report::run_script() == scene + read_scripts({"model_animation.js", "time_plots.js",
                                                             "play_clock.js", "run_page.js"}));
  CHECK(spoke::report::model_script() == scene + read_scripts({"fit_view.js", "model_page.js"}));
  const std::string steady = scene + read_scripts({"fit_view.js", "steady_states.js"});
  CHECK(spoke::report::static_script() == steady + read_scripts({"static_page.js"}));
  CHECK(spoke::report::modes_script() ==
        steady + read_scripts({"mode_choice.js", "speed_plot.js", "play_clock.js", "mode_view.js",
                               "modes_page.js"}));
  CHECK(spoke::report::study_script() ==
        read_scripts({"page_tools.js", "run_table.js", "parallel_plot.js", "study_page.js"}));
  CHECK(spoke::report::study_script().find("</script") == std::string::npos);
  CHECK(spoke::report::static_script().find("</script") == std::string::npos);
  CHECK(spoke::report::modes_script().find("</script") == std::string::npos);
  CHECK(spoke::report::run_script().find("</script") == std::string::npos);
}
