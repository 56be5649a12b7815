// Rules for wind.

#include "models/air/wind_rules.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "models/air/turbulence.h"

namespace spoke::air {
namespace {

/// Keeps the first fault that is found.
class FirstWindFault {
 public:
  explicit FirstWindFault(std::string within = {}) : within_(std::move(within)) {}

  void add(std::string_view key, const std::string& text) const {
    if (!fault_ && !text.empty()) fault_ = {within_ + std::string(key), text};
  }
  void operator()(std::string_view key, double value, const Quantity& range,
                  Presence = Presence::required) const {
    const std::string expected = range.expectation_instead_of(value);
    if (!expected.empty()) add(key, "is " + describe(value) + ", expected " + expected);
  }
  void operator()(std::string_view key, int value, const Count& range, Presence) const {
    if (!range.holds(value))
      add(key, "is " + std::to_string(value) + ", expected " + range.expectation());
  }
  template <class Values>
  void numbers(std::string_view key, const Values& values, const Quantity& range) const {
    int number = 0;
    for (const double value : values)
      (*this)(std::string(key) + '.' + std::to_string(++number), value, range);
  }
  const WindFault& found() const { return fault_; }

 private:
  std::string within_;
  mutable WindFault fault_;  // mutable, since visitors are constant
};

WindFault find_program_fault(const Wind& wind) {
  Wind rest;
  rest.by_program = wind.by_program;
  rest.field = wind.field;
  if (wind == rest) return {};
  return {"by", "is \"program\", which gives all of the wind, expected no other key"};
}

/// Finds more than one source of the speed.
WindFault find_source_fault(const Wind& wind) {
  constexpr const char* kAlong = "given along with file, expected only one of them";
  const FirstWindFault first;
  if (!wind.file.empty() && wind.speed) first.add("speed", kAlong);
  if (!wind.file.empty() && wind.turbulence) first.add("turbulence", kAlong);
  constexpr const char* kOwnShear = "given along with a file of TurbSim, which has its own shear";
  if (is_bts(wind.file) && wind.shear_exponent != 0.0) first.add("shear_exponent", kOwnShear);
  if (is_bts(wind.file) && wind.vertical_shear != 0.0) first.add("vertical_shear", kOwnShear);
  if (is_bts(wind.file) && wind.horizontal_shear != 0.0) first.add("horizontal_shear", kOwnShear);
  if (wind.turbulence && wind.speed)
    first.add("turbulence", "is of a wind whose speed has a course, expected a constant velocity");
  return first.found();
}

/// Whether a gust changes the wind of places in different ways.
bool is_of_places(const WindGust& gust) {
  return gust.of == GustOf::vertical_shear || gust.of == GustOf::horizontal_shear;
}

/// Finds a direction of the wind for which nothing is across.
WindFault find_direction_fault(const Wind& wind) {
  const bool has_heights = wind.turbulence || wind.shear_exponent != 0.0 ||
                           wind.vertical_shear != 0.0 || wind.horizontal_shear != 0.0 ||
                           std::any_of(wind.gusts.begin(), wind.gusts.end(),
                                       [](const WindGust& gust) { return is_of_places(gust); });
  if (!has_heights && wind.file.empty()) return {};
  const double along_up = direction_of(wind).dot(wind.up.normalized());
  if (!wind.file.empty() && std::abs(along_up) > 1e-9)
    return {"velocity",
            "is inclined, expected a direction across up: the file has the vertical "
            "speed"};
  if (std::abs(along_up) > 0.99)
    return {"velocity", "is along up, expected a wind across it, which has a profile of heights"};
  return {};
}

WindFault find_reference_fault(const Wind& wind) {
  if (wind.reference_height) return {};
  constexpr const char* kMissing = "is missing, expected the height at which velocity is (m), for ";
  if (wind.shear_exponent != 0.0)
    return {"reference_height", std::string(kMissing) + "shear_exponent"};
  if (wind.vertical_shear != 0.0)
    return {"reference_height", std::string(kMissing) + "vertical_shear"};
  if (wind.turbulence) return {"reference_height", std::string(kMissing) + "turbulence"};
  for (const WindGust& gust : wind.gusts)
    if (gust.of == GustOf::vertical_shear)
      return {"reference_height", std::string(kMissing) + "a gust of vertical_shear"};
  return {};
}

/// Finds a box that is too large, or reaches below the ground.
WindFault find_box_fault(const WindTurbulence& turbulence, double reference_height) {
  const FirstWindFault first("turbulence.");
  const double height = turbulence.height.value_or(turbulence.width);
  if (height > 2.0 * reference_height)
    first.add(turbulence.height ? "height" : "width",
              "is " + describe(height) + ", and the box around the reference height of " +
                  describe(reference_height) +
                  " m reaches below the ground; expected a height of at most " +
                  describe(2.0 * reference_height) + " (m)");
  const double steps = turbulence.duration / turbulence.time_step;
  if (steps < 16.0)
    first.add("duration", "is " + describe(turbulence.duration) + ", expected 16 time steps of " +
                              describe(turbulence.time_step) + " s or more");
  const BoxCost cost = estimate_cost(turbulence);
  if (cost.values > kMostBoxValues)
    first.add("points", "make a box of " + describe(std::round(cost.values / 1e6)) +
                            " million velocities over time, expected at most " +
                            describe(kMostBoxValues / 1e6) +
                            "; have fewer points, a longer time_step or a shorter duration");
  if (cost.operations > kMostBoxOperations)
    first.add("points",
              "have a coherence that takes " + describe(std::round(cost.operations / 1e9)) +
                  " thousand million operations, expected at most " +
                  describe(kMostBoxOperations / 1e9) + "; have fewer points or a shorter duration");
  return first.found();
}

WindFault find_fault(const WindTurbulence& turbulence) {
  const FirstWindFault first("turbulence.");
  keys::visit_numbers<void>(keys::kTurbulenceRows, turbulence, first);
  if (turbulence.length_scale) first("length_scale", *turbulence.length_scale, kTurbulenceScale);
  first.numbers("deviation_ratio", turbulence.deviation_ratio, kDeviationRatio);
  if (turbulence.deviation_ratio[0] != 1.0)
    first.add("deviation_ratio.1", "is " + describe(turbulence.deviation_ratio[0]) +
                                       ", expected 1: the others are over that along the wind");
  if (turbulence.height) first("height", *turbulence.height, kBoxHeight);
  first("points.1", turbulence.points[0], kBoxPoints, Presence::optional);
  first("points.2", turbulence.points[1], kBoxPoints, Presence::optional);
  return first.found();
}

/// Finds a number out of its range.
WindFault find_number_fault(const Wind& wind) {
  const FirstWindFault first;
  first.numbers("velocity",
                std::vector<double>{wind.velocity.x(), wind.velocity.y(), wind.velocity.z()},
                kWindSpeed);
  if (wind.speed) {
    first.numbers("time", wind.speed->times(), kWindTime);
    first.numbers("speed", wind.speed->values(), kWindSpeed);
  }
  first("shear_exponent", wind.shear_exponent, kShearExponent);
  first("vertical_shear", wind.vertical_shear, kLinearShear);
  first("horizontal_shear", wind.horizontal_shear, kLinearShear);
  if (wind.reference_height) first("reference_height", *wind.reference_height, kReferenceHeight);
  first.numbers("up", std::vector<double>{wind.up.x(), wind.up.y(), wind.up.z()}, kUp);
  if (wind.up.isZero(0.0)) first.add("up", "has length 0, expected a direction");
  first("ground", wind.ground, kGround);
  if (first.found()) return first.found();
  for (std::size_t k = 0; k < wind.gusts.size(); ++k) {
    const FirstWindFault of_gust("gust." + std::to_string(k + 1) + '.');
    keys::visit_numbers<void>(keys::kGustRows, wind.gusts[k], of_gust);
    if (of_gust.found()) return of_gust.found();
  }
  return {};
}

}  // namespace

bool is_bts(const std::string& file) {
  std::string ending = file.size() < 4 ? std::string() : file.substr(file.size() - 4);
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending == ".bts";
}

Eigen::Vector3d direction_of(const Wind& wind) {
  const double speed = wind.velocity.norm();
  return speed > 0.0 ? Eigen::Vector3d(wind.velocity / speed) : Eigen::Vector3d::UnitX();
}

WindFault find_wind_fault(const Wind& wind) {
  if (wind.by_program || wind.field) return find_program_fault(wind);
  if (WindFault fault = find_number_fault(wind)) return fault;
  if (WindFault fault = find_source_fault(wind)) return fault;
  if (WindFault fault = find_direction_fault(wind)) return fault;
  if (wind.turbulence)
    if (WindFault fault = find_fault(*wind.turbulence)) return fault;
  if (WindFault fault = find_reference_fault(wind)) return fault;
  if (!wind.turbulence) return {};
  if (wind.velocity.isZero(0.0))
    return {"velocity", "is 0, and its turbulence would be, too; expected a wind (m/s)"};
  return find_box_fault(*wind.turbulence, *wind.reference_height);
}

}  // namespace spoke::air
