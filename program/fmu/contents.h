#pragma once

// What the library in an FMU needs to know beside the scenario: the file "spoke.toml" of its
// resources.

#include <string>
#include <vector>

#include "models/scenario.h"

namespace spoke::fmu {

/// Name of the file in the folder of resources.
inline constexpr const char* kContentsFile = "spoke.toml";

/// The model of an FMU, and what of it importers see.
struct Contents {
  std::string token;                 ///< instantiationToken: of the model, its inputs and outputs
  std::string scenario;              ///< name of the scenario file, beside this one
  Overrides overrides;               ///< of its keys; names of files are those of the resources
  double step = 0.0;                 ///< of the integration, in use [s]
  std::vector<std::string> inputs;   ///< names, in the order of value references
  std::vector<std::string> outputs;  ///< names of sensors, behind the inputs
};

/// Value references: the time's, then those of the inputs and of the outputs, one by one.
inline constexpr unsigned kTimeReference = 0, kFirstReference = 1;

/// Returns the text of the file.
std::string write_contents(const Contents& contents);

/// Reads the text of a file called `name`. Throws InputError if it is none of this version.
Contents read_contents(const std::string& text, const std::string& name);

}  // namespace spoke::fmu
