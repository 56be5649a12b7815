#pragma once

// Numbers that the paper prints: J.-B. Han, H. Song and S.-S. Kim, Trans. Korean Soc. Mech. Eng. A
// 41(6), 2017, 507-515, doi 10.3795/KSME-A.2017.41.6.507. Only its tables and text give values; its
// figures are curves without.

#include <array>
#include <string_view>
#include <vector>

#include "bench/reproduce/operation_counts.h"

namespace spoke::reproduce::paper {

/// One line of Table 2.
struct Count {
  Stage stage;
  std::string_view formula;
  std::int64_t value;  ///< value of the formula
  std::int64_t printed;
};

/// Returns the formulas of Table 2, evaluated.
std::vector<Count> table_2(const RotorSize& size = {});
inline constexpr std::int64_t kTable2Total = 7'790'118;  ///< as printed

/// Values of the item of Table 2 for M_sub^-1 by its formula n^3/3: for the printed size, for that
/// of a blade, and for the blocks of (P 11).
struct InverseSizes {
  std::int64_t printed;  ///< one matrix of the size (3 M)(3 (E + 1))
  std::int64_t blade;    ///< one matrix of the size M (3 + 3 E)
  std::int64_t blocks;   ///< M matrices of the size 3 + 3 E
};
InverseSizes inverse_sizes(const RotorSize& size = {});

/// Table 3: time per step [ms].
struct StepTime {
  std::string_view name;
  double milliseconds;
  double ratio;
};
inline constexpr std::array kTable3{
    StepTime{"conventional", 17.92, 36.57}, StepTime{"subsystem", 4.93, 10.06},
    StepTime{"parallel", 1.78, 3.64}, StepTime{"layered parallel", 0.49, 1.0}};

/// Final speed of the hub in Fig. 8 [rad/s]: not printed, but known from Wu and Haug (1988), whose
/// rotor it is.
inline constexpr double kFinalSpeed = 4.0;

/// Section 5.2: about the ratio of scheme 2's time on 3x4 threads to that on 3x1.
inline constexpr double kScheme2Slowdown = 1.8;

inline constexpr std::string_view kMachine =
    "Intel Xeon E5-1660, 16 GB, Windows 10, Visual Studio 2015";

}  // namespace spoke::reproduce::paper
