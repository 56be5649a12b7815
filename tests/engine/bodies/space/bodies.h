#pragma once

// A spatial body with all that its kernels work on, at a random state; and its energies as sums
// over the elements' slots, written apart from the kernels.

#include <Eigen/Core>
#include <memory>
#include <random>
#include <vector>

#include "engine/bodies/kinds/beam/body_terms.h"
#include "engine/bodies/kinds/beam/condense_body.h"
#include "models/support/simd.h"
#include "tests/models/space/beams.h"

namespace spoke::space::test {

inline constexpr BlockFactors kExplicit{1.0, 0.0, 0.0};
/// Factors of a step that is linearly implicit.
inline constexpr BlockFactors kImplicit{1.01, 3e-4, 2e-3};

/// A straight beam with section properties, and a bent one with full section matrices.
inline const std::vector<BeamOptions> kStraightAndBent{{false, false, true}, {true, true, true}};

/// A body at a state. Not to be copied: its model points to it.
struct TestBody {
  FlexibleBody body;
  std::array<ElasticBlock, 2> blocks;
  TensionPlace tension;
  BodyModel model;
  Eigen::VectorXd q, v, q_elastic, v_elastic;
  BodyMotion motion;
  Damping damping;
  std::vector<Double2> memory;
  BodyWork work;
  BodyTerms terms;

  explicit TestBody(FlexibleBody made);
  TestBody(const TestBody&) = delete;

  BodyState state() const { return {q.data(), v.data(), q_elastic.data(), v_elastic.data()}; }
  /// Sets elastic forces to those of the state itself.
  void follow() {
    q_elastic = q;
    v_elastic = v;
  }
  void calc_terms() {
    calc_handles(body, q.data(), v.data(), work.handles);
    terms = calc_body_terms(model, state(), motion, damping, work);
  }
  /// Returns Q_f at the state.
  Eigen::VectorXd deformation_force();
};

Position draw_vector(double size, std::mt19937& random);

/// Makes a random beam as a body of unequal elements, at a random state, with handles at node 0, at
/// the last node and, if it has more than two elements, at one between. `is_nonlinear`: with
/// strains of second order.
std::unique_ptr<TestBody> make_random_body(const BeamOptions& options, int elements,
                                           ReferenceFrame frame, std::mt19937& random,
                                           bool is_nonlinear = false);
/// Makes a beam of one symmetric section as such a body: its directions do not meet.
std::unique_ptr<TestBody> make_decoupled_body(int elements, ReferenceFrame frame,
                                              std::mt19937& random);
void randomize_state(std::mt19937& random, TestBody& body);

/// Returns 1/2 sum_ij m_ij V_i . V_j over the slots of all elements, V = e v0 + w x rho + rho',
/// less the energy that the stiffening takes away at the hub's angular velocity w0.
double calc_kinetic(const TestBody& body, const Twist& twist, const Angular& hub_w,
                    const Eigen::VectorXd& q, const Eigen::VectorXd& v);

/// Returns twice the energy of the tension that the hub's angular velocity w0 makes, where the
/// frame turns and the body deforms together: to first order, a rotation of the frame moves nodes
/// as rigid ones.
double calc_tension_form(const TestBody& body, const Angular& hub_w, const Angular& turn,
                         const Eigen::VectorXd& q);

/// Returns the elastic energy, and that of tension by gravity.
double calc_potential(const TestBody& body, const Position& gravity, const Eigen::VectorXd& q);

}  // namespace spoke::space::test
