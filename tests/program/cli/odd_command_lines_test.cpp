// Some hundred odd command lines and scenarios: none crashes, ends with a wrong status, or leaves
// anything half-written.

#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/program/cli/program.h"

namespace fs = std::filesystem;

namespace {

using Words = std::vector<std::string>;

/// A small scenario, so that what is accepted takes no time.
constexpr const char* kSmall = R"(
[hub]
drive = { kind = "spin_up", speed = 1.0, ramp = 1.0 }
[blade]
count = 2
length = 1.0
bodies = 1
elements = 1
density = 1000.0
area = 1e-4
second_moment = 1e-9
youngs_modulus = 1e9
[integration]
step = 0.01
duration = 0.05
)";

/// Status 0 without an error; or 2 or 3 with one line that is no internal error, 2 without a file.
void check_ending(const Words& words, const std::string& scenario = kSmall) {
  const WorkFolder folder;
  folder.write("s.toml", scenario);
  const Ended ended = run_spoke(words, folder, "timeout 60");
  std::string line;
  for (const std::string& word : words) line += word.substr(0, 100) + ' ';
  CAPTURE(line);
  CAPTURE(scenario);
  const std::string told_first = ended.err.substr(0, 300);
  CAPTURE(told_first);
  const bool is_known = ended.status == 0 || ended.status == 2 || ended.status == 3;
  CHECK(is_known);
  CHECK(ended.err.find("internal error") == std::string::npos);
  if (ended.status == 0) {
    for (const std::string& told : lines_of(ended.err)) CHECK(told.starts_with("warning: "));
  } else {
    CHECK_FALSE(ended.err.empty());
    const bool is_last_line = ended.err.find('\n') == ended.err.size() - 1 || ended.status == 3;
    CHECK(is_last_line);
  }
  if (ended.status == 2) CHECK(folder.entries() == 1);
  for (const auto& entry : fs::recursive_directory_iterator(folder.path()))
    CHECK(entry.path().extension() != ".tmp");
}

const Words kValues = {"",      "0",    "-1", "1e308", "nan",     "inf",
                       "1e999", "true", "[]", "{}",    "-1e-320", "99999999999999999999"};

}  // namespace

TEST_CASE("odd values of every option end in order") {
  const Words values = {"",     "0",    "-1",  "nan", "inf",  "1e400",
                        "0x10", "1,,2", " 1 ", "1x1", "2x99", "99999999999999999999"};
  for (const std::string option : {"--threads", "--window", "--executor", "--formulation",
                                   "--integrator", "--checkpoint-every", "--resume", "--set"})
    for (const std::string& value : values)
      check_ending({"run", "s.toml", "--quiet", "--out", "o", option, value});
  for (const std::string option : {"--steps", "--from", "--buffer", "--threads", "--more-threads"})
    for (const std::string& value : values)
      check_ending({"trace", "s.toml", "--out", "o", option, value});
}

TEST_CASE("odd lists of comparisons are refused in order") {
  for (const std::string value : {"", "0", "-1", "nan", "1,,2", ",", "1x1x1", "x", "1e9", "none"}) {
    for (const std::string option :
         {"--executors", "--threads", "--formulations", "--wait", "--spin", "--bind", "--repeat"})
      if (option != "--wait" || value != "none")
        check_ending({"compare", "s.toml", "--executors", "serial", "--formulations", "none",
                      "--out", "o", option, value});
  }
}

TEST_CASE("odd values of every key of a scenario end in order") {
  for (const std::string key : {"title",
                                "hub",
                                "hub.inertia",
                                "hub.mass",
                                "hub.radius",
                                "hub.support",
                                "hub.drive",
                                "hub.drive.speed",
                                "hub.drive.ramp",
                                "blade",
                                "blade.count",
                                "blade.length",
                                "blade.bodies",
                                "blade.elements",
                                "blade.density",
                                "blade.area",
                                "blade.youngs_modulus",
                                "blade.azimuth",
                                "gravity",
                                "damping.mass_factor",
                                "damping.stiffness_factor",
                                "load",
                                "load.1.force",
                                "integration.step",
                                "integration.duration",
                                "integration.spectral_radius",
                                "integration.tolerance",
                                "integration.iterations",
                                "limits.deflection",
                                "output.interval",
                                "",
                                ".",
                                "a..b",
                                "blade.1",
                                "\"\"",
                                "x.y.z"})
    for (const std::string& value : kValues)
      check_ending({value.size() % 2 == 0 ? "check" : "run", "s.toml", "--set", key + "=" + value});
}

TEST_CASE("odd texts of scenarios are refused in order") {
  const std::string small = kSmall;
  Words texts = {"",
                 "\n",
                 "\xEF\xBB\xBF",
                 "\xFF\xFE",
                 "[",
                 "[[",
                 "=",
                 "a",
                 "a=",
                 "[a]\n[a]\n",
                 "a = \"\\uD800\"",
                 "\"\"\"",
                 "# only a comment",
                 "[blade]",
                 "[[blade]]",
                 "blade = 1",
                 "[hub]\n[hub.drive]\nkind = 1",
                 std::string(100'000, '['),
                 std::string(100'000, 'a'),
                 small + "\n[blade]\n",
                 small + "\nx = 1",
                 small + "\n[[load]]\n",
                 small + "\n[[load]]\nforce = [1, 2, 3]",
                 small + "\n[[blades]]\n"};
  for (std::size_t end = 1; end < small.size(); end += 12) texts.push_back(small.substr(0, end));
  for (const std::string& text : texts) check_ending({"check", "s.toml"}, text);
}

TEST_CASE("odd orders of words end in order") {
  for (const Words& words :
       std::vector<Words>{{"run"},
                          {"run", "run"},
                          {"check", "check"},
                          {"--"},
                          {"--", "run"},
                          {"run", "--"},
                          {"run", "--", "s.toml", "--quiet"},
                          {"run", "s.toml", "s.toml"},
                          {"run", "s.toml", "--out"},
                          {"run", "--out", "s.toml"},
                          {"run", "s.toml", "--out", "s.toml"},
                          {"run", "s.toml", "--out", "s.toml/x"},
                          {"run", "s.toml", "--trace", "s.toml"},
                          {"run", "s.toml", "--resume", "s.toml"},
                          {"run", "s.toml", "--resume", "."},
                          {"run", "."},
                          {"run", "/dev/null"},
                          {"run", "s.toml/"},
                          {"check", "s.toml", "--quiet"},
                          {"check", "s.toml", "--out", "o"},
                          {"reproduce", "s.toml"},
                          {"reproduce", "--quick", "x"},
                          {"reproduce", "--set", "a=1"},
                          {"trace", "s.toml", "--quiet"},
                          {"compare"},
                          {"run", "s.toml", "--set"},
                          {"run", "s.toml", "--set", "=", "--set", "=="},
                          {"run", "s.toml", "--set", "a", "b", "c"},
                          {"-"},
                          {"-v"},
                          {"-h", "-h"},
                          {"--version", "x"},
                          {"run", "-"},
                          {"run", "-x.toml"},
                          {"run", "s.toml", "-"},
                          {"RUN", "s.toml"},
                          {"run", "s.toml", "--Quiet"},
                          {"run", "s.toml", "--quiet=maybe"},

                          {"run", "s.toml", "--out", std::string(5000, 'x')},
                          {std::string(5000, 'x')},
                          {"run", std::string(5000, 'x')},
                          {"run", "s.toml", "--out", "a\nb", "--trace", "s.toml"},
                          {"run", "no\nfile"},
                          {"run", "s.toml", "--set", "title=\"a\\nb\""},
                          {"trace", "s.toml", "--out", "/proc/x"},
                          {"compare", "s.toml", "--out", "/proc/x"},
                          {"compare", "s.toml", "--out", "/dev/null"}})
    check_ending(words);
}
