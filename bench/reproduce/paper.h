#pragma once

// What the paper prints: J.-B. Han, H. Song and S.-S. Kim, Trans. Korean Soc. Mech. Eng. A 41(6),
// 2017, 507-515, doi 10.3795/KSME-A.2017.41.6.507. Its figures are curves without printed values,
// its tables and text are not.

#include <array>
#include <string_view>
#include <vector>

#include "bench/reproduce/operation_counts.h"

namespace spoke::reproduce::paper {

/// One line of Table 2.
struct Count {
  Stage stage;
  std::string_view formula;
  std::int64_t value;  ///< of the formula
  std::int64_t printed;
};

/// The formulas of Table 2, evaluated.
std::vector<Count> table_2(const RotorSize& size = {});
inline constexpr std::int64_t kTable2Total = 7'790'118;  ///< printed

/// The item of Table 2 that stands for M_sub^-1, by its own formula n^3/3: with the size that is
/// printed, with that of a blade, and with the blocks of (P 11).
struct InverseSizes {
  std::int64_t printed;  ///< one of (3 M)(3 (E + 1))
  std::int64_t blade;    ///< one of M (3 + 3 E)
  std::int64_t blocks;   ///< M of 3 + 3 E
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

/// Of the hub in Fig. 8 [rad/s]: not printed; of Wu and Haug (1988), whose rotor it is.
inline constexpr double kFinalSpeed = 4.0;

/// Section 5.2: scheme 2 on 3x4 threads takes about as many times what it takes on 3x1.
inline constexpr double kScheme2Slowdown = 1.8;

inline constexpr std::string_view kMachine =
    "Intel Xeon E5-1660, 16 GB, Windows 10, Visual Studio 2015";

}  // namespace spoke::reproduce::paper
