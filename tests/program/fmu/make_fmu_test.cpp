// What an FMU is made of: names, files, licences, and bytes that do not change by themselves.

#include "program/fmu/make_fmu.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "engine/simulation.h"
#include "models/error.h"
#include "program/fmu/contents.h"
#include "program/fmu/model_description.h"
#include "program/fmu/resources.h"
#include "tests/contains.h"
#include "tests/file_text.h"
#include "tests/message_of.h"
#include "tests/program/fmu/importer.h"
#include "tests/program/fmu/unpacked_fmu.h"
#include "tests/temporary_folder.h"

using namespace spoke;
using namespace spoke::test;
namespace fs = std::filesystem;

namespace {

fmu::Fmu make(const fs::path& scenario, const std::vector<std::string>& inputs = {},
              const std::vector<std::string>& outputs = {}) {
  const Simulation simulation(read_scenario(scenario.string()));
  return fmu::make_fmu({scenario.string(), {}, "my rotor", SPOKE_FMU_LIBRARY_FILE, inputs, outputs},
                       simulation);
}

}  // namespace

TEST_CASE("an FMU holds description, library, licences and resources, and is the same each time") {
  const TemporaryFolder folder;
  const fs::path file = folder / "pitched.toml";
  std::ofstream(file) << kPitchedRotor;
  const fmu::Fmu made = make(file);
  CHECK(made.files ==
        std::vector<std::string>{
            "modelDescription.xml", fmu::binaries_folder(fmu::FmiVersion::three) + "/my_rotor.so",
            "documentation/licenses/license.txt", "documentation/licenses/third_party.txt",
            "resources/spoke.toml", "resources/pitched.toml"});
  CHECK(make(file).bytes == made.bytes);
  unpack(made.bytes, folder.path() / "fmu");
  CHECK(file_text(folder.path() / "fmu/resources/pitched.toml") == kPitchedRotor);
  CHECK(file_text(folder.path() / "fmu/documentation/licenses/license.txt") ==
        file_text(fs::path(SPOKE_MODELS_DIR).parent_path() / "LICENSE"));
  CHECK(file_text(folder.path() / "fmu" / fmu::binaries_folder(fmu::FmiVersion::three) /
                  "my_rotor.so") == file_text(SPOKE_FMU_LIBRARY_FILE));
  // Another model, other inputs or outputs: another token.
  const auto token = [&](const fmu::Fmu& other) {
    fs::remove_all(folder.path() / "other");
    unpack(other.bytes, folder.path() / "other");
    return LoadedFmu(folder.path() / "other").token();
  };
  const std::string first = token(made);
  CHECK(token(make(file, {"drive.torque"})) != first);
  CHECK(token(make(file, {}, {"hub.speed"})) != first);
  std::ofstream(file, std::ios::app) << "# more\n";
  CHECK(token(make(file)) != first);
}

TEST_CASE("outputs are columns, or all columns of a sensor, each once and in order") {
  const TemporaryFolder folder;
  const fs::path file = folder / "pitched.toml";
  std::ofstream(file) << kPitchedRotor;
  using Words = std::vector<std::string>;
  const Simulation simulation(read_scenario(file.string()));
  CHECK(make(file).outputs == simulation.sensor_names());
  CHECK(make(file, {}, {"hub.speed", "blade2.tip", "blade2.tip.x"}).outputs ==
        Words{"hub.speed", "blade2.tip.x", "blade2.tip.y", "blade2.tip.z"});
  CHECK(make(file, {"none"}, {"hub.speed"}).inputs.empty());
  CHECK(contains(message_of([&] { make(file, {}, {"hub.sped"}); }), "hub.speed"));
  CHECK(contains(message_of([&] { make(file, {}, {"blade1.ti"}); }), "is no sensor"));
  CHECK(contains(message_of([&] { make(file, {}, {""}); }), "is no sensor"));
  CHECK(contains(message_of([&] { make(file, {"load.storm"}); }), "load.gust"));
  const Simulation other(read_scenario(file.string()));
  CHECK(contains(message_of([&] {
                   fmu::make_fmu({file.string(), {}, "x", folder / "none.so", {}, {}}, other);
                 }),
                 "none.so: cannot be read"));
}

TEST_CASE("files of meshes and matrices go with the scenario, from wherever they are") {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "a/b");
  const fs::path mesh = fs::path(SPOKE_MODELS_DIR) / "meshes/bracket.msh";
  fs::copy_file(mesh, folder.path() / "a/part.msh");
  std::string text = file_text(fs::path(SPOKE_MODELS_DIR) / "solid_bracket.toml");
  text.replace(text.find("\"meshes/bracket.msh\""), 20, "\"../part.msh\"");
  const fs::path file = folder.path() / "a/b/bracket.toml";
  std::ofstream(file) << text;
  const fmu::PackedScenario packed =
      fmu::pack_scenario(file.string(), file_text(file), {"integration.step=1e-3"});
  REQUIRE(packed.files.size() == 2);
  CHECK(packed.files[1].name == "files/1_part.msh");
  CHECK(packed.files[1].content == file_text(mesh));
  CHECK(packed.overrides ==
        Overrides{"integration.step=1e-3", "subsystem.1.body.1.mesh=\"files/1_part.msh\""});
  // One file that is named twice is there once; matrices have several.
  for (const char* name : {"m.mtx", "k.mtx", "nodes.csv", "g.mtx"})
    std::ofstream(folder.path() / name) << name;
  std::ofstream(folder.path() / "matrices.toml") << R"(
[[subsystem]]
body = [
  { mass = "m.mtx", stiffness = "k.mtx", nodes = "nodes.csv", geometric_stiffness = { own = ["g.mtx", "g.mtx"], translation = ["g.mtx"] } },
  { mass = 3.0, mesh = "m.mtx", interface = [{ name = "a", nodes = "set" }] },
]
)";
  const fmu::PackedScenario matrices = fmu::pack_scenario(
      (folder.path() / "matrices.toml").string(), file_text(folder.path() / "matrices.toml"), {});
  CHECK(matrices.files.size() == 5);
  CHECK(matrices.overrides.size() == 7);
  CHECK(std::find(matrices.overrides.begin(), matrices.overrides.end(),
                  "subsystem.1.body.1.geometric_stiffness.own.2=\"files/4_g.mtx\"") !=
        matrices.overrides.end());
}

TEST_CASE("an FMU of a solid has the mesh inside, and the bits of the simulation") {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "models/meshes");
  for (const char* name : {"solid_bracket.toml", "meshes/bracket.msh"})
    fs::copy_file(fs::path(SPOKE_MODELS_DIR) / name, folder.path() / "models" / name);
  const fs::path file = folder.path() / "models/solid_bracket.toml";
  Simulation simulation(read_scenario(file.string()));
  unpack(make(file).bytes, folder.path() / "fmu");
  fs::remove_all(folder.path() / "models");
  const LoadedFmu fmu(folder.path() / "fmu");
  FmuInstance instance(fmu);
  CAPTURE(instance.last());
  REQUIRE(instance.handle());
  CHECK(instance.initialize() == kOk);
  CHECK(instance.step(0.0, 0.01) == kOk);
  simulation.run_until(0.01);
  const auto values = simulation.sensor_values();
  CHECK(instance.outputs() == std::vector<double>(values.begin(), values.end()));
}

TEST_CASE("what the library reads is what was written, and all else is refused") {
  const fmu::Contents contents{"tok\"en", "a\\b \xc3\xa9.toml", {"title=\"x\ny\"", "a.b=1"},
                               0.1 + 0.2, {"drive.torque"},     {}};
  const std::string text = fmu::write_contents(contents);
  const fmu::Contents read = fmu::read_contents(text, "spoke.toml");
  CHECK(read.token == contents.token);
  CHECK(read.scenario == contents.scenario);
  CHECK(read.overrides == contents.overrides);
  CHECK(read.step == contents.step);
  CHECK(read.inputs == contents.inputs);
  CHECK(read.outputs.empty());
  for (const char* key : {"format", "token", "scenario", "set", "step", "inputs", "outputs"}) {
    CAPTURE(key);
    std::string other = text;
    other.replace(other.find(std::string("\n") + key), 2, "\nx");
    CHECK(contains(message_of([&] { fmu::read_contents(other, "spoke.toml"); }), key));
  }
}

TEST_CASE("names of shared objects are identifiers of C") {
  CHECK(fmu::make_identifier("rotor") == "rotor");
  CHECK(fmu::make_identifier("my rotor-2.1") == "my_rotor_2_1");
  CHECK(fmu::make_identifier("5mw") == "_5mw");
}
