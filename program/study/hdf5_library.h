#pragma once

// The HDF5 library, loaded when a study is written rather than with the program: it loads other
// libraries, and would make every start of the program 10 ms longer.

#include <hdf5.h>

namespace spoke::study {

/// The functions used of the library, with the prototypes of its header; only the library that the
/// program was built with fits them.
struct Hdf5Library {
  decltype(&::H5open) H5open;
  decltype(&::H5Acreate2) H5Acreate2;
  decltype(&::H5Aclose) H5Aclose;
  decltype(&::H5Awrite) H5Awrite;
  decltype(&::H5Dclose) H5Dclose;
  decltype(&::H5Dcreate2) H5Dcreate2;
  decltype(&::H5Dget_space) H5Dget_space;
  decltype(&::H5Dwrite) H5Dwrite;
  decltype(&::H5Eset_auto2) H5Eset_auto2;
  decltype(&::H5Fclose) H5Fclose;
  decltype(&::H5Fcreate) H5Fcreate;
  decltype(&::H5Gclose) H5Gclose;
  decltype(&::H5Gcreate2) H5Gcreate2;
  decltype(&::H5Pclose) H5Pclose;
  decltype(&::H5Pcreate) H5Pcreate;
  decltype(&::H5Pset_obj_track_times) H5Pset_obj_track_times;
  decltype(&::H5Sclose) H5Sclose;
  decltype(&::H5Screate) H5Screate;
  decltype(&::H5Screate_simple) H5Screate_simple;
  decltype(&::H5Sselect_hyperslab) H5Sselect_hyperslab;
  decltype(&::H5Tclose) H5Tclose;
  decltype(&::H5Tcopy) H5Tcopy;
  decltype(&::H5Tset_cset) H5Tset_cset;
  decltype(&::H5Tset_size) H5Tset_size;
  hid_t group_create, file_create, dataset_create;  ///< classes of properties
  hid_t text, native_double, stored_double;         ///< types
};

/// Returns the library; null if it is not there. It is loaded at the first call and kept.
const Hdf5Library* find_hdf5();

}  // namespace spoke::study
