// Of builds without HDF5.

#include "engine/study/hdf5_file.h"
#include "models/error.h"

namespace spoke::study {

bool has_hdf5() { return false; }

void write_hdf5(const std::string& file, const Study&, const Sampling&, const ForEachRun&) {
  throw InputError(file + ": cannot be written: this build of Spoke is without HDF5");
}

}  // namespace spoke::study
