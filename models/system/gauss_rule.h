#pragma once

// Gauss's rule of four points on [0, 1], exact for polynomials of degree seven.

#include <array>

namespace spoke {

struct GaussRule {
  static constexpr int kPoints = 4;
  static constexpr std::array<double, kPoints> places{0.069431844202973712, 0.33000947820757187,
                                                      0.66999052179242813, 0.93056815579702629};
  static constexpr std::array<double, kPoints> weights{0.17392742256872693, 0.32607257743127307,
                                                       0.32607257743127307, 0.17392742256872693};
};

}  // namespace spoke
