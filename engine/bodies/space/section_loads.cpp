// Calculates the motion of four sections at a time, and the sums of a load's effects there.

#include "engine/bodies/space/section_loads.h"

#include <algorithm>
#include <cassert>

#include "engine/bodies/space/lanes.h"
#include "models/space/rotation_series.h"
#include "models/support/wide_kernels.h"

namespace spoke::space {
namespace {

/// Three components, at four sections.
struct Quad {
  Double4 x{}, y{}, z{};

  [[gnu::always_inline]] static Quad from(const Lanes* rows) {
    return {lanes(rows[0]), lanes(rows[1]), lanes(rows[2])};
  }
  /// Returns one vector at all of them.
  [[gnu::always_inline]] static Quad same(const Position& p) {
    const Double4 zero{};
    return {p.x() + zero, p.y() + zero, p.z() + zero};
  }
};

[[gnu::always_inline]] inline Quad operator+(const Quad& a, const Quad& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class Factor>
[[gnu::always_inline]] inline Quad operator*(const Factor& k, const Quad& a) {
  return {k * a.x, k * a.y, k * a.z};
}
[[gnu::always_inline]] inline Quad cross(const Quad& a, const Quad& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// Returns R b, of one matrix.
[[gnu::always_inline]] inline Quad turn_all(const Matrix3& R, const Quad& b) {
  return {R(0, 0) * b.x + R(0, 1) * b.y + R(0, 2) * b.z,
          R(1, 0) * b.x + R(1, 1) * b.y + R(1, 2) * b.z,
          R(2, 0) * b.x + R(2, 1) * b.y + R(2, 2) * b.z};
}

/// Returns, by value, the sum over the four sections.
[[gnu::always_inline]] inline Double4 totals(const Double4& a, const Double4& b, const Double4& c,
                                             const Double4& d) {
  const Double4 ab =
      __builtin_shufflevector(a, b, 0, 4, 2, 6) + __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Double4 cd =
      __builtin_shufflevector(c, d, 0, 4, 2, 6) + __builtin_shufflevector(c, d, 1, 5, 3, 7);
  return __builtin_shufflevector(ab, cd, 0, 1, 4, 5) + __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
}

/// Rotations of four sections: exp(th~) and its tangent map H, by their coefficients.
struct SectionTurns {
  Quad theta;
  Double4 s, c, d;

  [[gnu::always_inline]] explicit SectionTurns(const Quad& rotation) : theta(rotation) {
    const Double4 x = theta.x * theta.x + theta.y * theta.y + theta.z * theta.z;
    if (std::max(std::max(x[0], x[1]), std::max(x[2], x[3])) < 1.0) {
      d = sum_series(kDSeries, x);
      s = 1.0 - x * d;
      c = 3.0 * d + x * sum_series(kDRateSeries, x);
      return;
    }
    for (int i = 0; i < 4; ++i) {
      const RotationCoefficients k = calc_rotation_coefficients(x[i]);
      s[i] = k.s;
      c[i] = k.c;
      d[i] = k.d;
    }
  }
  /// Returns v + a th x v + b th x (th x v).
  [[gnu::always_inline]] Quad combine(const Double4& a, const Double4& b, const Quad& v) const {
    const Quad once = cross(theta, v);
    return v + a * once + b * cross(theta, once);
  }
  [[gnu::always_inline]] Quad turn(const Quad& v) const { return combine(s, c, v); }
  [[gnu::always_inline]] Quad tangent_transposed(const Quad& v) const { return combine(-c, d, v); }
};

/// Resolve a vector along the axes of an element, and back.
Position to_axes(const BeamElement& element, bool is_straight, const Position& v) {
  return is_straight ? v : Position(element.axes.transpose().lazyProduct(v));
}
Position from_axes(const BeamElement& element, bool is_straight, const Position& v) {
  return is_straight ? v : Position(element.axes.lazyProduct(v));
}

/// Coordinates of an element's nodes along its axes.
struct NodeCoordinates {
  Position u[2], th[2];

  NodeCoordinates(const FlexibleBody& body, const BeamElement& element, const double* nodal) {
    for (int node = 0; node < 2; ++node, nodal += kTwist) {
      u[node] = to_axes(element, body.is_straight, {nodal[0], nodal[1], nodal[2]});
      th[node] = to_axes(element, body.is_straight, {nodal[3], nodal[4], nodal[5]});
    }
  }

  [[gnu::always_inline]] Quad rotation(const LoadedSections& at) const {
    const Double4 slope = lanes(at.rise_slope), inner = lanes(at.slope[0]),
                  outer = lanes(at.slope[1]);
    return {th[0].x() + (th[1].x() - th[0].x()) * lanes(at.along),
            inner * th[0].y() + outer * th[1].y() - (u[1].z() - u[0].z()) * slope,
            inner * th[0].z() + outer * th[1].z() + (u[1].y() - u[0].y()) * slope};
  }
  /// Returns the places of the sections.
  [[gnu::always_inline]] Quad place(const LoadedSections& at) const {
    const Double4 rise = lanes(at.rise), inner = lanes(at.tangent[0]), outer = lanes(at.tangent[1]);
    const Double4 along = lanes(at.along), y = lanes(at.offset[0]), z = lanes(at.offset[1]);
    const Position du = u[1] - u[0], dth = th[1] - th[0];
    const Quad between{th[0].x() + dth.x() * along, th[0].y() + dth.y() * along,
                       th[0].z() + dth.z() * along};
    return Quad::from(at.place.data()) +
           Quad{u[0].x() + du.x() * lanes(at.stretch) + (z * between.y - y * between.z),
                u[0].y() + du.y() * rise + (inner * th[0].z() + outer * th[1].z()) - z * between.x,
                u[0].z() + du.z() * rise - (inner * th[0].y() + outer * th[1].y()) + y * between.x};
  }
};

/// Force and moment at four sections, along the axes of their element.
struct QuadWrench {
  Quad force;
  Quad moment{};
  Quad on_rotation{};  ///< H^T moment, on the rotation vectors
};

/// Returns a vector of the load at each section, times its weight, before the section has turned.
[[gnu::always_inline]] inline Quad spread(const LoadedSections& at, bool follows, bool is_straight,
                                          const BeamElement& element, const Position& v) {
  const Double4 weight = lanes(at.weight);
  if (!follows) return weight * Quad::same(to_axes(element, is_straight, v));
  return weight * (v[0] * Quad::from(&at.axes[0]) + v[1] * Quad::from(&at.axes[3]) +
                   v[2] * Quad::from(&at.axes[6]));
}

[[gnu::always_inline]] inline QuadWrench calc_wrench(const LoadedSections& at,
                                                     const LoadInstant& load, bool is_straight,
                                                     const BeamElement& element,
                                                     const NodeCoordinates& x) {
  const Quad force = spread(at, load.follows, is_straight, element, linear(load.wrench));
  const bool has_moment = !angular(load.wrench).isZero(0.0);
  if (!load.follows && !has_moment) return {force};
  const SectionTurns turns(x.rotation(at));
  QuadWrench wrench{load.follows ? turns.turn(force) : force};
  if (!has_moment) return wrench;
  const Quad moment = spread(at, load.follows, is_straight, element, angular(load.wrench));
  wrench.moment = load.follows ? turns.turn(moment) : moment;
  wrench.on_rotation = turns.tangent_transposed(wrench.moment);
  return wrench;
}

/// Sums of wrenches at four sections, by the frame and the nodes of an element, along its axes.
struct LoadedElement {
  Position force, moment;      ///< on the frame, the moment about its origin
  Position u[2], rotation[2];  ///< by node
};

/// Applies the transpose of NodeCoordinates::place() and rotation().
[[gnu::always_inline]] inline LoadedElement sum_forces(const LoadedSections& at,
                                                       const NodeCoordinates& x,
                                                       const QuadWrench& wrench) {
  const Quad &f = wrench.force, &h = wrench.on_rotation;
  const Quad arm = cross(x.place(at), f);
  const Double4 along = lanes(at.along), y = lanes(at.offset[0]), z = lanes(at.offset[1]);
  const Double4 rise = lanes(at.rise), rise_slope = lanes(at.rise_slope);
  const Double4 about_x = y * f.z - z * f.y + h.x, about_y = z * f.x, about_z = -y * f.x;
  Quad node[2];  // about y and z, by node
  for (int n = 0; n < 2; ++n) {
    const Double4 share = n == 0 ? 1.0 - along : along;
    const Double4 tangent = lanes(at.tangent[n]), slope = lanes(at.slope[n]);
    node[n].y = share * about_y - tangent * f.z + slope * h.y;
    node[n].z = share * about_z + tangent * f.y + slope * h.z;
  }
  const Double4 frame = totals(f.x, f.y, f.z, about_x);
  const Double4 turn = totals(arm.x + wrench.moment.x, arm.y + wrench.moment.y,
                              arm.z + wrench.moment.z, along * about_x);
  const Double4 outer = totals(lanes(at.stretch) * f.x, rise * f.y + rise_slope * h.z,
                               rise * f.z - rise_slope * h.y, Double4{});
  const Double4 bent = totals(node[0].y, node[0].z, node[1].y, node[1].z);
  return {{frame[0], frame[1], frame[2]},
          {turn[0], turn[1], turn[2]},
          {{frame[0] - outer[0], frame[1] - outer[1], frame[2] - outer[2]},
           {outer[0], outer[1], outer[2]}},
          {{frame[3] - turn[3], bent[0], bent[1]}, {turn[3], bent[2], bent[3]}}};
}

/// Returns a rotation of B as one of the element's axes.
Matrix3 turn_in_axes(const BeamElement& element, const Rotation& turn) {
  return element.axes.transpose().lazyProduct(turn.axes.lazyProduct(element.axes).eval());
}

/// Adds forces at sections of an element to the tension; `turn`: as in add_load().
[[gnu::always_inline]] inline void add_tension(const LoadedSections& at, bool is_straight,
                                               const BeamElement& element, const NodeCoordinates& x,
                                               const Quad& force, const Rotation& turn,
                                               AppliedTension& tension) {
  // The forces are along the element's axes in the undeformed tree.
  const Quad f = turn_all(is_straight ? turn.axes : turn_in_axes(element, turn), force);
  const double r[2] = {x.u[1].y() - x.u[0].y(), x.u[1].z() - x.u[0].z()};
  const double a[2] = {x.th[0].z(), -x.th[0].y()}, b[2] = {x.th[1].z(), -x.th[1].y()};
  const double twist = x.th[1].x() - x.th[0].x();
  const auto both = [](const double* m, const double* n) { return m[0] * n[0] + m[1] * n[1]; };
  const double products[] = {both(r, r), 2.0 * both(r, a), 2.0 * both(r, b),
                             both(a, a), 2.0 * both(a, b), both(b, b)};
  const Double4 along = lanes(at.along);
  Double4 form = (element.stiffening.torsion[0] * twist * twist) * along;
  Double4 slopes[6];
  for (int i = 0; i < 6; ++i) {
    const Double4 slope = lanes(at.tension[i]);
    form += products[i] * slope;
    slopes[i] = f.x * slope;
  }
  const Double4 sum = totals(f.x, f.y, f.z, f.x * along);
  const Double4 first = totals(slopes[0], slopes[1], slopes[2], slopes[3]);
  const Double4 second = totals(slopes[4], slopes[5], form * f.y, form * f.z);
  tension.add_at_sections(at.element,
                          {from_axes(element, is_straight, {sum[0], sum[1], sum[2]}),
                           {first[0], first[1], first[2], first[3], second[0], second[1]},
                           sum[3],
                           from_axes(element, is_straight, {0.0, second[2], second[3]})});
}

const BeamElement& element_of(const FlexibleBody& body, const LoadedSections& at) {
  assert(at.element >= 0 && at.element < body.elements);
  return body.beam[static_cast<std::size_t>(at.element)];
}

/// Adds forces by node, in B, to the rows; returns their power at the rates of the nodes.
double add_to_rows(const FlexibleBody& body, const BeamElement& element,
                   const LoadedElement& forces, const double* rates, double* rows) {
  double power = 0.0;
  for (int n = 0; n < 2; ++n) {
    const Twist force = make_twist(from_axes(element, body.is_straight, forces.u[n]),
                                   from_axes(element, body.is_straight, forces.rotation[n]));
    for (int c = 0; c < kTwist; ++c, ++rates, rows += 4) {
      rows[3] += force[c];
      power += force[c] * *rates;
    }
  }
  return power;
}

void add(const FlexibleBody& body, std::span<const LoadedSections> sections,
         const LoadInstant& load, const BodyState& state, const Twist& twist,
         AppliedTension* tension, const Rotation& turn, BodyTerms& terms, const BodyWork& work) {
  for (const LoadedSections& at : sections) {
    const BeamElement& element = element_of(body, at);
    double q[2 * kTwist], v[2 * kTwist];
    expand_element(body, at.element, state.q, q);
    expand_element(body, at.element, state.v, v);
    const NodeCoordinates x(body, element, q);
    const QuadWrench wrench = calc_wrench(at, load, body.is_straight, element, x);
    const LoadedElement forces = sum_forces(at, x, wrench);
    const Twist on_frame = make_twist(from_axes(element, body.is_straight, forces.force),
                                      from_axes(element, body.is_straight, forces.moment));
    terms.Q += on_frame;
    terms.load_power += on_frame.dot(twist) +
                        add_to_rows(body, element, forces, v, work.rows + kNodeRows * at.element);
    if (tension) add_tension(at, body.is_straight, element, x, wrench.force, turn, *tension);
  }
}

Position sum(const FlexibleBody& body, std::span<const LoadedSections> sections,
             const LoadInstant& load, const double* q) {
  Position whole = Position::Zero();
  for (const LoadedSections& at : sections) {
    const BeamElement& element = element_of(body, at);
    Quad force = spread(at, load.follows, body.is_straight, element, linear(load.wrench));
    if (load.follows) {
      double nodal[2 * kTwist];
      expand_element(body, at.element, q, nodal);
      const NodeCoordinates x(body, element, nodal);
      force = SectionTurns(x.rotation(at)).turn(force);
    }
    const Double4 total = totals(force.x, force.y, force.z, Double4{});
    whole += from_axes(element, body.is_straight, {total[0], total[1], total[2]});
  }
  return whole;
}

void set_section(const FlexibleBody& body, const Section& section, double weight, std::size_t i,
                 LoadedSections& at) {
  const auto e = static_cast<std::size_t>(section.element);
  const BeamElement& element = body.beam[e];
  const Matrix3 to_element = element.axes.transpose();
  const Eigen::Vector4d h = hermite(section.xi, element.length);
  const Eigen::Vector4d slope = hermite_slope(section.xi, element.length);
  const Position offset = to_element * (section.s0 - body.nodes[e] - section.xi * element.chord);
  const Position place = to_element * section.s0;
  const Matrix3 axes = to_element * section.axes.axes;
  at.along[i] = section.xi;
  at.stretch[i] = h[2] + (h[1] + h[3]) / element.length;
  at.rise[i] = h[2];
  at.rise_slope[i] = slope[2];
  for (std::size_t n = 0; n < 2; ++n) {
    at.tangent[n][i] = h[n == 0 ? 1 : 3];
    at.slope[n][i] = slope[n == 0 ? 1 : 3];
    at.offset[n][i] = offset[n == 0 ? 1 : 2];
  }
  for (std::size_t c = 0; c < 3; ++c) at.place[c][i] = place[static_cast<Eigen::Index>(c)];
  for (std::size_t c = 0; c < 9; ++c) at.axes[c][i] = axes.data()[c];
  for (std::size_t c = 0; c < 6; ++c) at.tension[c][i] = section.slopes[c];
  at.weight[i] = weight;
}

}  // namespace

std::vector<LoadedSections> make_loaded_sections(const FlexibleBody& body,
                                                 std::span<const Section> sections,
                                                 std::span<const double> weights) {
  std::vector<LoadedSections> loaded;
  std::size_t used = 0;
  for (std::size_t k = 0; k < sections.size(); ++k) {
    const int element = sections[k].element;
    if (loaded.empty() || used == 4 || loaded.back().element != element) {
      loaded.emplace_back().element = element;
      used = 0;
    }
    set_section(body, sections[k], weights[k], used++, loaded.back());
  }
  return loaded;
}

Position sum_load_forces(const FlexibleBody& body, std::span<const LoadedSections> sections,
                         const LoadInstant& load, const double* q) noexcept {
  return run_large_kernel([&]() noexcept { return sum(body, sections, load, q); });
}

void add_load(const FlexibleBody& body, std::span<const LoadedSections> sections,
              const LoadInstant& load, const BodyState& state, const Twist& twist,
              AppliedTension* tension, const Rotation& turn, BodyTerms& terms,
              const BodyWork& work) noexcept {
  run_large_kernel(
      [&]() noexcept { add(body, sections, load, state, twist, tension, turn, terms, work); });
}

}  // namespace spoke::space
