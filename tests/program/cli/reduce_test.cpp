// Solids on the command line: spoke reduce, the cache, studies, checkpoints.

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/contains.h"
#include "tests/program/cli/program.h"

using spoke::test::contains;
namespace fs = std::filesystem;

namespace {

constexpr const char* kCached = "env SPOKE_CACHE=cache";
constexpr const char* kUncached = "env SPOKE_CACHE=none";

/// A bar of 1 x 0.1 x 0.1 m, 8 linear hexahedra, as an .inp file; `moved`: of one inner node [m].
std::string make_bar_mesh(double moved = 0.0) {
  std::string nodes = "*NODE\n", elements = "*ELEMENT, TYPE=C3D8, ELSET=ALL\n";
  std::string root = "*NSET, NSET=ROOT\n", tip = "*NSET, NSET=TIP\n";
  for (int i = 0; i <= 8; ++i)
    for (int c = 0; c < 4; ++c) {
      const int label = 4 * i + c + 1;
      const double y = c == 1 || c == 2 ? 0.1 : 0.0, z = c >= 2 ? 0.1 : 0.0;
      const double x = 0.125 * i + (label == 17 ? moved : 0.0);
      nodes += std::to_string(label) + ", " + std::to_string(x) + ", " + std::to_string(y) + ", " +
               std::to_string(z) + "\n";
      if (i == 0) root += std::to_string(label) + ",\n";
      if (i == 8) tip += std::to_string(label) + ",\n";
    }
  for (int e = 0; e < 8; ++e) {
    elements += std::to_string(e + 1);
    for (const int i : {e, e + 1})
      for (int c = 0; c < 4; ++c) elements += ", " + std::to_string(4 * i + c + 1);
    elements += "\n";
  }
  return nodes + elements + root + tip;
}

/// A rubber bar that hangs from the hub.
const char* const kBarText = R"(
title = "A bar"
world = "space"
[hub.drive]
kind = "fixed"
[gravity]
acceleration = [0.0, 0.0, -9.81]
[[subsystem]]
name = "holder"
[[subsystem.body]]
name = "bar"
kind = "solid"
mesh = "bar.inp"
material = { youngs_modulus = 1e8, poissons_ratio = 0.3, density = 1000.0 }
modes = 6
damping = 0.03
[[subsystem.body.interface]]
name = "root"
nodes = "ROOT"
[[subsystem.body.interface]]
name = "tip"
nodes = "TIP"
[[subsystem.joint]]
parent = "hub"
child = "bar"
kind = "fixed"
[[sensor]]
quantity = "displacement"
name = "end"
subsystem = "holder"
body = "bar"
interface = "tip"
[integration]
step = 1e-3
duration = 0.02
)";

void write_bar(const WorkFolder& folder, double moved = 0.0) {
  folder.write("bar.inp", make_bar_mesh(moved));
  folder.write("bar.toml", kBarText);
}

/// Names of the files in a folder, sorted.
std::vector<std::string> files_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

/// Returns the lines from the table on, which do not depend on the cache.
std::vector<std::string> table_of(const std::string& out) {
  std::vector<std::string> lines = lines_of(out);
  const auto at = std::find(lines.begin(), lines.end(), "Modes of holder / bar");
  REQUIRE(at != lines.end());
  return {at, lines.end()};
}

}  // namespace

TEST_CASE("reduce prints mesh, interfaces and modes, and the cache gives the same ones") {
  const WorkFolder folder;
  write_bar(folder);
  const Ended none = run_spoke({"reduce", "bar.toml"}, folder, kUncached);
  CAPTURE(none.err);
  CHECK(none.status == 0);
  CHECK(folder.entries() == 2);
  for (const char* part :
       {"A bar\n", "  holder          bar: bar.inp, 36 nodes, 8 elements, 10 kg\n",
        "  interfaces      root: rigid, 4 nodes at [0, 0, 0] m, 0.01 m^2\n",
        "                  tip: rigid, 4 nodes at [1, 0, 0] m, 0.01 m^2\n",
        "  coordinates     12 modes, from 6 vibration modes and 6 static shapes\n",
        "; there is no cache\n", "  memory          about ", "frequency [Hz]", "damping ratio",
        "vibration mode [Hz]"}) {
    CAPTURE(part);
    CHECK(contains(none.out, part));
  }
  CHECK(table_of(none.out).size() == 2 + 12);
  // Linear elements are told of, by every command.
  for (const std::string command : {"reduce", "check"}) {
    const Ended ended = run_spoke({command, "bar.toml"}, folder, kUncached);
    REQUIRE(lines_of(ended.err).size() == 1);
    CHECK(
        ended.err.starts_with("warning: bar.toml: the mesh of holder / bar has linear elements "
                              "(hex8), which lock"));
  }

  const Ended made = run_spoke({"reduce", "bar.toml"}, folder, kCached);
  CHECK(contains(made.out, "; kept in cache/solid-"));
  REQUIRE(files_in(folder.path() / "cache").size() == 1);
  const Ended read = run_spoke({"reduce", "bar.toml"}, folder, kCached);
  CHECK(contains(read.out, " s from cache/solid-"));
  const Ended forced = run_spoke({"reduce", "bar.toml", "--force"}, folder, kCached);
  CHECK(contains(forced.out, "; kept in cache/solid-"));
  for (const Ended* ended : {&made, &read, &forced})
    CHECK(table_of(ended->out) == table_of(none.out));
  // Another number of modes is another file.
  CHECK(run_spoke({"reduce", "bar.toml", "--set", "subsystem.1.body.1.modes=7"}, folder, kCached)
            .status == 0);
  CHECK(files_in(folder.path() / "cache").size() == 2);
}

TEST_CASE("a damaged cache is made anew, and the bits of a run do not depend on it") {
  const WorkFolder folder;
  write_bar(folder);
  const auto run = [&](const std::string& out, const char* before) {
    const Ended ended = run_spoke({"run", "bar.toml", "--quiet", "--out", out}, folder, before);
    CAPTURE(ended.err);
    REQUIRE(ended.status == 0);
    return file_text(folder.path() / out / "sensors.csv");
  };
  const std::string rows = run("none", kUncached);
  CHECK(run("made", kCached) == rows);
  CHECK(run("read", kCached) == rows);
  const std::vector<std::string> files = files_in(folder.path() / "cache");
  REQUIRE(files.size() == 1);
  const fs::path file = folder.path() / "cache" / files[0];
  const std::string whole = file_text(file);
  for (const std::size_t at : {std::size_t{0}, std::size_t{20}, whole.size() / 2}) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 1);
    std::ofstream(file, std::ios::binary) << damaged;
    CHECK(run("damaged", kCached) == rows);
    CHECK(file_text(file) == whole);
  }
  std::ofstream(file, std::ios::binary) << whole.substr(0, whole.size() / 2);
  CHECK(run("cut", kCached) == rows);
  // A folder that cannot be made is no cache.
  folder.write("taken", "");
  CHECK(run("nowhere", "env SPOKE_CACHE=taken/cache") == rows);
}

TEST_CASE("reduce says that there is no solid, and where a solid cannot be reduced") {
  const WorkFolder folder;
  for (const char* scenario : {"heavy_top", "wu_haug_rotor"}) {
    const Ended ended = run_spoke({"reduce", shipped(scenario)}, folder, kUncached);
    CHECK(ended.status == 0);
    CHECK(contains(ended.out, "  solids          none: no body is of kind \"solid\"\n"));
  }
  write_bar(folder);
  for (const std::string command : {"reduce", "check", "run", "static", "modes"}) {
    const Ended ended = run_spoke({command, "bar.toml", "--set", "subsystem.1.body.1.modes=1000"},
                                  folder, kUncached);
    CAPTURE(command);
    CAPTURE(ended.err);
    CHECK(ended.status == 2);
    CHECK(contains(ended.err, "subsystem.1.body.1.modes"));
    CHECK(contains(ended.err, "1000 modes, expected at most "));
  }
  CHECK_FALSE(fs::exists(folder.path() / "results"));
}

TEST_CASE("threads of a study that reduce the same solid at once share the cache") {
  const WorkFolder folder;
  write_bar(folder);
  folder.write("study.toml",
               "scenario = \"bar.toml\"\ndesign = { kind = \"grid\" }\n"
               "[[parameter]]\nkey = \"subsystem.1.body.1.modes\"\nvalues = [4, 8]\n"
               "[[parameter]]\nkey = \"integration.duration\"\nrange = [0.01, 0.02, 6]\n"
               "[[response]]\nsensor = \"holder.end.z\"\nkind = \"min\"\n");
  const auto run = [&](const std::string& threads, const std::string& out, const char* before) {
    const Ended ended =
        run_spoke({"study", "study.toml", "--threads", threads, "--out", out}, folder, before);
    CAPTURE(ended.err);
    REQUIRE(ended.status == 0);
    return file_text(folder.path() / out / "runs.csv");
  };
  const std::string alone = run("1", "alone", kUncached);
  CHECK(lines_of(alone).size() == 1 + 12);
  CHECK(run("4", "four", kCached) == alone);
  CHECK(run("4", "again", kCached) == alone);
  const std::vector<std::string> files = files_in(folder.path() / "cache");
  CHECK(files.size() == 2);
  for (const std::string& file : files) CHECK(file.ends_with(".bin"));
}

TEST_CASE("a checkpoint is not resumed with another mesh, but with the same one elsewhere") {
  const WorkFolder folder;
  write_bar(folder);
  REQUIRE(run_spoke({"run", "bar.toml", "--quiet", "--out", "o", "--checkpoint-every", "9"}, folder,
                    kUncached)
              .status == 0);
  const auto resume = [&](const std::string& scenario) {
    return run_spoke({"run", scenario, "--quiet", "--out", "more", "--resume", "o/checkpoint.spoke",
                      "--set", "integration.duration=0.04"},
                     folder, kUncached);
  };
  write_bar(folder, 1e-3);
  const Ended refused = resume("bar.toml");
  CAPTURE(refused.err);
  CHECK(refused.status == 2);
  CHECK(contains(refused.err, "subsystem.1.body.1.mesh is \"contents "));
  fs::create_directory(folder.path() / "elsewhere");
  write_bar(folder);
  for (const char* file : {"bar.toml", "bar.inp"})
    fs::rename(folder.path() / file, folder.path() / "elsewhere" / file);
  const Ended resumed = resume("elsewhere/bar.toml");
  CAPTURE(resumed.err);
  CHECK(resumed.status == 0);
}
