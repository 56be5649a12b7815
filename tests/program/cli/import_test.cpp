// spoke import and spoke export on the command line, and the examples of docs/files.md.

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "tests/contains.h"
#include "tests/program/cli/examples.h"
#include "tests/program/cli/program.h"
#include "tests/program/cli/refusal.h"

using spoke::test::contains;
namespace fs = std::filesystem;

namespace {

const fs::path kFiles = SPOKE_FOREIGN_FILES;

/// A folder with the small files of the tests.
class BladeFolder {
 public:
  BladeFolder() {
    for (const auto& entry : fs::directory_iterator(kFiles))
      fs::copy_file(entry.path(), work.path() / entry.path().filename());
  }
  WorkFolder work;
};

/// Whether this build reads YAML.
#ifdef SPOKE_HAS_YAML
constexpr bool kHasYaml = true;
#else
constexpr bool kHasYaml = false;
#endif

/// Checks that the tables of a map, read as ROSCO's controller reads them, by the number of lines,
/// have the coefficients of performance.csv.
void check_tables(const fs::path& results) {
  const std::vector<std::string> lines = lines_of(file_text(results / "Cp_Ct_Cq.txt"));
  const std::vector<std::string> points = lines_of(file_text(results / "performance.csv"));
  const auto numbers_in = [](const std::string& line) {
    std::istringstream stream(line);
    return std::vector<double>(std::istream_iterator<double>(stream), {});
  };
  REQUIRE(lines.size() == 12 + 3 * 3 + 2 * 4);
  CHECK(numbers_in(lines[4]) == std::vector<double>{0.0, 2.0});
  CHECK(numbers_in(lines[6]) == std::vector<double>{6.0, 7.0, 8.0});
  CHECK(numbers_in(lines[8]) == std::vector<double>{8.0});
  for (std::size_t k = 0; k < 6; ++k) {
    std::vector<double> cells;
    std::istringstream stream(points.at(k + 1));
    for (std::string cell; cells.size() < 9 && std::getline(stream, cell, ',');)
      cells.push_back(std::stod(cell));
    const auto in_table = [&](std::size_t table) {
      return numbers_in(lines.at(12 + 7 * table + k / 2)).at(k % 2);
    };
    CHECK(in_table(0) == doctest::Approx(cells.at(7)).epsilon(1e-6));
    CHECK(in_table(1) == doctest::Approx(cells.at(8)).epsilon(1e-6));
    CHECK(in_table(2) == doctest::Approx(cells.at(7) / cells.at(2)).epsilon(1e-6));
  }
}

}  // namespace

TEST_CASE("import writes a scenario that the other commands take") {
  const BladeFolder folder;
  const Ended ended =
      run_spoke({"import", "small_BeamDyn.dat", "--out", "blade.toml"}, folder.work);
  CHECK(ended.status == 0);
  CHECK(ended.err.empty());
  for (const char* part : {"A blade of 20 m", "BeamDyn, primary file", "BeamDyn, blade file",
                           "1, each of 20 m, 12 stations", "left out", "blade.toml"}) {
    CAPTURE(part);
    CHECK(contains(ended.out, part));
  }
  CHECK(run_spoke({"check", "blade.toml"}, folder.work).status == 0);
  CHECK(run_spoke({"run", "blade.toml", "--set", "integration.duration=0.05", "--out", "r",
                   "--no-report"},
                  folder.work)
            .status == 0);
}

TEST_CASE("a turbine and a rotor are imported whole") {
  const BladeFolder folder;
  CHECK(run_spoke({"import", "small_ElastoDyn.dat", "--out", "t.toml"}, folder.work).status == 0);
  CHECK(run_spoke(
            {"run", "t.toml", "--set", "integration.duration=0.05", "--out", "r", "--no-report"},
            folder.work)
            .status == 0);
  CHECK(run_spoke({"import", "small_ElastoDyn_blade.dat", "small_ElastoDyn_tower.dat", "--length",
                   "18.5", "--height", "24", "--out", "b.toml"},
                  folder.work)
            .status == 0);
  CHECK(run_spoke({"check", "b.toml"}, folder.work).status == 0);
}

TEST_CASE("an import takes the place of an earlier one, with all its tables") {
  const BladeFolder folder;
  for (int i = 0; i < 2; ++i) {
    const Ended ended = run_spoke({"import", "small_turbine.fst", "--out", "t.toml"}, folder.work);
    CHECK(ended.err.empty());
    CHECK(ended.status == 0);
  }
  CHECK(std::filesystem::exists(folder.work.path() / "t_wind.txt"));
}

TEST_CASE("aerodynamics come with a folder of tables, all of them or none") {
  const BladeFolder folder;
  const std::vector<std::string> import = {
      "import", "small_BeamDyn.dat", "small_ElastoDyn.dat", "small_AeroDyn.dat", "--out", "t.toml"};
  const fs::path tables = folder.work.path() / "t_airfoils";
  fs::rename(folder.work.path() / "small_AeroDyn_polar_thin.dat", folder.work.path() / "away");
  check_refused(import, "small_AeroDyn.dat:27: names a file that cannot be read", folder.work);
  CHECK_FALSE(fs::exists(tables));
  fs::rename(folder.work.path() / "away", folder.work.path() / "small_AeroDyn_polar_thin.dat");
  fs::create_directory(folder.work.path() / "t.toml.tmp");  // in the way of the scenario
  check_refused(import, "t.toml", folder.work);
  CHECK_FALSE(fs::exists(tables));
  fs::remove(folder.work.path() / "t.toml.tmp");
  const Ended ended = run_spoke(import, folder.work);
  CHECK(ended.status == 0);
  CHECK(contains(ended.out, "8 stations, 3 aerofoils"));
  CHECK(contains(ended.out, "t.toml, 3 tables in t_airfoils"));
  CHECK(fs::exists(tables / "small_AeroDyn_polar_thin.txt"));
  CHECK(std::distance(fs::directory_iterator(tables), fs::directory_iterator()) == 3);
  CHECK(run_spoke({"run", "t.toml", "--set", "wind={velocity=[8,0,0]}", "--set",
                   "integration.duration=0.05", "--out", "r", "--no-report"},
                  folder.work)
            .status == 0);
  CHECK(run_spoke({"performance", "t.toml", "--wind", "8", "--pitch", "0:2:2", "--tip-speed-ratio",
                   "6:8:1", "--rigid", "--out", "p"},
                  folder.work)
            .status == 0);
  check_tables(folder.work.path() / "p");
  // A step that is all of the way but for the rounding of decimals.
  CHECK(run_spoke({"performance", "t.toml", "--wind", "8", "--pitch", "0", "--tip-speed-ratio",
                   "7.7:12.7:5", "--rigid", "--out", "p"},
                  folder.work)
            .status == 0);
}

TEST_CASE("the main file of OpenFAST makes a turbine that runs, with nothing added by hand") {
  const BladeFolder folder;
  const std::vector<std::string> import = {"import", "small_turbine.fst", "--out", "t.toml"};
  fs::rename(folder.work.path() / "small_turbine_wind.txt", folder.work.path() / "away");
  check_refused(import, "small_turbine_InflowWind.dat:14: names a file that cannot be read",
                folder.work);
  CHECK_FALSE(fs::exists(folder.work.path() / "t.toml"));
  CHECK_FALSE(fs::exists(folder.work.path() / "t_airfoils"));
  fs::rename(folder.work.path() / "away", folder.work.path() / "small_turbine_wind.txt");
  const Ended ended = run_spoke(import, folder.work);
  CHECK(ended.status == 0);
  CHECK(contains(ended.out, "t.toml, 3 tables in t_airfoils, t_wind.txt"));
  CHECK(run_spoke({"check", "t.toml"}, folder.work).status == 0);
  CHECK(run_spoke(
            {"run", "t.toml", "--set", "integration.duration=0.05", "--out", "r", "--no-report"},
            folder.work)
            .status == 0);
  CHECK(run_spoke({"performance", "t.toml", "--wind", "8", "--out", "p"}, folder.work).status == 0);
}

TEST_CASE("an imported turbine runs with the library that ServoDyn names") {
  const BladeFolder folder;
  const fs::path servo = folder.work.path() / "small_turbine_ServoDyn.dat";
  std::string text = file_text(servo);
  for (const auto& [from, to] :
       {std::pair<std::string, std::string>{"1             VSContrl", "5 VSContrl"},
        {"0             PCMode", "5 PCMode"},
        {"0             YCMode", "5 YCMode"},
        {"\"small_turbine.so\"", '"' + std::string(SPOKE_TEST_DISCON) + '"'}})
    text.replace(text.find(from), from.size(), to);
  std::ofstream(servo) << text;
  const auto run = [&] {
    return run_spoke(
        {"run", "t.toml", "--set", "integration.duration=0.05", "--out", "r", "--no-report"},
        folder.work);
  };
  const std::vector<std::string> import = {"import", "small_turbine.fst", "--out", "t.toml",
                                           "--force"};
  const Ended without = run_spoke(import, folder.work);  // there is no input of the library
  CHECK(without.status == 0);
  CHECK(contains(without.out, "names small_turbine.IN, which is not there: the drive holds"));
  CHECK(run().status == 0);
  std::ofstream(folder.work.path() / "small_turbine.IN") << "square 1.5\n";
  const Ended ended = run_spoke(import, folder.work);
  CHECK(ended.status == 0);
  CHECK_FALSE(contains(ended.out, "which is not there"));
  CHECK(contains(run_spoke({"check", "t.toml"}, folder.work).out, "joint pitch"));
  CHECK(run().status == 0);
}

TEST_CASE("a file in the place of the folder of tables is refused") {
  const BladeFolder folder;
  std::ofstream(folder.work.path() / "t_airfoils") << "mine";
  check_refused({"import", "small_BeamDyn.dat", "small_AeroDyn.dat", "--out", "t.toml"},
                "t_airfoils: cannot be made, expected a folder for the tables", folder.work);
  CHECK(file_text(folder.work.path() / "t_airfoils") == "mine");
  CHECK_FALSE(fs::exists(folder.work.path() / "t.toml"));
}

TEST_CASE("export writes two files that import takes") {
  const BladeFolder folder;
  REQUIRE(run_spoke({"import", "small_BeamDyn.dat", "--out", "a.toml"}, folder.work).status == 0);
  const Ended ended = run_spoke({"export", "beamdyn", "a.toml", "--out", "sub/x.dat"}, folder.work);
  CHECK(ended.status == 2);  // there is no such folder
  CHECK(run_spoke({"export", "beamdyn", "a.toml", "--out", "x.dat"}, folder.work).status == 0);
  CHECK(fs::exists(folder.work.path() / "x_blade.dat"));
  CHECK(run_spoke({"import", "x.dat", "--out", "b.toml"}, folder.work).status == 0);
}

TEST_CASE("ElastoDyn's and AeroDyn's files of a scenario are written, all or none, and taken") {
  const BladeFolder folder;
  const std::string turbine = shipped("nrel_5mw_in_wind");
  const Ended beam = run_spoke({"export", "elastodyn", turbine, "--out", "nrel.dat"}, folder.work);
  CHECK(beam.status == 0);
  CHECK(contains(beam.out, "nrel.dat, nrel_tower.dat"));
  fs::create_directory(folder.work.path() / "air_naca64.dat");  // in the way
  CHECK(run_spoke({"export", "aerodyn", turbine, "--out", "air.dat"}, folder.work).status == 2);
  CHECK_FALSE(fs::exists(folder.work.path() / "air.dat"));
  CHECK_FALSE(fs::exists(folder.work.path() / "air_du40.dat"));
  fs::remove(folder.work.path() / "air_naca64.dat");
  const Ended air = run_spoke({"export", "aerodyn", turbine, "--out", "air.dat"}, folder.work);
  CHECK(air.status == 0);
  CHECK(contains(air.out, "air.dat, air_blade.dat, air_cylinder1.dat"));
  CHECK(run_spoke({"import", "nrel.dat", "air.dat", "--length", "61.5", "--out", "n.toml"},
                  folder.work)
            .status == 0);
  CHECK(run_spoke({"check", "n.toml"}, folder.work).status == 0);
}

TEST_CASE("what cannot be imported or exported is refused before anything is written") {
  const BladeFolder folder;
  const auto refused = [&](const std::vector<std::string>& words, const std::string& message) {
    check_refused(words, message, folder.work);
  };
  refused({"import", "none.dat", "--out", "o.toml"},
          "none.dat: no such file, expected a file of OpenFAST or of one of its modules");
  refused({"import", "small_BeamDyn_blade.dat", "--out", "o.toml"},
          "small_BeamDyn_blade.dat:1: has no key points, expected BeamDyn's primary file besides");
  refused({"import", "small_BeamDyn.dat"}, "--out is required");
  refused({"import", "--out", "o.toml"}, "FILE is required");
  refused({"import", "small_ElastoDyn_blade.dat", "--length", "0", "--out", "o.toml"},
          "--length: expected a number above 0 [m]");
  refused({"import", "small_ElastoDyn_blade.dat", "--length", "long", "--out", "o.toml"},
          "--length: expected a number above 0 [m]");
  refused({"import", "small_BeamDyn.dat", "small_BeamDyn.dat", "--out", "o.toml"},
          "is a second file of the kind \"BeamDyn, primary file\"");
  refused({"import", "small_BeamDyn.dat", "--out", "none/o.toml"}, "none/o.toml");
  refused({"export", "hawc2", "x.toml", "--out", "o.dat"}, "FORMAT");
  refused({"export", "beamdyn", shipped("wu_haug_rotor"), "--out", "o.dat"},
          "has no blade in space, expected one");
  refused({"export", "beamdyn", shipped("nrel_5mw_rotor"), "--blade", "4", "--out", "o.dat"},
          "--blade 4: expected a number from 1 to 3");
}

TEST_CASE("the examples of docs/files.md show what the program prints") {
  const WorkFolder folder;
  fs::create_directory_symlink(fs::path(SPOKE_MODELS_DIR).parent_path() / "tests",
                               folder.path() / "tests");
  fs::create_directory_symlink(SPOKE_MODELS_DIR, folder.path() / "models");
  const auto examples =
      examples_of(file_text(fs::path(SPOKE_MODELS_DIR).parent_path() / "docs" / "files.md"));
  CHECK(examples.size() >= 4);
  for (const Example& example : examples) {
    if (!kHasYaml && contains(example.commands.front(), ".yaml")) continue;
    std::string printed;
    for (const std::string& command : example.commands) {
      CAPTURE(command);
      const Ended ended = run_spoke(words_of(command), folder);
      CHECK(ended.status == 0);
      CHECK(ended.err.empty());
      printed += ended.out;
      for (const std::string& word : words_of(command))  // a file that was written is shown, too
        if (word.ends_with(".toml") && fs::exists(folder.path() / word))
          printed += file_text(folder.path() / word);
    }
    for (const std::string& line : example.shown) {
      CAPTURE(line);
      CHECK(contains(printed, line));
    }
  }
}
