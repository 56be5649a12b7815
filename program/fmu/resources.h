#pragma once

// A scenario and the files that it names, as they lie in the folder of resources of an FMU.

#include <string>
#include <vector>

#include "models/scenario.h"

namespace spoke::fmu {

/// A file with its content.
struct PackedFile {
  std::string name;  ///< path within the archive
  std::string content;
};

/// A scenario with all that it refers to.
struct PackedScenario {
  std::string name;                 ///< of the scenario file
  Overrides overrides;              ///< those given, then those that name the files in `files`
  std::vector<PackedFile> files{};  ///< the scenario first; names are beside the scenario
};

/// Takes the text of a scenario file, and reads the files of meshes, matrices, aerofoils and wind
/// that it names, wherever they are: they get names of their own in the folder "files". Throws
/// InputError if one cannot be read. The scenario has been read before, so that it is known to be
/// valid.
PackedScenario pack_scenario(const std::string& file, const std::string& text,
                             const Overrides& overrides);

}  // namespace spoke::fmu
