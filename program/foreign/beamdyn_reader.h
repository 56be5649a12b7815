#pragma once

// Reads the files of a blade of BeamDyn.

#include <string>
#include <string_view>
#include <vector>

#include "program/foreign/blade_axis.h"

namespace spoke::foreign {

/// A file's text and its name, as messages have it.
struct SourceFile {
  std::string name;
  std::string text;
};

/// What a primary file says of a blade.
struct BeamDynPrimary {
  std::string title;
  std::vector<KeyPoint> points;  ///< in Spoke's axes
  int members = 1;
  std::string blade_file;   ///< as it is given, relative to the primary file's folder
  int blade_file_line = 0;  ///< where it is given
};

/// What a blade file says.
struct BeamDynBlade {
  std::string title;
  std::vector<double> mu;      ///< six factors [s]; empty: none
  std::vector<double> ratios;  ///< damping ratios of the lowest modes; empty: none
  std::string damping_from;
  std::vector<FoundSection> sections;
  /// Largest difference of two entries of matrices that were made symmetric, by their diagonal.
  double asymmetry = 0.0;
};

/// Reads a primary file: key points and the name of the blade file. Throws InputError with file and
/// line.
BeamDynPrimary read_beamdyn_primary(const SourceFile& source);

/// Reads a blade file. Throws InputError with file and line.
BeamDynBlade read_beamdyn_blade(const SourceFile& source);

}  // namespace spoke::foreign
