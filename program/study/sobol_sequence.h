#pragma once

// Sobol's sequence of points in the unit cube.

#include <array>
#include <cstdint>
#include <vector>

namespace spoke::study {

/// The largest number of dimensions. The direction numbers are those of S. Joe and F. Y. Kuo,
/// "Constructing Sobol sequences with better two-dimensional projections", SIAM J. Sci. Comput. 30
/// (2008) 2635-2654, the first dimensions of their file new-joe-kuo-6.21201.
inline constexpr int kMostSobolDimensions = 50;

/// Coordinates of points, in the order of the Gray code, as Joe and Kuo's own program makes them;
/// point 0 is the origin.
class SobolSequence {
 public:
  /// Precondition: 1 <= dimensions <= kMostSobolDimensions.
  explicit SobolSequence(int dimensions);

  /// Returns one coordinate of a point times 2^32. Precondition: index < 2^32.
  std::uint32_t coordinate(std::uint64_t index, int dimension) const;

 private:
  using Directions = std::array<std::uint32_t, 32>;
  std::vector<Directions> directions_;  ///< direction numbers by dimension
};

}  // namespace spoke::study
