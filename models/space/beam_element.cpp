// Integrals along an element, by Gauss's rule between neighbouring breaks of the beam.

#include "models/space/beam_element.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <functional>

#include "models/support/gauss_rule.h"

namespace spoke::space {
namespace {

using Matrix6 = Eigen::Matrix<double, kTwist, kTwist>;
using Slots = Eigen::Matrix<double, kElementSlots, 1>;

/// A piece of the beam in B, so short that its middle stands for it.
struct Slice {
  double station = 0.0;  ///< [m]
  double ds = 0.0;       ///< length along the curve [m]
  Position p;            ///< place of its reference point [m]
  Matrix3 axes;          ///< axes of its section
  SectionMatrices section;
};

Slice make_slice(const Beam& beam, const BodyGeometry& geometry, double station, double dx) {
  const SectionAt at = beam.geometry(station);
  const Rotation to_body = geometry.pose.R.inverse();
  return {station, at.tangent.norm() * dx, to_body * Position(at.p - geometry.pose.p),
          (to_body * at.axes).axes, beam.section(station)};
}

/// Calls `visit(slice)` for the Gauss points between two stations without a break between them.
template <class Visit>
void visit_slices(const Beam& beam, const BodyGeometry& geometry, double from, double to,
                  Visit&& visit) {
  for (int i = 0; i < GaussRule<6>::kPoints; ++i)
    visit(make_slice(beam, geometry, from + GaussRule<6>::places[i] * (to - from),
                     GaussRule<6>::weights[i] * (to - from)));
}

/// Makes a slice of a point mass in B, without anything but mass.
Slice make_slice(const Beam& beam, const BodyGeometry& geometry, const PointMass& point) {
  Slice slice = make_slice(beam, geometry, point.station, 0.0);
  slice.ds = 1.0;
  slice.section = {};
  slice.section.mass = point.moments;
  return slice;
}

/// Whether a point mass lies between two stations, or at the second.
bool is_outboard(double from, double to, const PointMass& point) {
  const double rounding = 1e-12 * (to - from);
  return point.station > from + rounding && point.station <= to + rounding;
}

/// Whether a point mass belongs to the part between two stations; at a boundary, it belongs to the
/// inboard part.
bool holds(const Beam& beam, double from, double to, const PointMass& point) {
  const bool is_at_start = from == beam.station.front() && point.station <= from;
  return is_at_start || is_outboard(from, to, point);
}

/// Mass and its first moment along the body's axis beyond a station, within the body.
struct MassOutboard {
  double mass = 0.0;          ///< [kg]
  double first_moment = 0.0;  ///< [kg m]

  void add(const Slice& slice) {
    const double dm = slice.ds * slice.section.mass.mass;
    mass += dm;
    first_moment += dm * slice.p.x();
  }
};

class MassDistribution {
 public:
  MassDistribution(const Beam& beam, const BodyGeometry& geometry)
      : beam_(beam),
        geometry_(geometry),
        breaks_(beam.breaks(geometry.station.front(), geometry.station.back())),
        beyond_(breaks_.size()),
        at_end_(breaks_.size()) {
    for (std::size_t k = breaks_.size() - 1; k-- > 0;) {
      at_end_[k] = beyond_[k + 1];
      add_masses(breaks_[k], breaks_[k + 1], at_end_[k]);
      beyond_[k] = at_end_[k];
      visit_slices(beam, geometry, breaks_[k], breaks_[k + 1],
                   [&](const Slice& slice) { beyond_[k].add(slice); });
    }
  }

  /// Returns the mass beyond a station between two breaks.
  MassOutboard beyond(double station) const {
    std::size_t k = 0;
    while (k + 2 < breaks_.size() && breaks_[k + 1] <= station) ++k;
    MassOutboard sum = at_end_[k];
    visit_slices(beam_, geometry_, station, breaks_[k + 1],
                 [&](const Slice& slice) { sum.add(slice); });
    return sum;
  }

 private:
  void add_masses(double from, double to, MassOutboard& sum) const {
    for (const PointMass& point : beam_.masses)
      if (is_outboard(from, to, point)) sum.add(make_slice(beam_, geometry_, point));
  }

  const Beam& beam_;
  const BodyGeometry& geometry_;
  std::vector<double> breaks_;
  std::vector<MassOutboard> beyond_;  ///< mass from a break on, less the point masses at it
  std::vector<MassOutboard> at_end_;  ///< mass beyond a piece, the point masses at its end included
};

/// Returns W: resultants of a section, in its axes, per wrench on the outer node.
Matrix6 resultants_of(const Slice& slice, const Position& outer) {
  const Matrix3 axes = slice.axes.transpose();
  Matrix6 W = Matrix6::Zero();
  W.topLeftCorner<3, 3>() = axes;
  W.bottomLeftCorner<3, 3>() = axes * skew(outer - slice.p);
  W.bottomRightCorner<3, 3>() = axes;
  return W;
}

/// A slice's mass within an element: its place along the chord, and its moments about that place in
/// the element's axes.
struct PlacedMass {
  double xi;  ///< 0 at the inner node, 1 at the outer
  MassMoments moments;
};

PlacedMass place(const BeamElement& element, const Position& inner, const Slice& slice) {
  const double xi = element.axes.col(0).dot(slice.p - inner) / element.length;
  const Matrix3 to_element = element.axes.transpose();
  const Matrix3 A = to_element * slice.axes;
  const Position o = to_element * (slice.p - inner - xi * element.chord);
  const MassMoments& section = slice.section.mass;
  const Position S = A * section.first;
  const double dm = slice.ds * section.mass;
  return {xi,
          {dm, slice.ds * S + dm * o,
           slice.ds * (A * section.second * A.transpose() + o * S.transpose() + S * o.transpose()) +
               dm * o * o.transpose()}};
}

/// Puts values for (r, t) of both nodes among the slots of an element.
Slots spread(const Eigen::Vector4d& shape) {
  Slots slots = Slots::Zero();
  slots.segment<2>(0) = shape.head<2>();
  slots.segment<2>(kNodeSlots) = shape.tail<2>();
  return slots;
}

/// Returns the shape that is linear from node to node, for one slot.
Slots linear_on(int slot, double xi) {
  Slots slots = Slots::Zero();
  slots[slot] = 1.0 - xi;
  slots[kNodeSlots + slot] = xi;
  return slots;
}

/// Adds to m: dm [m h h^T + sum S_a (h n_a^T + n_a h^T) + sum P_ab n_a n_b^T].
void add_mass(const PlacedMass& dm, double length, SlotMatrix& m) {
  const Slots h = spread(hermite(dm.xi, length));
  Eigen::Matrix<double, kElementSlots, 3> n;
  n << spread(hermite_slope(dm.xi, length)), linear_on(2, dm.xi), linear_on(3, dm.xi);
  const Slots nS = n * dm.moments.first;
  m += dm.moments.mass * h * h.transpose() + h * nS.transpose() + nS * h.transpose() +
       n * dm.moments.second * n.transpose();
}

void add_tension(const BeamElement& element, const Slice& slice, double xi,
                 const MassOutboard& outboard, ElementStiffening& stiffening) {
  const Eigen::Vector4d slope = hermite_slope(xi, element.length);
  const std::array weights{1.0, outboard.mass, outboard.first_moment};
  for (std::size_t k = 0; k < weights.size(); ++k) {
    stiffening.bending[k] += (slice.ds * weights[k]) * slope * slope.transpose();
    stiffening.torsion[k] +=
        slice.ds * weights[k] * slice.section.gyration / (element.length * element.length);
  }
}

void add_propeller(const PlacedMass& dm, ElementStiffening& stiffening) {
  const Matrix3& P = dm.moments.second;
  const std::array moments{P(1, 1), P(1, 2), P(2, 2)};
  for (std::size_t k = 0; k < moments.size(); ++k) {
    std::array<double, 3>& entries = stiffening.propeller[k];
    entries[0] += moments[k] * (1.0 - dm.xi) * (1.0 - dm.xi);
    entries[1] += moments[k] * (1.0 - dm.xi) * dm.xi;
    entries[2] += moments[k] * dm.xi * dm.xi;
  }
}

void add_point_mass(const PlacedMass& dm, BeamElement& element) {
  add_mass(dm, element.length, element.mass);
  if (dm.moments.second.isZero(0.0)) return;
  element.inertias.push_back({section_rotation(element, dm.xi),
                              element.axes * dm.moments.second * element.axes.transpose()});
}

/// Makes an element of the right geometry, its integrals still zero.
BeamElement make_empty_element(const Position& inner, const Position& outer) {
  assert(outer != inner);
  BeamElement element;
  element.chord = outer - inner;
  element.length = element.chord.norm();
  element.axes = smallest_rotation(Position::UnitX(), element.chord / element.length).axes;
  element.mass.setZero();
  for (Matrix4& matrix : element.stiffening.bending) matrix.setZero();
  return element;
}

struct Flexibility {
  Matrix6 elastic = Matrix6::Zero();
  Matrix6 damping = Matrix6::Zero();

  void add(const Slice& slice, const Position& outer, const Twist& factors) {
    const Matrix6 W = resultants_of(slice, outer);
    const TwistMatrix& F = slice.section.compliance;
    elastic += slice.ds * W.transpose() * F * W;
    if (!factors.isZero(0.0))
      damping += slice.ds * W.transpose() * damped_compliance(F, factors) * W;
  }
};

BeamElement make_element(const Beam& beam, const BodyGeometry& geometry,
                         const MassDistribution& distribution, std::size_t e) {
  const Position &inner = geometry.nodes[e], &outer = geometry.nodes[e + 1];
  BeamElement element = make_empty_element(inner, outer);
  Flexibility flexibility;
  const double from = geometry.station[e], to = geometry.station[e + 1];
  const std::vector<double> breaks = beam.breaks(from, to);
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
    visit_slices(beam, geometry, breaks[k], breaks[k + 1], [&](const Slice& slice) {
      flexibility.add(slice, outer, beam.damping);
      const PlacedMass dm = place(element, inner, slice);
      add_mass(dm, element.length, element.mass);
      add_propeller(dm, element.stiffening);
      add_tension(element, slice, dm.xi, distribution.beyond(slice.station), element.stiffening);
    });
  for (const PointMass& point : beam.masses)
    if (holds(beam, from, to, point))
      add_point_mass(place(element, inner, make_slice(beam, geometry, point)), element);
  const Matrix6 stiffness = flexibility.elastic.llt().solve(Matrix6::Identity());
  element.stiffness = 0.5 * (stiffness + stiffness.transpose());
  const Matrix6 damping = stiffness * flexibility.damping * stiffness;
  element.damping =
      0.5 * (damping + damping.transpose()) + beam.stiffness_damping * element.stiffness;
  return element;
}

}  // namespace

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

std::vector<BeamElement> make_beam_elements(const Beam& beam, const BodyGeometry& geometry) {
  const MassDistribution distribution(beam, geometry);
  std::vector<BeamElement> elements;
  for (std::size_t e = 0; e + 1 < geometry.nodes.size(); ++e)
    elements.push_back(make_element(beam, geometry, distribution, e));
  return elements;
}

SlotMatrix calc_outboard_mass(const Beam& beam, const BodyGeometry& geometry,
                              const BeamElement& element, std::size_t e, double station) {
  assert(e + 1 < geometry.nodes.size() && geometry.station.size() == geometry.nodes.size());
  const Position& inner = geometry.nodes[e];
  const double from = geometry.station[e], to = geometry.station[e + 1];
  const double rounding = 1e-9 * (to - from);
  SlotMatrix mass = SlotMatrix::Zero();
  const auto add = [&](const Slice& slice) {
    add_mass(place(element, inner, slice), element.length, mass);
  };
  if (station < to - rounding) {
    const std::vector<double> breaks = beam.breaks(std::max(station, from), to);
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
      visit_slices(beam, geometry, breaks[k], breaks[k + 1], add);
  }
  for (const PointMass& point : beam.masses)
    if (holds(beam, from, to, point) && point.station >= station - rounding)
      add(make_slice(beam, geometry, point));
  return mass;
}

}  // namespace spoke::space
