#pragma once

// Beams for tests: uniform ones, and random ones with all that a beam may have.

#include <random>

#include "models/space/flexible_body.h"

namespace spoke::space::test {

/// The features of a random beam.
struct BeamOptions {
  bool is_bent = true;       ///< whether the reference curve is bent, by a sixth of the length
  bool has_matrices = true;  ///< whether it has full section matrices, else properties with offsets
  bool has_masses = true;
};

/// Makes a straight beam of one section.
Beam make_uniform_beam(const SectionProperties& section, double length);

/// Makes a slender beam of 2 to 4 m, tapered and twisted by more than a radian, with offsets.
Beam make_random_beam(const BeamOptions& options, std::mt19937& random);

/// Returns the stations of a body's nodes over the whole beam, with elements of unequal length.
std::vector<double> make_unequal_stations(const Beam& beam, int elements, std::mt19937& random);

/// Returns the symmetric matrix of all coordinates of all nodes, without those that the frame
/// fixes.
Eigen::MatrixXd to_dense(const FlexibleBody& body, const BlockTridiagonal& matrix);

}  // namespace spoke::space::test
