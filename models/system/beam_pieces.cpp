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

std::vector<double> first_moments_outboard(const std::vector<BeamPiece>& pieces,
                                           const std::vector<BodyMass>& masses, double distance) {
  std::vector<double> moments(pieces.size());
  auto point = masses.rbegin();
  double sum = 0.0;
  for (std::size_t k = pieces.size(); k-- > 0;) {
    const BeamPiece& piece = pieces[k];
    // Up to rounding at its end: the middle of the piece tells on which side.
    for (; point != masses.rend() && point->x > 0.5 * (piece.begin + piece.end); ++point)
      sum += point->mass * (distance + point->x);
    moments[k] = sum;
    sum += first_moment_beyond(piece, piece.begin, distance);
  }
  return moments;
}

}  // namespace spoke
