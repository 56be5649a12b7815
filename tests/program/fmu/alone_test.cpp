// The FMU in a process that has nothing of Spoke, and an empty environment.

#include <doctest/doctest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "engine/simulation.h"
#include "tests/contains.h"
#include "tests/program/fmu/importer.h"
#include "tests/program/fmu/unpacked_fmu.h"

using namespace spoke;
using namespace spoke::test;
namespace fs = std::filesystem;

namespace {

/// Returns the lines that a command prints.
std::vector<std::string> lines_of(const std::string& command) {
  std::string text;
  FILE* pipe = popen(command.c_str(), "r");
  REQUIRE(pipe);
  char part[4096];
  while (const std::size_t count = std::fread(part, 1, sizeof part, pipe)) text.append(part, count);
  CHECK(pclose(pipe) == 0);
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace

TEST_CASE("an FMU runs where there is no Spoke, with the C library alone, and has the same bits") {
  const UnpackedFmu unpacked(kPitchedRotor);
  const LoadedFmu fmu(unpacked.folder());
  Simulation simulation(parse_scenario(kPitchedRotor, "rotor.toml"));
  simulation.run_until(0.2);
  const auto expected = simulation.sensor_values();
  std::ostringstream command;
  command << "cd / && env -i " << SPOKE_ALONE << ' ' << fmu.resources().string() << ' '
          << fmu.token() << ' '
          << (unpacked.folder() / "binaries" / SPOKE_FMU_PLATFORM / "rotor.so").string() << ' '
          << expected.size() << ' ' << fmu.reference(fmu.outputs().front()) << " 0.02 10";
  std::size_t values = 0;
  for (const std::string& line : lines_of(command.str())) {
    CAPTURE(line);
    if (line.starts_with("value ")) {
      REQUIRE(values < expected.size());
      CHECK(std::strtod(line.c_str() + 6, nullptr) == expected[values++]);
    } else if (line.starts_with("library ")) {
      const std::string name = fs::path(line.substr(8)).filename().string();
      const bool is_allowed = name.empty() || name == "rotor.so" || name == "linux-vdso.so.1" ||
                              name.starts_with("ld-linux") || name.starts_with("libc.so") ||
                              name.starts_with("libm.so") || name.starts_with("libdl.so") ||
                              name.starts_with("libpthread.so") ||
                              // The importer's own.
                              name.starts_with("libstdc++.so") || name.starts_with("libgcc_s.so");
      CHECK(is_allowed);
    } else {
      CHECK(line.empty());  // a message
    }
  }
  CHECK(values == expected.size());
}
