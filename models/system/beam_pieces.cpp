// Values and integrals of linear pieces.

#include "models/system/beam_pieces.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace spoke {

const BeamPiece& piece_at(const std::vector<BeamPiece>& pieces, double x) {
  assert(!pieces.empty());
  const auto beyond =
      std::upper_bound(pieces.begin(), pieces.end(), x,
                       [](double place, const BeamPiece& piece) { return place < piece.begin; });
  return beyond == pieces.begin() ? *beyond : *(beyond - 1);
}

double mean_axial_stiffness(const std::vector<BeamPiece>& pieces, double from, double to) {
  double sum = 0.0;
  for (const BeamPiece& piece : pieces) {
    const double begin = std::max(from, piece.begin), end = std::min(to, piece.end);
    if (begin < end) sum += (end - begin) * piece.at(piece.axial_stiffness, 0.5 * (begin + end));
  }
  return sum / (to - from);
}

double first_moment_beyond(const BeamPiece& piece, double x, double distance) {
  const auto moment = [&](double xi) {
    return piece.at(piece.mass_per_length, xi) * (distance + xi);
  };
  // Simpson's rule: exact, for both factors are linear.
  const double end = piece.end;
  return (end - x) / 6.0 * (moment(x) + 4.0 * moment(0.5 * (x + end)) + moment(end));
}

double mass_beyond(const BeamPiece& piece, double x) {
  return (piece.end - x) * piece.at(piece.mass_per_length, 0.5 * (x + piece.end));
}

namespace {

/// For each piece, the sum of what `of_point` and `of_piece` say of all that lies outboard of it.
template <class OfPoint, class OfPiece>
std::vector<double> sum_outboard(const std::vector<BeamPiece>& pieces,
                                 const std::vector<BodyMass>& masses, const OfPoint& of_point,
                                 const OfPiece& of_piece) {
  std::vector<double> sums(pieces.size());
  auto point = masses.rbegin();
  double sum = 0.0;
  for (std::size_t k = pieces.size(); k-- > 0;) {
    const BeamPiece& piece = pieces[k];
    // Up to rounding at its end: the middle of the piece tells on which side.
    for (; point != masses.rend() && point->x > 0.5 * (piece.begin + piece.end); ++point)
      sum += of_point(*point);
    sums[k] = sum;
    sum += of_piece(piece);
  }
  return sums;
}

}  // namespace

std::vector<double> masses_outboard(const std::vector<BeamPiece>& pieces,
                                    const std::vector<BodyMass>& masses) {
  return sum_outboard(
      pieces, masses, [](const BodyMass& point) { return point.mass; },
      [](const BeamPiece& piece) { return mass_beyond(piece, piece.begin); });
}

std::vector<double> first_moments_outboard(const std::vector<BeamPiece>& pieces,
                                           const std::vector<BodyMass>& masses, double distance) {
  return sum_outboard(
      pieces, masses,
      [distance](const BodyMass& point) { return point.mass * (distance + point.x); },
      [distance](const BeamPiece& piece) {
        return first_moment_beyond(piece, piece.begin, distance);
      });
}

}  // namespace spoke
