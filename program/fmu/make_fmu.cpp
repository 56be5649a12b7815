// Chooses what importers see, and lays the files of the archive where the standard wants them.

#include "program/fmu/make_fmu.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>
#include <utility>

#include "models/error.h"
#include "models/support/hash_bytes.h"
#include "models/support/nearest_name.h"
#include "models/text_file.h"
#include "program/fmu/archive.h"
#include "program/fmu/contents.h"
#include "program/fmu/licences.h"
#include "program/fmu/resources.h"

namespace spoke::fmu {
namespace {

namespace fs = std::filesystem;

/// Whether a column is one of those that a name stands for: itself, or all of a sensor.
bool is_of(std::string_view column, std::string_view name) {
  return column == name || (column.starts_with(name) && column[name.size()] == '.');
}

std::vector<std::string> choose_outputs(const Simulation& simulation,
                                        const std::vector<std::string>& names) {
  const std::vector<std::string>& columns = simulation.sensor_names();
  if (names.empty()) return columns;
  std::vector<std::string> chosen;
  for (const std::string& name : names) {
    bool is_known = false;
    for (const std::string& column : columns) {
      if (!is_of(column, name)) continue;
      is_known = true;
      if (std::find(chosen.begin(), chosen.end(), column) == chosen.end()) chosen.push_back(column);
    }
    if (is_known) continue;
    const std::vector<std::string_view> known(columns.begin(), columns.end());
    const auto nearest = nearest_name(name, known);
    throw InputError("the output \"" + name + "\" is no sensor, " +
                     (nearest ? "did you mean \"" + std::string(*nearest) + "\"?"
                              : "expected a column of sensors.csv or the words before its last"));
  }
  return chosen;
}

Inputs choose(const Simulation& simulation, const std::vector<std::string>& names) {
  if (names == std::vector<std::string>{"none"}) return {};
  return choose_inputs(simulation, names);
}

/// Returns the time between rows of sensors.csv as a multiple of steps.
double find_interval(const Simulation& simulation) {
  const double step = simulation.step_size();
  const double count = std::round(simulation.scenario().output.interval / step);
  return step * std::max(1.0, count);
}

/// Returns a text that differs for FMUs that differ in model, inputs or outputs.
std::string make_token(const Contents& contents, const PackedScenario& scenario) {
  std::string all = SPOKE_VERSION + write_contents(contents);
  for (const PackedFile& file : scenario.files) all += file.name + '\n' + file.content;
  const std::uint64_t one = hash_bytes(all.data(), all.size());
  all += '.';
  return fmt::format("spoke-{:016x}{:016x}", one, hash_bytes(all.data(), all.size(), one));
}

Contents make_contents(const PackedScenario& scenario, const Simulation& simulation,
                       const Fmu& made) {
  if (const auto& space = simulation.scenario().space; space && space->outer_control)
    throw InputError('[' + std::string(space->outer_control->table()) +
                     "] is a controller from outside, of which an FMU has inputs in its place: "
                     "expected none");
  Contents contents;
  contents.scenario = scenario.name;
  contents.overrides = scenario.overrides;
  contents.step = simulation.step_size();
  for (const auto& input : made.inputs) contents.inputs.push_back(input->name);
  contents.outputs = made.outputs;
  contents.token = make_token(contents, scenario);
  return contents;
}

ModelDescription describe(const FmuRequest& request, const Simulation& simulation,
                          const Contents& contents, const Fmu& made) {
  const Scenario& scenario = simulation.scenario();
  ModelDescription model;
  model.name = scenario.name.empty() ? request.name : scenario.name;
  model.identifier = make_identifier(request.name);
  model.token = contents.token;
  model.description = scenario.title;
  model.step = simulation.step_size();
  model.duration = scenario.integration.duration;
  model.interval = find_interval(simulation);
  for (const auto& input : made.inputs)
    model.inputs.push_back({input->name, input->unit, input->description, input->start});
  for (const std::string& output : made.outputs)
    model.outputs.push_back(
        {output, simulation.sensor_units()[simulation.sensor_index(output)], "", 0.0});
  return model;
}

std::string read_library(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream || bytes.empty())
    throw InputError(file.string() + ": cannot be read, expected the library of FMUs");
  return bytes;
}

}  // namespace

std::string binaries_folder(FmiVersion version) {
  const std::string_view machine = SPOKE_FMU_MACHINE;
  if (version == FmiVersion::two && machine == "x86_64") return "binaries/linux64";
  return "binaries/" SPOKE_FMU_MACHINE "-linux";
}

fs::path find_library() {
  std::error_code none;
  const fs::path folder = fs::read_symlink("/proc/self/exe", none).parent_path();
  const fs::path beside = folder / SPOKE_FMU_LIBRARY;
  const fs::path installed = (folder / SPOKE_FMU_INSTALLED / SPOKE_FMU_LIBRARY).lexically_normal();
  for (const fs::path& file : {beside, installed})
    if (fs::is_regular_file(file, none)) return file;
  throw InputError("the library of FMUs is not there, expected " + beside.string() + " or " +
                   installed.string() + " (it is built by the target spoke_fmu_library)");
}

Fmu make_fmu(const FmuRequest& request, const Simulation& simulation) {
  Fmu made;
  made.inputs = choose(simulation, request.inputs);
  made.outputs = choose_outputs(simulation, request.outputs);
  PackedScenario scenario = pack_scenario(
      request.scenario, request.text.empty() ? read_text(request.scenario) : request.text,
      request.overrides);
  const Contents contents = make_contents(scenario, simulation, made);
  const ModelDescription model = describe(request, simulation, contents, made);
  std::vector<PackedFile> files{
      {"modelDescription.xml", write_model_description(model, request.version)},
      {binaries_folder(request.version) + '/' + model.identifier + ".so",
       read_library(request.binary)},
      {"documentation/licenses/license.txt", std::string(licence_text())},
      {"documentation/licenses/third_party.txt", std::string(third_party_licences())},
      {std::string("resources/") + kContentsFile, write_contents(contents)}};
  for (PackedFile& file : scenario.files)
    files.push_back({"resources/" + file.name, std::move(file.content)});
  made.bytes = make_archive(files);
  for (const PackedFile& file : files) made.files.push_back(file.name);
  return made;
}

}  // namespace spoke::fmu
