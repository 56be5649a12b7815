// Rules for aerofoils.

#include "models/air/airfoil_check.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "models/error.h"
#include "models/support/quantity.h"

namespace spoke::air {
namespace {

using spatial::Airfoil;
using spatial::Polar;

constexpr double kLargest = 100.0;  // no coefficient is larger

std::string in_degrees(double angle) { return describe(angle * (180.0 / std::numbers::pi)); }

/// A fault of an angle; `expected` in degrees and in rad.
PolarFault make_angle_fault(int row, double angle, const std::string& degrees,
                            const std::string& radians) {
  // No other angle is as large: it was given in degrees.
  const char* hint = std::abs(angle) > 2.0 * std::numbers::pi ? ": degrees?" : "";
  return {row, "angle", "angle of attack is " + in_degrees(angle) + " degrees, expected " + degrees,
          "is " + describe(angle) + ", expected " + radians + " (rad)" + hint};
}

std::optional<PolarFault> find_angle_fault(const std::vector<double>& angle) {
  constexpr double least_gap = 1e-6;
  if (angle.size() < 3) {
    const std::string has = "has " + std::to_string(angle.size());
    return PolarFault{-1, "angle", has + " angles of attack, expected 3 or more",
                      has + " values, expected 3 or more"};
  }
  for (std::size_t i = 0; i < angle.size(); ++i) {
    const int row = static_cast<int>(i);
    if (!std::isfinite(angle[i]))
      return make_angle_fault(row, angle[i], "a finite number", "a finite number");
    if (i == 0 && std::abs(angle[i] + std::numbers::pi) > least_gap)
      return make_angle_fault(row, angle[i], "-180 in the first row",
                              "-pi as the first, -" + describe(std::numbers::pi));
    if (i > 0 && !(angle[i] > angle[i - 1] + least_gap))
      return make_angle_fault(row, angle[i],
                              "more than in the row before, " + in_degrees(angle[i - 1]),
                              "more than the one before, " + describe(angle[i - 1]));
    if (i + 1 == angle.size() && std::abs(angle[i] - std::numbers::pi) > least_gap)
      return make_angle_fault(row, angle[i], "180 in the last row",
                              "pi as the last, " + describe(std::numbers::pi));
  }
  return std::nullopt;
}

/// `least`: what is expected; `tolerated`: what is let pass.
std::optional<PolarFault> find_column_fault(const std::string& name,
                                            const std::vector<double>& column, std::size_t size,
                                            double least, double tolerated) {
  if (column.size() != size) {
    const std::string has = "has " + std::to_string(column.size()) + " values",
                      expected = ", expected one for each of " + std::to_string(size) +
                                 " angles of attack";
    return PolarFault{-1, name, has + " of " + name + expected, has + expected};
  }
  for (std::size_t i = 0; i < size; ++i) {
    if (column[i] >= tolerated && column[i] <= kLargest) continue;
    const std::string is =
        "is " + describe(column[i]) + ", expected " + describe(least) + " to " + describe(kLargest);
    return PolarFault{static_cast<int>(i), name, name + ' ' + is, is};
  }
  return std::nullopt;
}

std::optional<PolarFault> find_open_end(const std::string& name,
                                        const std::vector<double>& column) {
  if (column.empty() || column.front() == column.back()) return std::nullopt;
  const std::string last = "is " + describe(column.back()),
                    first = ", expected " + describe(column.front());
  return PolarFault{static_cast<int>(column.size()) - 1, name,
                    name + ' ' + last + " at 180 degrees" + first + " as at -180 degrees",
                    last + " at pi" + first + " as at -pi", true};
}

}  // namespace

std::optional<PolarFault> find_polar_fault(const Polar& polar) {
  if (auto fault = find_angle_fault(polar.angle)) return fault;
  const std::size_t size = polar.angle.size();
  if (auto fault = find_column_fault("lift", polar.lift, size, -kLargest, -kLargest)) return fault;
  if (auto fault = find_column_fault("drag", polar.drag, size, 0.0, kLeastDrag)) return fault;
  if (!polar.moment.empty())
    if (auto fault = find_column_fault("moment", polar.moment, size, -kLargest, -kLargest))
      return fault;
  if (auto fault = find_open_end("lift", polar.lift)) return fault;
  if (auto fault = find_open_end("drag", polar.drag)) return fault;
  return find_open_end("moment", polar.moment);
}

std::string find_mach_fault(const std::vector<Polar>& polars, std::size_t k) {
  const std::optional<double>& mach = polars[k].mach;
  if (!mach) return polars.front().mach ? "is missing, expected one, as of the first polar" : "";
  const std::string is = "is " + describe(*mach);
  if (!(*mach >= 0.0) || !std::isfinite(*mach)) return is + ", expected 0 or more";
  if (polars[k].reynolds != 0.0)
    return is + ", given along with a Reynolds number, expected only one of them";
  if (k == 0) return {};
  if (!polars.front().mach) return is + ", expected none, as of the first polar";
  if (!polars[k - 1].mach || *mach > *polars[k - 1].mach) return {};
  return is + ", expected more than in the polar before";
}

void check_airfoil(const Airfoil& airfoil) {
  const auto refuse = [&](const std::string& what) {
    throw InputError("aerofoil \"" + airfoil.name + "\": " + what);
  };
  if (airfoil.polars.empty()) refuse("has no polars, expected one or more");
  for (std::size_t k = 0; k < airfoil.polars.size(); ++k) {
    const Polar& polar = airfoil.polars[k];
    if (const std::string fault = find_mach_fault(airfoil.polars, k); !fault.empty())
      refuse("polar " + std::to_string(k + 1) + ": Mach number " + fault);
    const auto name = [k] { return "polar " + std::to_string(k + 1) + ": "; };
    const auto refuse_reynolds = [&](const char* expected) {
      refuse(name() + "Reynolds number is " + describe(polar.reynolds) + ", expected " + expected);
    };
    if (airfoil.polars.size() > 1 && !polar.mach) {
      if (!(polar.reynolds > 0.0) || !std::isfinite(polar.reynolds))
        refuse_reynolds("a number greater than 0");
      if (k > 0 && !(polar.reynolds > airfoil.polars[k - 1].reynolds))
        refuse_reynolds("more than in the polar before");
    } else if (!(polar.reynolds >= 0.0) || !std::isfinite(polar.reynolds)) {
      refuse_reynolds("0 or more");
    }
    if (const auto fault = find_polar_fault(polar)) {
      const std::string row =
          fault->row >= 0 ? "row " + std::to_string(fault->row + 1) + ": " : std::string();
      refuse(name() + row + fault->what);
    }
  }
}

}  // namespace spoke::air
