// Shapes of an element, and where a body lies on its beam.

#include "models/space/beam_element.h"

#include <algorithm>
#include <cassert>
#include <functional>

namespace spoke::space {

Eigen::Vector4d hermite(double xi, double length) {
  const double xi2 = xi * xi, xi3 = xi2 * xi;
  return {1.0 - 3.0 * xi2 + 2.0 * xi3, length * (xi - 2.0 * xi2 + xi3), 3.0 * xi2 - 2.0 * xi3,
          length * (xi3 - xi2)};
}

Eigen::Vector4d hermite_slope(double xi, double length) {
  const double xi2 = xi * xi;
  return {6.0 * (xi2 - xi) / length, 1.0 - 4.0 * xi + 3.0 * xi2, 6.0 * (xi - xi2) / length,
          3.0 * xi2 - 2.0 * xi};
}

ElementShape to_body(const BeamElement& element, const ElementShape& local) {
  ElementShape shape = element.axes * local;
  for (int block = 0; block < 4; ++block)
    shape.middleCols<3>(3 * block) =
        (shape.middleCols<3>(3 * block) * element.axes.transpose()).eval();
  return shape;
}

ElementShape section_rotation(const BeamElement& element, double xi) {
  const Eigen::Vector4d slope = hermite_slope(xi, element.length);
  ElementShape N = ElementShape::Zero();
  for (int node = 0; node < 2; ++node) {
    const int u = kTwist * node, th = u + kRotation;
    N(0, th) = node == 0 ? 1.0 - xi : xi;
    N(2, u + 1) = slope[2 * node];  // tz = v', ty = -w'
    N(1, u + 2) = -slope[2 * node];
    N(1, th + 1) = N(2, th + 2) = slope[2 * node + 1];
  }
  return to_body(element, N);
}

BodyGeometry make_body_geometry(const Beam& beam, std::vector<double> stations) {
  assert(stations.size() > 1);
  assert(std::adjacent_find(stations.begin(), stations.end(), std::greater_equal<>()) ==
         stations.end());
  BodyGeometry geometry;
  const Position first = beam.curve.at(stations.front());
  const Position last = beam.curve.at(stations.back());
  geometry.pose = {first, smallest_rotation(Position::UnitX(), (last - first).normalized())};
  for (const double x : stations)
    geometry.nodes.push_back(geometry.pose.R.inverse() * Position(beam.curve.at(x) - first));
  geometry.station = std::move(stations);
  return geometry;
}

}  // namespace spoke::space
