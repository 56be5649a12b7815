#include "models/solid/solid_problem.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "models/solid/memory.h"
#include "models/solid/order_coordinates.h"
#include "models/solid/reduction.h"
#include "models/solid/statics.h"
#include "spoke/error.h"

namespace spoke::solid {
namespace {

using space::SolidConstants;

[[noreturn]] void refuse_problem(const std::string& key, const std::string& what) {
  throw InputError(what, {{}, 0, 0, key});
}

/// Returns m (x) 1_3.
Sparse expand(const Sparse& m) {
  Sparse M(3 * m.rows(), 3 * m.cols());
  M.reserve(3 * m.nonZeros());
  for (Eigen::Index j = 0; j < m.cols(); ++j) {
    for (int a = 0; a < 3; ++a) {
      M.startVec(3 * j + a);
      for (Sparse::InnerIterator entry(m, j); entry; ++entry)
        M.insertBack(3 * entry.row() + a, 3 * j + a) = entry.value();
    }
  }
  M.finalize();
  return M;
}

/// Returns the modes that are asked for. `available`: how many there are.
ModeChoice choose_modes(const SolidProblem& problem, Eigen::Index available) {
  ModeChoice choice;
  if (problem.up_to) {
    const double w = 2.0 * std::numbers::pi * *problem.up_to;
    choice.up_to = w * w;
    return choice;
  }
  choice.count = static_cast<int>(std::min<Eigen::Index>(spatial::kUsualModes, available));
  if (!problem.modes) return choice;
  if (*problem.modes > available)
    refuse_problem("modes", std::to_string(*problem.modes) + " modes, expected at most " +
                                std::to_string(available) + ", as many as the solid has");
  choice.count = *problem.modes;
  return choice;
}

/// Computes the constants of one problem.
class ConstantsBuilder {
 public:
  ConstantsBuilder(const SolidProblem& problem, const Control& control)
      : problem_(problem), control_(control), m_(problem.matrices.m) {}

  SolidConstants build() {
    say("assemble", 0.5);
    constraints_ =
        make_constraints(problem_.nodes, problem_.interfaces, problem_.sets, problem_.frame);
    K_ = project(problem_.matrices.K, constraints_.Xi);
    M_ = project(expand(m_), constraints_.Xi);
    write_mass();
    const bool is_reduced = problem_.coordinates == spatial::SolidCoordinates::reduced;
    if (is_reduced || problem_.is_stiffened) factorise();
    if (is_reduced)
      write_reduced();
    else
      write_nodal();
    say("stiffening", 1.0);
    return std::move(result_);
  }

 private:
  /// `done`: the step's part that is done. The steps take these parts of all, roughly.
  void say(const std::string& step, double done) const {
    if (!control_.progress) return;
    const double from = step == "assemble"    ? 0.0
                        : step == "factorise" ? 0.1
                        : step == "modes"     ? 0.4
                                              : 0.8;
    const double to = step == "assemble"    ? 0.1
                      : step == "factorise" ? 0.4
                      : step == "modes"     ? 0.8
                                            : 1.0;
    control_.progress(step, from + (to - from) * done);
  }
  bool is_free() const { return problem_.frame == spatial::SolidFrame::mean_axis; }

  void write_mass() {
    const auto n = static_cast<Eigen::Index>(problem_.nodes.size());
    x_.resize(n, 3);
    for (Eigen::Index i = 0; i < n; ++i)
      x_.row(i) = problem_.nodes[static_cast<std::size_t>(i)].transpose();
    const Eigen::VectorXd masses = m_ * Eigen::VectorXd::Ones(n);
    result_.mass = masses.sum();
    result_.S0 = x_.transpose() * masses;
    const Eigen::Matrix3d J = x_.transpose() * (m_ * x_);
    result_.J0 = 0.5 * (J + J.transpose());
    result_.extent = std::sqrt(x_.rowwise().squaredNorm().maxCoeff());
    result_.frame = problem_.frame;
    result_.is_stiffened = problem_.is_stiffened;
    result_.nodes = problem_.nodes;
  }

  void factorise() {
    say("factorise", 0.0);
    const Cholesky::Checker checker = [this](double entries) {
      require_factor_memory(entries, control_.memory);
    };
    if (is_free())
      free_.emplace(K_, M_, constraints_.rigid, checker);
    else if (constraints_.dependent.empty())
      clamped_.emplace(K_, constraints_.boundary, checker);
    else
      clamped_.emplace(K_, take_apart(problem_.matrices.K, constraints_.Xi, constraints_.dependent),
                       constraints_.boundary, checker);
    if (!(is_free() ? free_->is_definite() : clamped_->is_definite()))
      refuse_problem("mesh",
                     "its stiffness is singular, expected elements that all hang together" +
                         std::string(is_free() ? "" : " and hold on to the first interface"));
  }

  /// Refuses more modes of vibration than the memory holds: up to a frequency there may be many.
  void require_modes(int count) const {
    const double shapes = 6.0 * static_cast<double>(problem_.interfaces.size());
    require_mode_memory(count + shapes, static_cast<double>(3 * m_.rows()), control_.memory);
  }

  Eigen::MatrixXd solve(const Eigen::MatrixXd& f) const {
    return is_free() ? free_->solve(f) : clamped_->solve(f);
  }

  /// The wrenches on interfaces whose static shapes are added to the modes of vibration.
  Eigen::MatrixXd attached_loads() const {
    std::vector<std::size_t> attached;
    for (std::size_t k = is_free() ? 0 : 1; k < problem_.interfaces.size(); ++k)
      if (is_free() || problem_.interfaces[k].kind == spatial::InterfaceKind::average)
        attached.push_back(k);
    Eigen::MatrixXd loads(K_.rows(), 6 * static_cast<Eigen::Index>(attached.size()));
    for (std::size_t k = 0; k < attached.size(); ++k)
      loads.middleCols<6>(6 * static_cast<Eigen::Index>(k)) =
          place_loads(constraints_.places[attached[k]], K_.rows());
    return loads;
  }

  void write_reduced() {
    say("modes", 0.0);
    const PartDone done = [&](double part) { say("modes", part); };
    const Eigen::Index available = M_.rows() - (is_free() ? 6 : constraints_.boundary);
    ModeChoice choice = choose_modes(problem_, available);
    choice.require = [this](int count) { require_modes(count); };
    const ReducedBasis basis = is_free()
                                   ? reduce(M_, K_, *free_, attached_loads(), choice, done)
                                   : reduce(M_, K_, *clamped_, attached_loads(), choice, done);
    if (basis.squares.size() == 0)
      refuse_problem(problem_.up_to ? "up_to" : "modes", "leaves no modes, expected at least one");
    for (const double square : basis.vibration)
      result_.frequencies.push_back(std::sqrt(square) / (2.0 * std::numbers::pi));
    space::ReducedSolid solid;
    solid.stiffness = basis.squares;
    solid.shapes = constraints_.Xi * basis.T;
    write_invariants(solid);
    write_places(basis.T);
    if (problem_.is_stiffened) write_stiffening(calc_stresses(), m_, solid);
    result_.coordinates = static_cast<int>(basis.squares.size());
    result_.matrices = std::move(solid);
  }

  /// C_t, h and m.
  void write_invariants(space::ReducedSolid& solid) const {
    const Eigen::Index r = solid.shapes.cols();
    std::array<Eigen::MatrixXd, 3> axes, products;  // Phi_b, m Phi_b
    for (std::size_t b = 0; b < 3; ++b) {
      axes[b].resize(m_.rows(), r);
      for (Eigen::Index i = 0; i < m_.rows(); ++i)
        axes[b].row(i) = solid.shapes.row(3 * i + static_cast<Eigen::Index>(b));
      products[b] = m_ * axes[b];
    }
    solid.C_t.resize(r, 3);
    for (std::size_t a = 0; a < 3; ++a) {
      solid.C_t.col(static_cast<Eigen::Index>(a)) = products[a].colwise().sum().transpose();
      for (std::size_t b = 0; b < 3; ++b) {
        solid.h[3 * a + b] = products[a].transpose() * x_.col(static_cast<Eigen::Index>(b));
        if (b >= a) solid.m[3 * a + b].noalias() = axes[a].transpose() * products[b];
        if (b > a) solid.m[3 * b + a] = solid.m[3 * a + b].transpose();
      }
      Eigen::MatrixXd& square = solid.m[4 * a];
      square = (0.5 * (square + square.transpose())).eval();
    }
  }

  /// Turns the places into those of the modes.
  void write_places(const Eigen::MatrixXd& T) {
    for (space::SolidPlace place : constraints_.places) {
      Eigen::MatrixXd E = Eigen::MatrixXd::Zero(6, T.cols());
      for (std::size_t k = 0; k < place.at.size(); ++k)
        E.noalias() += place.columns[k] * T.row(place.at[k]);
      const bool is_fixed = place.is_fixed();
      place.at.clear();
      place.columns.clear();
      for (int c = 0; c < T.cols() && !is_fixed; ++c) {
        place.at.push_back(c);
        place.columns.emplace_back(E.col(c));
      }
      result_.places.push_back(std::move(place));
    }
  }

  void write_nodal() {
    space::NodalSolid solid;
    if (problem_.is_stiffened) {
      say("stiffening", 0.0);
      write_stiffening(calc_stresses(), solid);
    }
    solid.m = m_;
    solid.K = K_;
    solid.Xi = constraints_.Xi;
    result_.places = constraints_.places;
    result_.coordinates = static_cast<int>(solid.Xi.cols());
    result_.matrices = std::move(solid);
    order_coordinates(result_);
  }

  /// kg of the static displacements under loads in q.
  Eigen::MatrixXd stress_of(const Eigen::MatrixXd& loads) const {
    return calc_geometric_stiffness(*problem_.mesh, *problem_.material, m_,
                                    constraints_.Xi * solve(loads));
  }

  StressMatrices calc_stresses() const {
    say("stiffening", 0.0);
    StressMatrices result;
    const Eigen::Index entries = m_.nonZeros();
    const std::size_t count = constraints_.places.size();
    if (problem_.stresses) {
      result = *problem_.stresses;
      result.places.assign(count, Eigen::MatrixXd::Zero(entries, 6));
      return result;
    }
    assert(problem_.mesh && problem_.material);
    const Sparse Xi_t = constraints_.Xi.transpose();
    result.own = stress_of(Xi_t * spin_loads(m_, problem_.nodes));
    // Under a translation a body that nothing holds has no stress.
    result.translation = is_free() ? Eigen::MatrixXd(Eigen::MatrixXd::Zero(entries, 3))
                                   : stress_of(Xi_t * translation_loads(m_));
    for (std::size_t p = 0; p < count; ++p) {
      say("stiffening", static_cast<double>(p + 1) / static_cast<double>(count + 1));
      const space::SolidPlace& place = constraints_.places[p];
      result.places.push_back(place.is_fixed() ? Eigen::MatrixXd(Eigen::MatrixXd::Zero(entries, 6))
                                               : stress_of(place_loads(place, K_.rows())));
    }
    return result;
  }

  const SolidProblem& problem_;
  const Control& control_;
  const Sparse& m_;
  Constraints constraints_;
  Sparse K_, M_;
  Eigen::MatrixXd x_;
  std::optional<ClampedStatics> clamped_;
  std::optional<FreeStatics> free_;
  SolidConstants result_;
};

}  // namespace

SolidConstants calc_constants(const SolidProblem& problem, const Control& control) {
  assert(!problem.is_stiffened || problem.stresses || (problem.mesh && problem.material));
  return ConstantsBuilder(problem, control).build();
}

void set_damping(const std::vector<double>& ratios, SolidConstants& constants) {
  auto* solid = std::get_if<space::ReducedSolid>(&constants.matrices);
  if (!solid) return;
  solid->damping.setZero(solid->stiffness.size());
  if (ratios.empty()) return;
  const auto count = static_cast<std::size_t>(solid->stiffness.size());
  if (ratios.size() != 1 && ratios.size() != count)
    refuse_problem("damping", std::to_string(ratios.size()) +
                                  " ratios, expected one of all modes, or " +
                                  std::to_string(count) + ", as many as the solid has modes");
  for (std::size_t k = 0; k < count; ++k) {
    const auto row = static_cast<Eigen::Index>(k);
    const double w = std::sqrt(std::max(0.0, solid->stiffness[row]));
    solid->damping[row] = 2.0 * ratios[ratios.size() == 1 ? 0 : k] * w;
  }
}

}  // namespace spoke::solid
