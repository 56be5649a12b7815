// Says what this installation has, and which optional parts are missing.

#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>

#include "engine/support/machine.h"
#include "engine/support/source_commit.h"
#include "models/solid/cache.h"
#include "models/support/instructions.h"
#include "program/cli/commands.h"
#include "program/cli/report.h"
#include "program/viewer/viewer_page.h"

namespace spoke::cli {
namespace {

namespace fs = std::filesystem;

/// A part that this program was built with, or without.
struct BuiltPart {
  const char* name;
  bool is_there;
  const char* what_for;
  const char* package;  ///< of Debian 12, to be there before the build
};

constexpr BuiltPart kBuiltParts[] = {
    {"OpenMP", SPOKE_WITH_OPENMP != 0, "executors openmp_... to compare with", "libomp-dev"},
    {"YAML", SPOKE_WITH_YAML != 0, "spoke import of WindIO", "libyaml-cpp-dev"},
    {"libzip", SPOKE_WITH_ZIP != 0, "spoke fmu", "libzip-dev"},
    {"HDF5", SPOKE_WITH_HDF5 != 0, "study.h5 of spoke study", "libhdf5-dev"},
    {"MPI", SPOKE_WITH_MPI != 0, "runs and studies under mpirun", "libopenmpi-dev openmpi-bin"}};

/// A program of others.
struct OtherProgram {
  const char* name;
  const char* what_for;
  const char* package;
};

constexpr OtherProgram kOtherPrograms[] = {
    {"dot", "pictures of graph.dot, which spoke trace writes", "graphviz"},
    {"mpirun", "one model or a study on several machines", "openmpi-bin"},
    {"python3", "the Python module", "python3"}};

/// Returns where a program is found by its name; none: nowhere.
std::optional<fs::path> find_program(const std::string& name) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (const fs::path file = fs::path(folder) / name; access(file.c_str(), X_OK) == 0) return file;
  return std::nullopt;
}

void print_part(std::string_view label, const char* name, bool is_there, const char* what_for,
                const char* package) {
  print_line(label,
             is_there ? fmt::format("{}: {}", name, what_for)
                      : fmt::format("{} is missing: no {} (Debian: {})", name, what_for, package));
}

void print_built() {
  constexpr const char* kViewer = "the page of traces";
  bool is_first = true;
  for (const BuiltPart& part : kBuiltParts) {
    print_part(is_first ? "built with" : "", part.name, part.is_there, part.what_for, part.package);
    is_first = false;
  }
  print_part("", "esbuild", !viewer_page().empty(), kViewer, "esbuild");
}

/// Prints which of the programs that lie beside this one are there.
void print_commands() {
  std::error_code error;
  const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
  std::string there, missing;
  for (const std::string name :
       {"study", "verify", "import", "export", "fmu", "compare", "reproduce"}) {
    const bool is_there = access((folder / ("spoke-" + name)).c_str(), X_OK) == 0;
    std::string& list = is_there ? there : missing;
    list += (list.empty() ? "" : ", ") + name;
  }
  print_line("commands", there.empty() ? "none beside run and the analyses" : there);
  if (!missing.empty())
    print_line("",
               "not built yet: " + missing + " (./spoke builds one when it is first asked for)");
}

void print_folders() {
  const std::optional<fs::path> cache = solid::find_cache_folder();
  print_line("cache", cache ? cache->string() + ", of reduced solids"
                            : "none: solids are reduced anew in each run");
  std::error_code error;
  const std::string here = fs::current_path(error).string();
  print_line("results", access(".", W_OK) == 0
                            ? here + "/results"
                            : here + " cannot be written: give a folder with --out");
}

}  // namespace

int examine(const Arguments&) {
  const Machine machine = this_machine();
  const std::string commit(source_commit());
  print_line("spoke", SPOKE_VERSION + (commit.empty() ? "" : ", commit " + commit));
  print_line("built by", machine.compiler);
  print_line("machine", fmt::format("{}, {} processors, {:.1f} GB, {}", machine.cpu, machine.cores,
                                    static_cast<double>(machine.memory) * 1e-9, machine.os));
  print_line("arithmetic", instructions_in_use());
  print_built();
  print_commands();
  bool is_first = true;
  for (const OtherProgram& other : kOtherPrograms) {
    print_part(is_first ? "programs" : "", other.name, find_program(other.name).has_value(),
               other.what_for, other.package);
    is_first = false;
  }
  print_folders();
  return 0;
}

}  // namespace spoke::cli
