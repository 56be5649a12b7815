// Values and integrals of linear pieces.

#include "models/plane/beam_pieces.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace spoke::plane {

bool follow_one_another(const std::vector<BeamPiece>& pieces, double length) {
  double end = 0.0;
  for (const BeamPiece& piece : pieces) {
    // Up to rounding where a piece was divided.
    if (std::abs(piece.begin - end) > 1e-9 * length || piece.end <= piece.begin) return false;
    end = piece.end;
  }
  return pieces.empty() || std::abs(end - length) <= 1e-9 * length;
}

const BeamPiece& piece_at(const std::vector<BeamPiece>& pieces, double x) {
  assert(!pieces.empty());
  const auto beyond =
      std::upper_bound(pieces.begin(), pieces.end(), x,
                       [](double place, const BeamPiece& piece) { return place < piece.begin; });
  return beyond == pieces.begin() ? *beyond : *(beyond - 1);
}

double mean_axial_stiffness(const std::vector<BeamPiece>& pieces, double from, double to) {
  assert(!pieces.empty() && from < to);
  double sum = 0.0;
  for (const BeamPiece& piece : pieces) {
    const double begin = std::max(from, piece.begin), end = std::min(to, piece.end);
    if (begin < end) sum += (end - begin) * piece.at(piece.axial_stiffness, 0.5 * (begin + end));
  }
  return sum / (to - from);
}

double first_moment_beyond(const BeamPiece& piece, double x, double distance) {
  assert(x <= piece.end);
  const auto moment = [&](double xi) {
    return piece.at(piece.mass_per_length, xi) * (distance + xi);
  };
  // Simpson's rule: exact, for both factors are linear.
  const double end = piece.end;
  return (end - x) / 6.0 * (moment(x) + 4.0 * moment(0.5 * (x + end)) + moment(end));
}

double mass_beyond(const BeamPiece& piece, double x) {
  assert(x <= piece.end);
  return (piece.end - x) * piece.at(piece.mass_per_length, 0.5 * (x + piece.end));
}

namespace {

/// Returns for each piece the sum of `of_point` and `of_piece` over all that lies outboard of it.
template <class OfPoint, class OfPiece>
std::vector<double> sum_outboard(const std::vector<BeamPiece>& pieces,
                                 const std::vector<BodyMass>& masses, const OfPoint& of_point,
                                 const OfPiece& of_piece) {
  assert(std::is_sorted(masses.begin(), masses.end(),
                        [](const BodyMass& a, const BodyMass& b) { return a.x < b.x; }));
  std::vector<double> sums(pieces.size());
  auto point = masses.rbegin();
  double sum = 0.0;
  for (std::size_t k = pieces.size(); k-- > 0;) {
    const BeamPiece& piece = pieces[k];
    // The middle of the piece tells on which side a mass lies, whatever rounding did at the end.
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

}  // namespace spoke::plane
