#pragma once

// Reads ServoDyn's file: generator, pitch, yaw, and the library that controls them.

#include "program/foreign/beam_table.h"
#include "program/foreign/keyed_lines.h"

namespace spoke::foreign {

/// Files that it names: a library of Bladed's kind and the file that this reads.
struct ServoDynFile {
  NamedFile library, input;
};

/// Reads the file, behind ElastoDyn's primary one: generator, yaw and the maneuvers go to the
/// model, the library without its files. Throws InputError with file and line.
ServoDynFile read_servodyn(const SourceFile& source, FoundModel& model);

}  // namespace spoke::foreign
