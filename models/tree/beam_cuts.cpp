// Cuts a beam at its joints, into bodies, and these into elements.

#include "models/tree/beam_cuts.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace spoke::spatial {
namespace {

constexpr double kSlack = 1e-9;

/// begin + (end - begin) k/count, its ends exact.
double place_of(double begin, double end, int k, int count) {
  if (k == count) return end;
  return begin + (end - begin) * k / count;
}

/// Adds the places that divide an interval into `count` equal parts, without its beginning.
void divide(double begin, double end, int count, std::vector<double>& places) {
  for (int k = 1; k <= count; ++k) places.push_back(place_of(begin, end, k, count));
}

/// Returns the ends of all bodies.
std::vector<double> cut_bodies(const Beam& beam, std::vector<double> joints) {
  assert(beam.length > 0.0 && beam.bodies > 0);
  std::erase_if(joints, [&](double x) { return x <= resolution_of(beam); });
  joints.push_back(beam.length);
  const double longest = beam.length / beam.bodies;
  std::vector<double> ends = {0.0};
  for (const double joint : joints) {
    const double begin = ends.back();
    const int count = std::max(1, static_cast<int>(std::ceil((joint - begin) / longest - kSlack)));
    divide(begin, joint, count, ends);
  }
  return ends;
}

/// Returns the nodes of one body, with as many elements as asked for, shared out among the
/// intervals between places by their lengths, one or more to each.
std::vector<double> make_nodes(double begin, double end, int elements,
                               const std::vector<double>& places, double resolution) {
  std::vector<double> breaks = {begin};
  for (const double place : places)
    if (place > breaks.back() + resolution && place < end - resolution) breaks.push_back(place);
  breaks.push_back(end);
  std::vector<double> nodes = {begin};
  const auto intervals = static_cast<int>(breaks.size()) - 1;
  int left = std::max(elements, intervals);  // elements that are not placed yet
  for (int i = 0; i < intervals; ++i) {
    const double from = breaks[static_cast<std::size_t>(i)];
    const double to = breaks[static_cast<std::size_t>(i) + 1];
    const int others = intervals - 1 - i;
    const int share = static_cast<int>(std::lround(left * (to - from) / (end - from)));
    const int count = others == 0 ? left : std::clamp(share, 1, left - others);
    divide(from, to, count, nodes);
    left -= count;
  }
  return nodes;
}

}  // namespace

double resolution_of(const Beam& beam) { return kSlack * beam.length; }

std::vector<std::vector<double>> cut_beam(const Beam& beam, const std::vector<double>& joints,
                                          const std::vector<double>& places) {
  std::vector<double> all = places;
  std::sort(all.begin(), all.end());
  const std::vector<double> ends = cut_bodies(beam, joints);
  std::vector<std::vector<double>> bodies;
  for (std::size_t i = 1; i < ends.size(); ++i)
    bodies.push_back(make_nodes(ends[i - 1], ends[i], beam.elements, all, resolution_of(beam)));
  return bodies;
}

}  // namespace spoke::spatial
