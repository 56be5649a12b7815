// Cuts the sections of a blade, and shares out its point masses, among its bodies.

#include "models/plane/beam_properties.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace spoke::plane {
namespace {

// A piece shorter than this fraction of its body is a rounded boundary between two bodies.
constexpr double kShortest = 1e-12;

/// Returns the blade's properties between two stations, in the coordinate x of a body that begins
/// at `origin`.
BeamPiece make_piece(const BladeSections& sections, std::size_t first, double origin) {
  const auto pair = [first](const std::vector<double>& property) {
    return std::array{property[first], property[first + 1]};
  };
  return {sections.station[first] - origin, sections.station[first + 1] - origin,
          pair(sections.mass_per_length), pair(sections.axial_stiffness),
          pair(sections.bending_stiffness)};
}

BeamPiece cut(const BeamPiece& piece, double begin, double end) {
  const auto between = [&](const std::array<double, 2>& property) {
    return std::array{begin <= piece.begin ? property[0] : piece.at(property, begin),
                      end >= piece.end ? property[1] : piece.at(property, end)};
  };
  return {begin, end, between(piece.mass_per_length), between(piece.axial_stiffness),
          between(piece.bending_stiffness)};
}

/// Finds the pieces of the body in which its properties are linear, from the inboard to the
/// outboard end.
std::vector<BeamPiece> find_linear_pieces(const Blade& blade, const BeamProperties& beam,
                                          double origin) {
  const BladeSections& sections = blade.sections;
  if (sections.station.empty())
    return {{0.0,
             beam.length,
             {beam.mass_per_length, beam.mass_per_length},
             {beam.axial_stiffness, beam.axial_stiffness},
             {beam.bending_stiffness, beam.bending_stiffness}}};
  std::vector<BeamPiece> pieces;
  const std::vector<double>& station = sections.station;
  const auto beyond = std::upper_bound(station.begin() + 1, station.end() - 1, origin);
  for (auto k = static_cast<std::size_t>(beyond - station.begin() - 1);
       k + 1 < station.size() && station[k] < origin + beam.length; ++k) {
    const BeamPiece piece = make_piece(sections, k, origin);
    const double begin = std::max(piece.begin, 0.0), end = std::min(piece.end, beam.length);
    if (end - begin > kShortest * beam.length) pieces.push_back(cut(piece, begin, end));
  }
  // Rounding must leave no gap at the ends.
  pieces.front().begin = 0.0;
  pieces.back().end = beam.length;
  return pieces;
}

std::vector<BodyMass> find_masses(const Blade& blade, const BeamProperties& beam, int body) {
  std::vector<BodyMass> masses;
  for (const PointMass& point : blade.point_masses) {
    const double bodies_inboard = std::ceil(point.position / beam.length * (1.0 - kShortest)) - 1.0;
    const int owner = std::clamp(static_cast<int>(bodies_inboard), 0, blade.bodies - 1);
    if (owner != body) continue;
    const double x = std::clamp(point.position - body * beam.length, 0.0, beam.length);
    masses.push_back({x, point.mass, point.inertia});
  }
  std::sort(masses.begin(), masses.end());
  return masses;
}

/// Divides pieces at the point masses within them: the tension of a rotating blade jumps there.
std::vector<BeamPiece> divide(const std::vector<BeamPiece>& pieces,
                              const std::vector<BodyMass>& masses, double shortest) {
  std::vector<BeamPiece> divided;
  for (BeamPiece rest : pieces) {
    for (const BodyMass& point : masses) {
      if (point.x - rest.begin <= shortest || rest.end - point.x <= shortest) continue;
      divided.push_back(cut(rest, rest.begin, point.x));
      rest = cut(rest, point.x, rest.end);
    }
    divided.push_back(rest);
  }
  return divided;
}

}  // namespace

bool is_uniform(const Blade& blade) {
  return blade.sections.station.empty() && blade.point_masses.empty();
}

BeamProperties make_beam_properties(const Blade& blade, int body) {
  assert(body >= 0 && body < blade.bodies && blade.elements > 0);
  BeamProperties beam;
  beam.length = blade.length / blade.bodies;
  beam.elements = blade.elements;
  beam.mass_per_length = blade.density * blade.area;
  beam.axial_stiffness = blade.youngs_modulus * blade.area;
  beam.bending_stiffness = blade.youngs_modulus * blade.second_moment;
  beam.reference_frame = blade.reference_frame;
  beam.is_nonlinear = blade.strain == BeamStrain::nonlinear;
  beam.masses = find_masses(blade, beam, body);
  if (blade.sections.station.empty() && beam.masses.empty()) return beam;
  beam.pieces = divide(find_linear_pieces(blade, beam, body * beam.length), beam.masses,
                       kShortest * beam.length);
  return beam;
}

}  // namespace spoke::plane
