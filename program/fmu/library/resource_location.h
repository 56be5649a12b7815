#pragma once

// Where the resources of an FMU of FMI 2.0 lie.

#include <string>

namespace spoke::fmu {

/// Returns the path of the folder that a URI ("file:///home/me/my%20fmu/resources") names; text
/// that is none is taken for a path. Throws InputError for URIs of other kinds and other machines.
std::string path_of_location(const std::string& location);

}  // namespace spoke::fmu
