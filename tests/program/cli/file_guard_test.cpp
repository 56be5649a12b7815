// What commands may write over: their own earlier results, never a file that they read, and files
// of other kinds with --force alone.

#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/contains.h"
#include "tests/program/cli/program.h"
#include "tests/program/cli/refusal.h"

using spoke::test::contains;
namespace fs = std::filesystem;

namespace {

using Words = std::vector<std::string>;

Words with(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// A command that writes a file that its user names behind the last word.
struct Writer {
  std::string reads;  ///< name of the file that is read
  fs::path like;      ///< what stands in it
  Words words;
};

const fs::path kForeign = SPOKE_FOREIGN_FILES;

std::vector<Writer> writers() {
  std::vector<Writer> all = {
      {"s.toml", shipped("wu_haug_rotor"), {"check", "s.toml", "--html"}},
      {"s.toml", shipped("spatial_wu_haug"), {"export", "beamdyn", "s.toml", "--out"}},
      {"small_BeamDyn_blade.dat",
       kForeign / "small_BeamDyn_blade.dat",
       {"import", "small_BeamDyn.dat", "--out"}},
      {"s.toml",
       shipped("nrel_5mw_in_wind"),
       {"wind", "s.toml", "--set", "wind.turbulence.duration=20", "--out"}}};
#ifdef SPOKE_HAS_FMU
  all.push_back({"s.fmu", shipped("wu_haug_rotor"), {"fmu", "s.fmu", "--out"}});
#endif
  return all;
}

void prepare(const Writer& writer, const WorkFolder& folder) {
  folder.write("small_BeamDyn.dat", file_text(kForeign / "small_BeamDyn.dat"));
  folder.write(writer.reads, file_text(writer.like));
  if (writer.words.front() == "wind")  // its scenario names them
    fs::create_directory_symlink(writer.like.parent_path() / "airfoils",
                                 folder.path() / "airfoils");
}

}  // namespace

TEST_CASE("no command writes over a file that it reads, by whatever name") {
  for (const Writer& writer : writers()) {
    CAPTURE(writer.words.front());
    const WorkFolder folder;
    prepare(writer, folder);
    const std::string before = file_text(writer.like);
    fs::create_symlink(writer.reads, folder.path() / "soft.fmu");
    fs::create_hard_link(folder.path() / writer.reads, folder.path() / "hard.fmu");
    const std::string full = (folder.path() / writer.reads).string();
    for (const std::string& name : {writer.reads, "./" + writer.reads, full,
                                    std::string("soft.fmu"), std::string("hard.fmu")})
      for (const Words& force : {Words{}, Words{"--force"}})
        check_refused(with(with(writer.words, {name}), force),
                      name + ": cannot be written: the command reads this file", folder);
    CHECK(file_text(folder.path() / writer.reads) == before);
    CHECK(fs::is_symlink(folder.path() / "soft.fmu"));
    CHECK(file_text(folder.path() / "hard.fmu") == before);
  }
}

TEST_CASE("a file of another kind is replaced with --force only") {
  const std::string notes = "[notes]\nof = \"the user\"\n";
  for (const Writer& writer : writers()) {
    CAPTURE(writer.words.front());
    const WorkFolder folder;
    prepare(writer, folder);
    folder.write("notes.fmu", notes);
    const Words words = with(writer.words, {"notes.fmu"});
    check_refused(words, "notes.fmu: cannot be written: there is a file that is not a", folder);
    CHECK(file_text(folder.path() / "notes.fmu") == notes);
    CHECK(run_spoke(with(words, {"--force"}), folder).status == 0);
    const std::string written = file_text(folder.path() / "notes.fmu");
    CHECK(written != notes);
    // What the command wrote itself, it writes again.
    CHECK(run_spoke(words, folder).status == 0);
    CHECK(file_text(folder.path() / "notes.fmu").size() == written.size());
  }
}

TEST_CASE("files that commands write beside the one that is named are kept likewise") {
  const WorkFolder folder;
  folder.write("bd_blade.dat", "my own blade");
  check_refused(
      {"export", "beamdyn", shipped("spatial_wu_haug"), "--out", "bd.dat"},
      "bd_blade.dat: cannot be written: there is a file that is not a file of spoke export",
      folder);
  folder.write("w.bts.tmp", "my own file");  // where the wind would lie until it is whole
  check_refused({"wind", shipped("nrel_5mw_in_wind"), "--set", "wind.turbulence.duration=20",
                 "--out", "w.bts"},
                "w.bts.tmp: cannot be written: there is a file that is not a wind", folder);
  CHECK(file_text(folder.path() / "w.bts.tmp") == "my own file");
  const WorkFolder blades;
  for (const auto& entry : fs::directory_iterator(kForeign))
    fs::copy_file(entry.path(), blades.path() / entry.path().filename());
  fs::create_directory(blades.path() / "t_airfoils");
  const fs::path polar = blades.path() / "t_airfoils" / "small_AeroDyn_polar_thin.txt";
  blades.write("t_airfoils/small_AeroDyn_polar_thin.txt", "my own polar");
  check_refused({"import", "small_BeamDyn.dat", "small_ElastoDyn.dat", "small_AeroDyn.dat", "--out",
                 "t.toml"},
                "small_AeroDyn_polar_thin.txt: cannot be written: there is a file", blades);
  CHECK(file_text(polar) == "my own polar");
}

TEST_CASE("a file that the scenario names is not written over, even by --force") {
  const WorkFolder folder;
  fs::create_directory(folder.path() / "o");
  // A table of wind whose beginning is that of sensors.csv, which begins with t.
  const std::string table = "0 12\n100 12\n";
  folder.write("o/sensors.csv", table);
  const Words run = {
      "run",    shipped("nrel_5mw_in_wind"),
      "--set",  "wind={ file = \"" + (folder.path() / "o/sensors.csv").string() + "\" }",
      "--out",  "o",
      "--force"};
  check_refused(run, "o/sensors.csv: cannot be written: the command reads this file", folder);
  CHECK(file_text(folder.path() / "o/sensors.csv") == table);
  const fs::path mesh = fs::path(shipped("solid_bracket")).parent_path() / "meshes/bracket.msh";
  folder.write("s.toml", file_text(shipped("solid_bracket")));
  fs::create_directory(folder.path() / "meshes");
  folder.write("meshes/bracket.msh", file_text(mesh));
  check_refused({"check", "s.toml", "--html", "meshes/bracket.msh", "--force"},
                "meshes/bracket.msh: cannot be written: the command reads this file", folder);
  CHECK(file_text(folder.path() / "meshes/bracket.msh") == file_text(mesh));
}

TEST_CASE("results take the place of earlier results, and of no other files") {
  const std::string rotor = shipped("spatial_wu_haug");
  const std::vector<std::pair<Words, std::string>> commands = {
      {{"run", rotor, "--set", "integration.duration=0.02", "--vtk", "--checkpoint-every", "1"},
       "sensors.csv"},
      {{"static", rotor}, "section_forces.csv"},
      {{"modes", rotor, "--count", "2"}, "modes.csv"},
      {{"campbell", rotor, "--speeds", "0:1:1", "--count", "2"}, "campbell.csv"},
      {{"critical", rotor, "--of", "speed", "--from", "0", "--to", "1", "--points", "2"},
       "critical.csv"},
      {{"linearize", rotor}, "A.mtx"},
      {{"trace", rotor, "--steps", "2"}, "trace.json"}};
  for (const auto& each : commands) {
    const Words& command = each.first;
    const std::string& file = each.second;
    CAPTURE(command.front());
    const WorkFolder folder;
    const Words words = with(command, {"--out", "o"});
    REQUIRE(run_spoke(words, folder).status == 0);
    const Ended again = run_spoke(words, folder);
    CAPTURE(again.err);
    CHECK(again.status == 0);
    folder.write("o/" + file, "my own file");
    check_refused(words, "o/" + file + ": cannot be written: there is a file that is not", folder);
    CHECK(file_text(folder.path() / "o" / file) == "my own file");
    CHECK(run_spoke(with(words, {"--force"}), folder).status == 0);
    CHECK(file_text(folder.path() / "o" / file) != "my own file");
  }
}

TEST_CASE("a picture or a series of the user's is not removed as stale") {
  const WorkFolder folder;
  const Words run = {"run",     shipped("wu_haug_rotor"),
                     "--set",   "integration.duration=0.02",
                     "--out",   "o",
                     "--trace", "o"};
  fs::create_directories(folder.path() / "o" / "vtk");
  folder.write("o/vtk/blades_000001.vtp", "mine");
  check_refused(run, "o/vtk/blades_000001.vtp: cannot be written: ", folder);
  fs::remove_all(folder.path() / "o" / "vtk");
  folder.write("o/graph.svg", "mine");
  check_refused(run, "o/graph.svg: cannot be written: ", folder);
  CHECK(file_text(folder.path() / "o" / "graph.svg") == "mine");
}
