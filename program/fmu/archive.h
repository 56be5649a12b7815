#pragma once

// Archives of the format zip, by libzip.

#include <string>
#include <vector>

#include "program/fmu/resources.h"

namespace spoke::fmu {

/// Returns the bytes of an archive of these files, compressed. Equal files make equal bytes: all
/// have the time 1980-01-01. Throws InputError if the library cannot make it.
std::string make_archive(const std::vector<PackedFile>& files);

}  // namespace spoke::fmu
