// Takes both planes of bending by the same formulas: a rise between the nodes, and a slope at each.

#include "engine/bodies/kinds/beam/straight_forces.h"

#include "engine/bodies/space/body_stiffening.h"
#include "engine/bodies/space/tension_weights.h"
#include "engine/bodies/space/turned_sections.h"
#include "models/support/wide_kernels.h"

namespace spoke::space {
namespace {

/// Values at the inner and the outer nodes of four elements.
struct Ends {
  Double4 inner, outer;

  /// Loads them; x: at the innermost node. The others have been stored by four from the next node
  /// on, or a moment ago: reading four that lie across would wait until they have reached the
  /// cache.
  [[gnu::always_inline]] explicit Ends(const double* x) : outer(load4(x + 1)) {
    inner = __builtin_shufflevector(Double4{x[0]}, outer, 0, 4, 5, 6);
  }
};

/// Displacements of an element's ends in its two planes and about its axis, at four elements; or
/// forces.
struct ElementState {
  struct Plane {
    Double4 rise{}, inner{}, outer{};  // rise of the outer node above the inner; slopes
  };
  Plane plane[2];
  Double4 torsion[2]{};  // at the inner and the outer node

  ElementState() = default;
  [[gnu::always_inline]] ElementState(const LaneRows& rows, int e) {
    for (int p = 0; p < 2; ++p) {
      const Ends place(rows.at(kPlace1 + 2 * p, e)), slope(rows.at(kSlope1 + 2 * p, e));
      plane[p] = {place.outer - place.inner, slope.inner, slope.outer};
    }
    const Ends ends(rows.at(kTorsion, e));
    torsion[0] = ends.inner;
    torsion[1] = ends.outer;
  }
};

/// Forces by stretch, torsion and bending; those of a plane on its rise and slopes.
struct ElementForces {
  Double4 axial, twist;  // on the inner node, and against the outer
  ElementState bending;

  /// Calculates the elastic forces.
  [[gnu::always_inline]] ElementForces(const ElementLanes& m, const LaneRows& rows, int e) {
    const ElementState x(rows, e);
    const Ends u(rows.at(kAxialPlace, e));
    axial = lanes(m.axial) * (u.outer - u.inner);
    twist = lanes(m.torsion) * (x.torsion[1] - x.torsion[0]);
    const Double4 l = lanes(m.length);
    for (int p = 0; p < 2; ++p) {
      const ElementState::Plane& at = x.plane[p];
      const ElementLanes::Bending& K = m.bending[static_cast<std::size_t>(p)];
      const Double4 rise = at.rise - l * at.inner, turn = at.outer - at.inner;
      const Double4 shear = lanes(K.shear) * rise + lanes(K.mixed) * turn;
      const Double4 moment = lanes(K.mixed) * rise + lanes(K.moment) * turn;
      bending.plane[p] = {shear, -(moment + l * shear), moment};
    }
  }
  /// Stores the forces on the nodes: the opposite.
  [[gnu::always_inline]] void store_to(const LaneRows& inner, const LaneRows& outer, int e) const {
    const auto put = [&](int component, const Double4& on_inner, const Double4& on_outer)
        __attribute__((always_inline)) {
      store(on_inner, inner.at(component, e));
      store(on_outer, outer.at(component, e + 1));
    };
    put(kAxialPlace, axial, -axial);
    put(kTorsion, twist - bending.torsion[0], -twist - bending.torsion[1]);
    for (int p = 0; p < 2; ++p) {
      const ElementState::Plane& f = bending.plane[p];
      put(kPlace1 + 2 * p, f.rise, -f.rise);
      put(kSlope1 + 2 * p, -f.inner, -f.outer);
    }
  }
};

/// Sums of q^T K q and q^T K q'.
struct Forms {
  Double4 value{}, rate{};

  [[gnu::always_inline]] void add(const Double4& factor, const Forms& forms) {
    value += factor * forms.value;
    rate += factor * forms.rate;
  }
};

/// Adds weight K q of one tension matrix K to f; returns its forms.
[[gnu::always_inline]] inline Forms add_tension(const ElementLanes::Tension& K,
                                                const Double4& weight, const ElementState& q,
                                                const ElementState& v, ElementState& f) {
  Forms forms;
  for (int p = 0; p < 2; ++p) {
    const ElementState::Plane &x = q.plane[p], &y = v.plane[p];
    const Double4 rise =
        lanes(K.rise) * x.rise + lanes(K.rise_inner) * x.inner + lanes(K.rise_outer) * x.outer;
    const Double4 inner =
        lanes(K.rise_inner) * x.rise + lanes(K.inner) * x.inner + lanes(K.between) * x.outer;
    const Double4 outer =
        lanes(K.rise_outer) * x.rise + lanes(K.between) * x.inner + lanes(K.outer) * x.outer;
    f.plane[p].rise += weight * rise;
    f.plane[p].inner += weight * inner;
    f.plane[p].outer += weight * outer;
    forms.value += rise * x.rise + inner * x.inner + outer * x.outer;
    forms.rate += rise * y.rise + inner * y.inner + outer * y.outer;
  }
  const Double4 turn = q.torsion[1] - q.torsion[0], trapeze = lanes(K.torsion) * turn;
  f.torsion[0] -= weight * trapeze;
  f.torsion[1] += weight * trapeze;
  forms.value += trapeze * turn;
  forms.rate += trapeze * (v.torsion[1] - v.torsion[0]);
  return forms;
}

/// Rotations of four elements: as SectionTurns has them, twice as large.
struct Turns {
  Double4 x, y, z;
};
struct ElementTurns {
  Turns mean, slope;

  static constexpr double kSlope = 2.0 * SectionTurns::kSlope;
  [[gnu::always_inline]] explicit ElementTurns(const ElementState& q)
      : mean{q.torsion[0] + q.torsion[1], -(q.plane[1].inner + q.plane[1].outer),
             q.plane[0].inner + q.plane[0].outer},
        slope{kSlope * (q.torsion[1] - q.torsion[0]),
              kSlope * (q.plane[1].inner - q.plane[1].outer),
              kSlope * (q.plane[0].outer - q.plane[0].inner)} {}
};

/// Entries of W0 that count where P_23 is zero, with the factors that M has of them.
struct SpinWeights {
  double w22, w33, half12, half13, half23;

  explicit SpinWeights(const Angular& w)
      : w22(w[0] * w[0] + w[2] * w[2]),
        w33(w[0] * w[0] + w[1] * w[1]),
        half12(-0.5 * w[0] * w[1]),
        half13(-0.5 * w[0] * w[2]),
        half23(-0.5 * w[1] * w[2]) {}
};

/// Lambda of turned sections with P_22 and P_33 alone.
struct TurnForms {
  Double4 of_22{}, of_33{}, xy{}, xz{}, yz{};

  [[gnu::always_inline]] void add(const Double4& P22, const Double4& P33, const ElementTurns& a,
                                  const ElementTurns& b) {
    add(P22, P33, a.mean, b.mean);
    add(P22, P33, a.slope, b.slope);
  }
  [[gnu::always_inline]] void add(const Double4& P22, const Double4& P33, const Turns& a,
                                  const Turns& b) {
    const Double4 xx = a.x * b.x;
    of_22 += P22 * (xx + a.z * b.z);
    of_33 += P33 * (xx + a.y * b.y);
    xy += P22 * (a.x * b.y + a.y * b.x);
    xz += P33 * (a.x * b.z + a.z * b.x);
    yz += (P22 + P33) * (a.y * b.z + a.z * b.y);
  }
  Matrix3 inertia() const {
    const double a = total(of_22), b = total(of_33);
    const double across[] = {0.25 * total(xy), 0.25 * total(xz), 0.25 * total(yz)};
    Matrix3 inertia;
    inertia << a + b, across[0], across[1], across[0], b, across[2], across[1], across[2], a;
    return inertia;
  }
};

/// Adds what turned sections take off (turned_sections.h) to f, and their forms to the sums.
[[gnu::always_inline]] inline void add_turned_sections(const ElementLanes& m, const SpinWeights& W,
                                                       const ElementState& q, const ElementState& v,
                                                       ElementState& f, TurnForms& value,
                                                       TurnForms& rate) {
  const Double4 P22 = lanes(m.turning[0]), P33 = lanes(m.turning[1]);
  const ElementTurns th(q);
  value.add(P22, P33, th, th);
  rate.add(P22, P33, th, ElementTurns(v));
  const Double4 M12 = W.half12 * P22, M13 = W.half13 * P33, M23 = W.half23 * (P22 + P33);
  const Double4 M22 = W.w33 * P33, M33 = W.w22 * P22, M11 = W.w22 * P22 + W.w33 * P33;
  const auto moment = [&](const Turns& a) __attribute__((always_inline)) {
    return Turns{M11 * a.x - M12 * a.y - M13 * a.z, M22 * a.y - M12 * a.x - M23 * a.z,
                 M33 * a.z - M13 * a.x - M23 * a.y};
  };
  const Turns both = moment(th.mean), of_slope = moment(th.slope);
  const double k = ElementTurns::kSlope;
  const Turns apart{k * of_slope.x, k * of_slope.y, k * of_slope.z};
  f.torsion[0] += both.x - apart.x;
  f.torsion[1] += both.x + apart.x;
  f.plane[0].inner += both.z - apart.z;
  f.plane[0].outer += both.z + apart.z;
  f.plane[1].inner -= both.y - apart.y;
  f.plane[1].outer -= both.y + apart.y;
}

/// Masses that four elements carry, and their tension.
struct CarriedLanes {
  Double4 moment[3], mass, tension;

  /// Takes elements e ... e + 3; `piece` is the one that holds for e, and then for e + 4.
  [[gnu::always_inline]] CarriedLanes(const std::vector<CarriedMass>& carried, int e,
                                      const TensionWeights& weights, std::size_t& piece) {
    const auto move_to = [&](int element) {
      while (piece + 1 < carried.size() && carried[piece].end <= element) ++piece;
    };
    move_to(e);
    const bool is_one = piece + 1 == carried.size() || carried[piece].end >= e + 4;
    for (int lane = 0; lane < 4; ++lane) {
      if (!is_one) move_to(e + lane);
      const CarriedMass& c = carried[piece];
      for (int i = 0; i < 3; ++i) moment[i][lane] = c.moment[i];
      mass[lane] = c.mass;
      tension[lane] = lane > 0 && is_one ? tension[0] : carried_tension(c, weights);
    }
  }
};

/// Sums over all elements.
struct StraightSums {
  Forms carried[3], carried_mass, KL, Kx;
  TurnForms turned, turned_rate;

  StiffeningForms take(Double4 Forms::*part, const TurnForms& turn) const {
    const auto sum = [part](const Forms& forms) { return total(forms.*part); };
    StiffeningForms forms;
    forms.tension.carried = {sum(carried[0]), sum(carried[1]), sum(carried[2])};
    forms.tension.carried_mass = sum(carried_mass);
    forms.tension.KL = sum(KL);
    forms.tension.Kx = sum(Kx);
    forms.inertias = turn.inertia();
    return forms;
  }
};

[[gnu::always_inline]] inline void add_stiffening(const ElementLanes& m, const TensionWeights& at,
                                                  const SpinWeights& spin,
                                                  const CarriedLanes& carried,
                                                  const ElementState& q, const ElementState& v,
                                                  ElementState& f, StraightSums& sums) {
  const Forms own = add_tension(m.tension[0], carried.tension, q, v, f);
  for (int i = 0; i < 3; ++i) sums.carried[i].add(carried.moment[i], own);
  sums.carried_mass.add(carried.mass, own);
  const Double4 one{1.0, 1.0, 1.0, 1.0};
  sums.KL.add(one, add_tension(m.tension[1], at.tension[1] * one, q, v, f));
  sums.Kx.add(one, add_tension(m.tension[2], at.tension[2] * one, q, v, f));
  add_turned_sections(m, spin, q, v, f, sums.turned, sums.turned_rate);
}

void calc_forces(const BodyModel& model, const BodyMotion& motion, LaneRows::Kind elastic,
                 const BodyScratch& scratch, BodyTerms& terms) {
  const FlexibleBody& body = *model.body;
  const LaneRows x(body, scratch, elastic), q(body, scratch, LaneRows::coordinates),
      v(body, scratch, LaneRows::velocities), inner(body, scratch, LaneRows::inner_forces),
      outer(body, scratch, LaneRows::outer_forces);
  const TensionPlace* const place = model.tension;
  TensionWeights weights{};
  if (place) weights = calc_tension_weights(*place, motion);
  const SpinWeights spin(weights.w);
  StraightSums sums;
  std::size_t piece = 0;
  int e = 0;
  for (const ElementLanes& m : body.directions->elements) {
    ElementForces forces(m, x, e);
    if (place)
      add_stiffening(m, weights, spin, CarriedLanes(place->carried, e, weights, piece),
                     ElementState(q, e), ElementState(v, e), forces.bending, sums);
    forces.store_to(inner, outer, e);
    e += 4;
  }
  if (!place) return;
  const StiffeningSums tension{sums.take(&Forms::value, sums.turned),
                               sums.take(&Forms::rate, sums.turned_rate)};
  terms.stiffening = calc_hub_stiffening(*place, motion.gravity, tension);
  terms.tension = calc_tension_moment(*place, tension);
}

}  // namespace

void calc_straight_forces(const BodyModel& model, const BodyMotion& motion, LaneRows::Kind elastic,
                          const BodyScratch& scratch, BodyTerms& terms) noexcept {
  run_large_kernel([&]() noexcept { calc_forces(model, motion, elastic, scratch, terms); });
}

}  // namespace spoke::space
