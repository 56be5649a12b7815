#pragma once

// Gauss's rules on [0, 1]: of four points, exact for polynomials of degree seven, and of three
// points, exact for those of degree five.

#include <array>

namespace spoke {

struct GaussRule {
  static constexpr int kPoints = 4;
  static constexpr std::array<double, kPoints> places{0.069431844202973712, 0.33000947820757187,
                                                      0.66999052179242813, 0.93056815579702629};
  static constexpr std::array<double, kPoints> weights{0.17392742256872693, 0.32607257743127307,
                                                       0.32607257743127307, 0.17392742256872693};
};

struct GaussRuleOfThree {
  static constexpr int kPoints = 3;
  static constexpr std::array<double, kPoints> places{0.11270166537925831, 0.5,
                                                      0.88729833462074169};
  static constexpr std::array<double, kPoints> weights{5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
};

}  // namespace spoke
