#pragma once

// Writes study.h5: parameters, responses and histories of all runs, for numerical tools.

#include <string>

#include "program/study/analysis.h"

namespace spoke::study {

/// Returns whether this program was built to write HDF5 files.
bool has_hdf5();

/// Writes the file as a whole, in place of an existing one. Layout: docs/studies.md. Memory does
/// not grow with the runs. Throws InputError if it cannot be written. Precondition: has_hdf5().
void write_hdf5(const std::string& file, const Study& study, const Sampling& sampling,
                const ForEachRun& for_each);

}  // namespace spoke::study
