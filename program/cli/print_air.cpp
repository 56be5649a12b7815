// Lines of air, wind and aerofoils.

#include "program/cli/print_air.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "models/air/wind_field.h"
#include "models/air/wind_kept.h"
#include "models/air/wind_keys.h"
#include "models/count_text.h"
#include "models/reader/keys/air_keys.h"
#include "models/tree/hub_place.h"
#include "program/cli/report.h"

namespace spoke::cli {
namespace {

using spatial::Airfoil;
using spatial::BladeAerodynamics;

std::string short_number(double value) { return fmt::format("{:.6g}", value); }

std::string vector_text(const Eigen::Vector3d& v) {
  return fmt::format("[{}, {}, {}]", short_number(v.x()), short_number(v.y()), short_number(v.z()));
}

/// Returns the direction of a vector; of files' wind, small numbers are rounding.
std::string direction_text(const Eigen::Vector3d& v) {
  constexpr double least = 1e-6;
  const Eigen::Vector3d direction = v.normalized();
  return vector_text((direction.array().abs() < least).select(0.0, direction));
}

std::string describe(const spatial::Air& air) {
  const std::string factor =
      air.inflow_factor != 1.0 ? " times " + short_number(air.inflow_factor) : "";
  const auto unless = [](auto usual, auto value, std::string_view words) {
    return value != usual ? fmt::format(", {} {}", words, name_of(value)) : std::string();
  };
  return fmt::format("{} kg/m^3, {} m^2/s, induction {}{}{}{}, inflow {}{}, stall {}",
                     short_number(air.density), short_number(air.viscosity), name_of(air.induction),
                     factor, unless(spatial::HighThrust::buhl, air.high_thrust, "high thrust"),
                     unless(spatial::MassFlow::glauert, air.mass_flow, "mass flow"),
                     name_of(air.inflow),
                     unless(spatial::AttachedFlow::steady, air.attached_flow, "attached flow"),
                     name_of(air.stall));
}

/// Describes the grid of a box: "15 x 17 points over 150 x 170 m, every 0.1 s for 600 s".
std::string describe(const air::WindBox& box) {
  return fmt::format("{} x {} points over {} x {} m, every {} s for {} s{}", box.n_y, box.n_z,
                     short_number(box.dy * static_cast<double>(box.n_y - 1)),
                     short_number(box.dz * static_cast<double>(box.n_z - 1)), short_number(box.dt),
                     short_number(box.dt * static_cast<double>(box.n_t)),
                     box.is_periodic ? ", repeats" : "");
}

/// Describes the mean wind at its reference height, or at the hub: "12 m/s along [1, 0, 0] at 90 m
/// above the ground at -90 m, shear exponent 0.2".
std::string describe_mean(const Wind& wind, const Eigen::Vector3d& hub) {
  const air::WindAxes axes(wind);
  const double height = wind.reference_height.value_or(axes.height(hub));
  const Eigen::Vector3d mean =
      make_wind(wind)->mean(wind.reference_height ? axes.place(0.0, height) : hub);
  std::string text = fmt::format("{} m/s", short_number(mean.norm()));
  if (mean.norm() > 0.0) text += " along " + direction_text(mean);
  if (wind.reference_height)
    text += fmt::format(" at {} m", short_number(height));
  else if (!wind.file.empty())
    text += fmt::format(" at the hub, {} m", short_number(height));
  if (wind.ground != 0.0)
    text += fmt::format(" above the ground at {} m", short_number(wind.ground));
  if (wind.shear_exponent != 0.0) text += ", shear exponent " + short_number(wind.shear_exponent);
  if (wind.vertical_shear != 0.0)
    text += ", vertical shear " + short_number(wind.vertical_shear) + " 1/m";
  if (wind.horizontal_shear != 0.0)
    text += ", horizontal shear " + short_number(wind.horizontal_shear) + " 1/m";
  return text;
}

std::string describe_course(const Curve& speed) {
  const auto [least, most] = std::minmax_element(speed.values().begin(), speed.values().end());
  return fmt::format("speed over time, {} to {} m/s, from {} to {} s", short_number(*least),
                     short_number(*most), short_number(speed.times().front()),
                     short_number(speed.times().back()));
}

/// Describes a gust by the unit of what it changes: "gust of 3 m/s from 5 s on for 10.5 s,
/// one_minus_cosine", "gust of direction, 30 deg from ...".
std::string describe(const WindGust& gust) {
  std::string size = short_number(gust.amplitude) + " m/s";
  if (gust.of == GustOf::direction)
    size = "direction, " + short_number(gust.amplitude * 180.0 / std::numbers::pi) + " deg";
  else if (gust.of != GustOf::speed)
    size = std::string(name_of(gust.of)) + ", " + short_number(gust.amplitude) + " 1/m";
  return fmt::format("gust of {} from {} s on for {} s, {}", size, short_number(gust.start),
                     short_number(gust.duration), name_of(gust.shape));
}

std::vector<std::string> describe(const Wind& wind, const Eigen::Vector3d& hub) {
  if (wind.by_program || wind.field) return {"by the program"};
  std::vector<std::string> lines{describe_mean(wind, hub)};
  if (wind.speed) lines.push_back(describe_course(*wind.speed));
  if (!wind.file.empty()) {
    const auto box = air::find_wind(wind)->box();
    const std::string file = std::filesystem::path(wind.file).filename().string();
    lines.push_back("mean of " + file + (box ? ": " + describe(*box) : ", a table over time"));
  }
  for (const WindGust& gust : wind.gusts) lines.push_back(describe(gust));
  if (wind.turbulence) {
    // The next line says what the box is.
    constexpr std::array<std::string_view, 7> kSaid{"intensity", "spectrum",  "seed",    "width",
                                                    "height",    "time_step", "duration"};
    lines.push_back(
        fmt::format("turbulence of {} %, {} m/s, {}, seed {}{}",
                    short_number(100.0 * wind.turbulence->intensity),
                    short_number(wind.turbulence->intensity * wind.velocity.norm()),
                    name_of(wind.turbulence->spectrum), wind.turbulence->seed,
                    keys::describe_others(keys::kTurbulenceRows, &*wind.turbulence, kSaid)));
    lines.push_back(describe(*air::find_wind(wind)->box()));
  }
  return lines;
}

/// Returns the names of aerofoils along a blade, each with the stations from which to which it is.
std::vector<std::string> describe_airfoils(const BladeAerodynamics& blade) {
  std::vector<std::string> lines;
  for (std::size_t first = 0, end = 0; first < blade.station.size(); first = end) {
    while (end < blade.station.size() && blade.airfoil[end] == blade.airfoil[first]) ++end;
    const std::string from = short_number(blade.station[first]);
    lines.push_back(fmt::format(
        "{} at {} m", blade.airfoil[first],
        end == first + 1 ? from : from + " to " + short_number(blade.station[end - 1])));
  }
  return lines;
}

std::vector<std::string> describe(const BladeAerodynamics& blade) {
  const auto [least, most] = std::minmax_element(blade.chord.begin(), blade.chord.end());
  std::vector<std::string> lines{fmt::format(
      "{} from {} to {} m, chord {} to {} m, leading edge {}",
      counted(std::ssize(blade.station), "station"), short_number(blade.station.front()),
      short_number(blade.station.back()), short_number(*least), short_number(*most),
      blade.leads_backward ? "towards -y" : "towards +y")};
  for (std::string& line : describe_airfoils(blade)) lines.push_back(std::move(line));
  return lines;
}

/// Describes coefficients so that a wrong file is seen: "127 angles, lift up to 1.442 at 11 deg,
/// drag from 0.0052, moment".
std::string describe(const spatial::Polar& polar) {
  const auto lift = std::max_element(polar.lift.begin(), polar.lift.end());
  const auto at = static_cast<std::size_t>(lift - polar.lift.begin());
  std::string text =
      polar.reynolds > 0.0 ? fmt::format("Re {}: ", short_number(polar.reynolds)) : "";
  if (polar.mach) text = fmt::format("Mach {}: ", short_number(*polar.mach));
  text += counted(std::ssize(polar.angle), "angle");
  if (*lift > 0.0)
    text += fmt::format(", lift up to {} at {} deg", short_number(*lift),
                        short_number(polar.angle[at] * 180.0 / std::numbers::pi));
  text += ", drag from " + short_number(*std::min_element(polar.drag.begin(), polar.drag.end()));
  return text + (polar.moment.empty() ? "" : ", moment");
}

void print_texts(const std::string& label, const std::vector<std::string>& lines) {
  for (std::size_t i = 0; i < lines.size(); ++i)
    print_line(i == 0 ? label : "", one_line(lines[i]));
}

/// Returns "6", or "6 to 3.87": the first and the last of values.
std::string describe_ends(const std::vector<double>& values) {
  std::string text = short_number(values.front());
  if (values.back() != values.front()) text += " to " + short_number(values.back());
  return text;
}

std::string describe(const spatial::BodyDrag& drag) {
  if (drag.station.empty())
    return fmt::format("areas {} m^2 at {} m", vector_text(drag.area), vector_text(drag.point));
  return fmt::format("{} m wide at {} m, coefficient {}{}", describe_ends(drag.diameter),
                     describe_ends(drag.station), describe_ends(drag.coefficient),
                     keys::describe_others(keys::kBodyDragRows, &drag));
}

/// Returns a line for each body that has drag.
std::vector<std::string> describe_drags(const spatial::Model& model) {
  std::vector<std::string> lines;
  for (const spatial::Subsystem& subsystem : model.subsystems)
    for (const spatial::Body& body : subsystem.bodies)
      if (body.drag)
        lines.push_back(
            fmt::format("{} / {}: {}", subsystem.name, body.name, describe(*body.drag)));
  return lines;
}

}  // namespace

void print_air(const spatial::Model& model) {
  assert(model.air);
  print_line("air", describe(*model.air));
  print_texts("wind", describe(model.air->wind, spatial::find_hub_place(model)));
  std::vector<std::string> before;
  for (std::size_t i = 0; i < model.blades.size(); ++i) {
    if (!model.blades[i].aerodynamics) continue;
    std::vector<std::string> lines = describe(*model.blades[i].aerodynamics);
    if (lines == before) continue;
    print_texts(fmt::format("air, blade {}", i + 1), lines);
    before = std::move(lines);
  }
  print_texts("drag", describe_drags(model));
  for (const Airfoil& airfoil : model.air->airfoils) {
    std::vector<std::string> lines;
    for (const spatial::Polar& polar : airfoil.polars)
      lines.push_back((lines.empty() ? airfoil.name + ": " : "") + describe(polar));
    print_texts(&airfoil == &model.air->airfoils.front() ? "aerofoils" : "", lines);
  }
}

}  // namespace spoke::cli
