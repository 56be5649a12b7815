// Integrals along an element, by Gauss's rule between neighbouring breaks of the beam.

#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <functional>

#include "models/space/beam_element.h"
#include "models/space/beam_slice.h"

namespace spoke::space {
namespace {

using Slots = Eigen::Matrix<double, kElementSlots, 1>;

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

void add_turning(const PlacedMass& dm, BeamElement& element) {
  const auto across = element.axes.rightCols<2>();
  element.stiffening.turning +=
      across * dm.moments.second.bottomRightCorner<2, 2>() * across.transpose();
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
      add_turning(dm, element);
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
