// Looks for the library by the name that it was linked against at configuration.

#include "program/study/hdf5_library.h"

#include <dlfcn.h>

#include <optional>

namespace spoke::study {
namespace {

/// Finds a function of the library by its name; false if it has none.
template <class Function>
bool find(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(library, name));
  return function != nullptr;
}

/// Reads a number that the library knows once it has been opened.
bool read(void* library, const char* name, hid_t& number) {
  const hid_t* found = nullptr;
  if (!find(library, name, found)) return false;
  number = *found;
  return true;
}

std::optional<Hdf5Library> load() {
  void* library = dlopen(SPOKE_HDF5_LIBRARY, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) return {};
  Hdf5Library hdf5{};
  const bool has_functions =
      find(library, "H5open", hdf5.H5open) && find(library, "H5Acreate2", hdf5.H5Acreate2) &&
      find(library, "H5Aclose", hdf5.H5Aclose) && find(library, "H5Awrite", hdf5.H5Awrite) &&
      find(library, "H5Dclose", hdf5.H5Dclose) && find(library, "H5Dcreate2", hdf5.H5Dcreate2) &&
      find(library, "H5Dget_space", hdf5.H5Dget_space) &&
      find(library, "H5Dwrite", hdf5.H5Dwrite) &&
      find(library, "H5Eset_auto2", hdf5.H5Eset_auto2) &&
      find(library, "H5Fclose", hdf5.H5Fclose) && find(library, "H5Fcreate", hdf5.H5Fcreate) &&
      find(library, "H5Gclose", hdf5.H5Gclose) && find(library, "H5Gcreate2", hdf5.H5Gcreate2) &&
      find(library, "H5Pclose", hdf5.H5Pclose) && find(library, "H5Pcreate", hdf5.H5Pcreate) &&
      find(library, "H5Pset_obj_track_times", hdf5.H5Pset_obj_track_times) &&
      find(library, "H5Sclose", hdf5.H5Sclose) && find(library, "H5Screate", hdf5.H5Screate) &&
      find(library, "H5Screate_simple", hdf5.H5Screate_simple) &&
      find(library, "H5Sselect_hyperslab", hdf5.H5Sselect_hyperslab) &&
      find(library, "H5Tclose", hdf5.H5Tclose) && find(library, "H5Tcopy", hdf5.H5Tcopy) &&
      find(library, "H5Tset_cset", hdf5.H5Tset_cset) &&
      find(library, "H5Tset_size", hdf5.H5Tset_size);
  if (!has_functions || hdf5.H5open() < 0) return {};
  const bool has_numbers = read(library, "H5P_CLS_GROUP_CREATE_ID_g", hdf5.group_create) &&
                           read(library, "H5P_CLS_FILE_CREATE_ID_g", hdf5.file_create) &&
                           read(library, "H5P_CLS_DATASET_CREATE_ID_g", hdf5.dataset_create) &&
                           read(library, "H5T_C_S1_g", hdf5.text) &&
                           read(library, "H5T_NATIVE_DOUBLE_g", hdf5.native_double) &&
                           read(library, "H5T_IEEE_F64LE_g", hdf5.stored_double);
  if (!has_numbers) return {};
  return hdf5;
}

}  // namespace

const Hdf5Library* find_hdf5() {
  static const std::optional<Hdf5Library> library = load();
  return library ? &*library : nullptr;
}

}  // namespace spoke::study
