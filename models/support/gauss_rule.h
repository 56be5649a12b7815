#pragma once

// Gauss's rules on [0, 1].

#include <array>

namespace spoke {

/// Places and weights of the rule of so many points, exact for polynomials of degree
/// 2 kPoints - 1. Those of four points are as their closed form rounds in doubles.
template <int Points>
struct GaussRule;

template <>
struct GaussRule<3> {
  static constexpr int kPoints = 3;
  static constexpr std::array<double, kPoints> places{0.11270166537925831, 0.5,
                                                      0.88729833462074169};
  static constexpr std::array<double, kPoints> weights{5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
};

template <>
struct GaussRule<4> {
  static constexpr int kPoints = 4;
  static constexpr std::array<double, kPoints> places{0.069431844202973712, 0.33000947820757187,
                                                      0.66999052179242813, 0.93056815579702629};
  static constexpr std::array<double, kPoints> weights{0.17392742256872693, 0.32607257743127307,
                                                       0.32607257743127307, 0.17392742256872693};
};

template <>
struct GaussRule<6> {
  static constexpr int kPoints = 6;
  static constexpr std::array<double, kPoints> places{0.033765242898423986, 0.16939530676686775,
                                                      0.38069040695840155,  0.61930959304159845,
                                                      0.83060469323313225,  0.96623475710157601};
  static constexpr std::array<double, kPoints> weights{0.085662246189585173, 0.18038078652406930,
                                                       0.23395696728634552,  0.23395696728634552,
                                                       0.18038078652406930,  0.085662246189585173};
};

}  // namespace spoke
