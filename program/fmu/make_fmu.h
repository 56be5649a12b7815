#pragma once

// Makes an FMU of a scenario: its archive with model description, library, resources and licence.

#include <filesystem>
#include <string>
#include <vector>

#include "engine/simulation.h"
#include "program/fmu/inputs.h"
#include "program/fmu/model_description.h"

namespace spoke::fmu {

/// What an FMU is made of.
struct FmuRequest {
  std::string scenario;              ///< file
  Overrides overrides;               ///< of its keys
  std::string name;                  ///< of the FMU: its file's without folder and ending
  std::filesystem::path binary;      ///< shared object that goes into it, see find_library()
  std::vector<std::string> inputs;   ///< names; none: the usual ones; "none": no inputs
  std::vector<std::string> outputs;  ///< names of columns or of sensors; none: all columns
  FmiVersion version = FmiVersion::three;
  std::string text = {};  ///< of the file, if it has been read; it may be a pipe
};

/// An FMU that is ready to be written.
struct Fmu {
  std::string bytes;                 ///< of the archive
  Inputs inputs;                     ///< that it has
  std::vector<std::string> outputs;  ///< columns of sensors.csv that it has
  std::vector<std::string> files{};  ///< in the archive
};

/// Returns the path in an FMU of the folder for shared objects of this kind of machine.
std::string binaries_folder(FmiVersion version);

/// Returns the shared object that becomes part of FMUs: beside the running program, or where it is
/// installed from there. Throws InputError if it is not there.
std::filesystem::path find_library();

/// Makes an FMU of a scenario that `simulation` has been built of, at t = 0. Throws InputError for
/// names that there are not, and for files that cannot be read.
Fmu make_fmu(const FmuRequest& request, const Simulation& simulation);

}  // namespace spoke::fmu
