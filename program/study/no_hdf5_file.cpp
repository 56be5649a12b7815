// Stands for HDF5 files in builds without HDF5.

#include <cassert>

#include "program/study/hdf5_file.h"

namespace spoke::study {

bool has_hdf5() { return false; }

void write_hdf5(const std::string&, const Study&, const Sampling&, const ForEachRun&) {
  assert(false);
}

}  // namespace spoke::study
