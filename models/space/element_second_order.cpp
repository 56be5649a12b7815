// Integrates products of first-order rotations along an element, the inner integrals by the
// polynomial through the points of the outer rule.

#include "models/space/element_second_order.h"

#include <Eigen/Dense>
#include <cassert>

#include "models/space/beam_slice.h"

namespace spoke::space {
namespace {

constexpr int kPoints = SliceRule::kPoints;
using Columns = Eigen::Matrix<double, 3, kTwist>;  ///< a vector per d
using Square = Eigen::Matrix<double, kTwist, kTwist>;
using QuadraticForms = std::array<Square, 3>;  ///< a vector, quadratic in d; not symmetric
using PointMatrix = Eigen::Matrix<double, kPoints, kPoints>;

/// Returns the integrals from 0 to each point of the polynomials that are one at a point and zero
/// at the others.
PointMatrix make_inner_integrals() {
  PointMatrix powers, integrals;
  for (int i = 0; i < kPoints; ++i) {
    double power = 1.0;
    for (int k = 0; k < kPoints; ++k) {
      powers(i, k) = power;
      power *= SliceRule::places[static_cast<std::size_t>(i)];
      integrals(i, k) = power / (k + 1);
    }
  }
  return integrals * powers.fullPivLu().inverse();
}

QuadraticForms zero_forms() { return {Square::Zero(), Square::Zero(), Square::Zero()}; }

/// Adds factor a x b, both linear in d.
void add_cross(double factor, const Columns& a, const Columns& b, QuadraticForms& sum) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    sum[static_cast<std::size_t>(i)] +=
        factor * (a.row(j).transpose() * b.row(k) - a.row(k).transpose() * b.row(j));
  }
}
void add_scaled(double factor, const QuadraticForms& forms, QuadraticForms& sum) {
  for (std::size_t i = 0; i < 3; ++i) sum[i] += factor * forms[i];
}
/// Adds factor a x t, with a quadratic in d.
void add_cross(double factor, const QuadraticForms& a, const Position& t, QuadraticForms& sum) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    sum[i] +=
        factor * (t[static_cast<Eigen::Index>(k)] * a[j] - t[static_cast<Eigen::Index>(j)] * a[k]);
  }
}

/// Strains at the points of a piece, per d and per length of the unit interval.
struct PieceStrains {
  std::array<Columns, kPoints> k, g;
  std::array<Position, kPoints> t;
};

PieceStrains find_strains(const Beam& beam, const BodyGeometry& geometry,
                          const BeamElement& element, const Position& outer, double from,
                          double to) {
  PieceStrains strains;
  std::size_t i = 0;
  visit_slices(beam, geometry, from, to, [&](const Slice& slice) {
    const double ds = slice.ds / SliceRule::weights[i];
    const Square by_d = slice.section.compliance * resultants_of(slice, outer) * element.stiffness;
    strains.g[i] = ds * slice.axes * by_d.topRows<3>();
    strains.k[i] = ds * slice.axes * by_d.bottomRows<3>();
    strains.t[i] = ds * slice.axes.col(0);
    ++i;
  });
  return strains;
}

/// Sums a and c of an element, piece by piece.
class Sums {
 public:
  void add(const PieceStrains& at) {
    static const PointMatrix inner = make_inner_integrals();
    std::array<Columns, kPoints> del;
    std::array<QuadraticForms, kPoints> turning;
    const Columns del_before = del_;
    const QuadraticForms al_before = al_;
    for (std::size_t i = 0; i < kPoints; ++i) {
      del[i] = del_before;
      for (std::size_t j = 0; j < kPoints; ++j) del[i] += share(inner, i, j) * at.k[j];
      turning[i] = zero_forms();
      add_cross(0.5, del[i], at.k[i], turning[i]);
    }
    for (std::size_t i = 0; i < kPoints; ++i) {
      const double weight = SliceRule::weights[i];
      QuadraticForms al = al_before;
      for (std::size_t j = 0; j < kPoints; ++j) add_scaled(share(inner, i, j), turning[j], al);
      add_cross(weight, al, at.t[i], c);
      Columns leaned;
      for (int column = 0; column < kTwist; ++column)
        leaned.col(column) = cross(del[i].col(column), at.t[i]);
      add_cross(0.5 * weight, del[i], leaned, c);
      add_cross(weight, del[i], at.g[i], c);
      del_ += weight * at.k[i];
      add_scaled(weight, turning[i], al_);
    }
  }

  QuadraticForms c = zero_forms();
  const QuadraticForms& a() const { return al_; }

 private:
  static double share(const PointMatrix& inner, std::size_t i, std::size_t j) {
    return inner(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
  }

  Columns del_ = Columns::Zero();
  QuadraticForms al_ = zero_forms();
};

/// Adds what the twist of a slice's section draws out under tension: 1/2 gyration (twist')^2 along
/// the chord, which the place of the end is short of.
double add_wagner(const BeamElement& element, const Slice& slice) {
  return slice.ds * gyration_about_shear_centre(slice.section) / (element.length * element.length);
}

/// Returns the second moment of a mass about its centre, in B.
Matrix3 find_central_moment(const PlacedMass& dm, const BeamElement& element) {
  const Position& S = dm.moments.first;
  const Matrix3 P = dm.moments.second - S * S.transpose() / dm.moments.mass;
  return element.axes * P * element.axes.transpose();
}

/// Adds a small mass.
void add_inertia(const PlacedMass& dm, const BeamElement& element, ElementSecondOrder& second) {
  if (!dm.moments.second.isZero(0.0))
    second.inertias.push_back({section_rotation(element, dm.xi), find_central_moment(dm, element)});
}

/// Adds the share of a slice.
void add_turning(const PlacedMass& dm, const BeamElement& element, ElementSecondOrder& second) {
  const Matrix3 in_B = find_central_moment(dm, element);
  second.turning += 0.5 * (in_B + in_B.transpose());
}

ElementSecondOrder make_element(const Beam& beam, const BodyGeometry& geometry,
                                const BeamElement& element, std::size_t e) {
  const Position &inner = geometry.nodes[e], &outer = geometry.nodes[e + 1];
  const double from = geometry.station[e], to = geometry.station[e + 1];
  const std::vector<double> breaks = beam.breaks(from, to);
  ElementSecondOrder second;
  Sums sums;
  double wagner = 0.0;
  for (std::size_t p = 0; p + 1 < breaks.size(); ++p) {
    sums.add(find_strains(beam, geometry, element, outer, breaks[p], breaks[p + 1]));
    visit_slices(beam, geometry, breaks[p], breaks[p + 1], [&](const Slice& slice) {
      wagner += add_wagner(element, slice);
      add_turning(place(element, inner, slice), element, second);
    });
  }
  for (const PointMass& point : beam.masses)
    if (holds(beam, from, to, point))
      add_inertia(place(element, inner, make_slice(beam, geometry, point)), element, second);
  const Position e1 = element.axes.col(0);
  for (std::size_t i = 0; i < 3; ++i) {
    const Square& a = sums.a()[i];
    Square c = sums.c[i];
    c.bottomRightCorner<3, 3>() -=
        0.5 * wagner * e1[static_cast<Eigen::Index>(i)] * e1 * e1.transpose();
    second.rotation[i] = a + a.transpose();
    second.place[i] = c + c.transpose();
  }
  return second;
}

}  // namespace

std::vector<ElementSecondOrder> make_second_order(const Beam& beam, const BodyGeometry& geometry,
                                                  const std::vector<BeamElement>& elements) {
  assert(geometry.nodes.size() == elements.size() + 1);
  std::vector<ElementSecondOrder> second;
  for (std::size_t e = 0; e < elements.size(); ++e)
    second.push_back(make_element(beam, geometry, elements[e], e));
  return second;
}

}  // namespace spoke::space
