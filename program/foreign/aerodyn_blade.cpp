// Nodes of AeroDyn on the blade of another file. Spoke's axes are AeroDyn's (z, -y, x); twist is of
// the other sign; the aerodynamic centre is found along the chord from the blade's axis.

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/space/reference_curve.h"
#include "models/support/quantity.h"
#include "program/foreign/aerodyn_reader.h"
#include "program/foreign/beam_twist.h"

namespace spoke::foreign {
namespace {

/// The axis of a beam: straight, or the scenario's spline.
class Axis {
 public:
  explicit Axis(const BeamTable& beam) : curve_(places_of(beam)) {}
  space::Position at(double x) const { return curve_.at(x); }

 private:
  static std::vector<space::Position> places_of(const BeamTable& beam) {
    std::vector<space::Position> places;
    for (std::size_t i = 0; i < beam.station.size(); ++i)
      places.emplace_back(beam.station[i], beam.sweep.empty() ? 0.0 : beam.sweep[i],
                          beam.prebend.empty() ? 0.0 : beam.prebend[i]);
    return places;
  }
  space::ReferenceCurve curve_;
};

/// Returns the station of a node: that at the tip if they differ by what figures leave.
double find_station(const AeroDynNode& node, const std::string& file, const Value& length) {
  const double slack = 1e-4 * length.number;
  if (node.span > length.number + slack)
    refuse(file, node.line,
           "BlSpn is " + describe(node.span) + ", expected at most the blade's length, " +
               describe(length.number) + " (" + length.from + ")");
  return std::min(node.span, length.number);
}

}  // namespace

void add_aerodyn_blade(const std::vector<AeroDynNode>& nodes, const std::string& file,
                       const std::vector<std::string>& names, FoundModel& model) {
  const BeamTable& beam = *model.blade;
  const Axis axis(beam);
  FoundAir& found = *model.air;
  constexpr double rounding = 1e-12;  // [rad]
  double off_chord = 0.0;
  for (const AeroDynNode& node : nodes) {
    const double x = find_station(node, file, beam.length);
    const double twist = node.twist == 0.0 ? 0.0 : -node.twist * std::numbers::pi / 180.0;
    const space::Position place = axis.at(x);
    const double y = -node.sweep - place.y(), z = node.curve - place.z();
    const double cosine = std::cos(twist), sine = std::sin(twist);
    if (!found.blade.station.empty() && !(x > found.blade.station.back()))
      refuse(file, node.line, "BlSpn is beyond the blade's tip, expected one node there at most");
    found.blade.station.push_back(x);
    found.blade.chord.push_back(node.chord);
    const double own = twist - twist_at(beam, x);
    found.blade.twist.push_back(std::abs(own) < rounding ? 0.0 : own);
    found.blade.center.push_back(cosine * y + sine * z);
    found.blade.airfoil.push_back(names[node.airfoil]);
    found.station_from.push_back("BlSpn, " + foreign::place(file, node.line));
    off_chord = std::max(off_chord, std::abs(cosine * z - sine * y));
  }
  found.remarks.emplace_back(
      "twist is -BlTwist in rad less that of the sections; center is what BlCrvAC and -BlSwpAC "
      "are from the blade's axis, along the chord.");
  constexpr double small = 0.01;  // [m]
  if (off_chord > small)
    model.leave_out(Loss::theory, file +
                                      ": what the aerodynamic centre is off the chord through the "
                                      "blade's axis, up to " +
                                      fmt::format("{:.3g} m", off_chord));
}

}  // namespace spoke::foreign
