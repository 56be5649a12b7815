#pragma once

// Gauss's rule of six points on [0, 1], exact for polynomials of degree eleven.

#include <array>

namespace spoke::space {

struct GaussRule {
  static constexpr int kPoints = 6;
  static constexpr std::array<double, kPoints> places{0.033765242898423986, 0.16939530676686775,
                                                      0.38069040695840155,  0.61930959304159845,
                                                      0.83060469323313225,  0.96623475710157601};
  static constexpr std::array<double, kPoints> weights{0.085662246189585173, 0.18038078652406930,
                                                       0.23395696728634552,  0.23395696728634552,
                                                       0.18038078652406930,  0.085662246189585173};
};

}  // namespace spoke::space
