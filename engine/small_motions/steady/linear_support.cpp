// Linearises a support under the mean wrenches of its rotors.

#include "engine/small_motions/steady/linear_support.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "engine/small_motions/steady/differences.h"
#include "engine/small_motions/steady/joined_rotors.h"

namespace spoke::steady {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Returns the stiffness of loads across the axis that turn against the rotor, which its own
/// matrices do not have: their moment about the hub goes with their places.
MatrixXd calc_dead_stiffness(std::size_t r, const Equilibrium& rotor, const SupportedModel& model) {
  constexpr double kTurn = 1e-4;
  MatrixXd K = MatrixXd::Zero(6, 6);
  if (!model.parts(r).averages) return K;
  const auto wrench = [&](Index c, double angle) {
    const HubVector turn = angle * HubVector::Unit(6, c);
    return HubVector(model.mean_wrench(r, rotor, turn, DeadLoads::all) -
                     model.mean_wrench(r, rotor, turn, DeadLoads::steady));
  };
  for (Index c = 3; c < 6; ++c) K.col(c) = (wrench(c, -kTurn) - wrench(c, kTurn)) / (2.0 * kTurn);
  return K;
}

/// The entries of z, in their order: of the base, the support's own, and the axles that turn.
struct Layout {
  Index base, own, all;
  std::vector<std::optional<Index>> axles;  ///< by rotor

  Layout(const LinearModel& support, const SupportedModel& model)
      : base(support.M.rows()), own(support.subsystem(0).M.rows()), all(base + own) {
    for (std::size_t r = 0; r < model.rotors(); ++r)
      axles.push_back(model.parts(r).turns_freely ? std::optional(all++) : std::nullopt);
  }
};

/// Returns one of the matrices of base and support.
MatrixXd assemble(const Layout& z, const MatrixXd& base, const MatrixXd& bh, const MatrixXd& hb,
                  const MatrixXd& own) {
  MatrixXd all = MatrixXd::Zero(z.all, z.all);
  all.block(z.base, z.base, z.own, z.own) = own;
  if (z.base == 0) return all;
  all.topLeftCorner(z.base, z.base) = base;
  all.block(z.base, 0, z.own, z.base) = bh;
  all.block(0, z.base, z.base, z.own) = hb;
  return all;
}

void set_matrices(const Layout& z, const LinearModel& linear, LinearSupport& support) {
  const LinearSubsystem& own = linear.subsystem(0);
  const HubCoupling by = z.base > 0 ? linear.couplings[0] : HubCoupling{};
  support.M = assemble(z, linear.M, by.M_bh, by.M_hb, own.M);
  support.C = assemble(z, linear.C, by.C_bh, by.C_hb, own.C);
  support.K = assemble(z, linear.K, by.K_bh, by.K_hb, own.K);
  support.step = Eigen::VectorXd::Constant(z.all, kStep);
  support.step.segment(z.base, z.own) = own.round_off.step;
}

/// Sets how z moves the coordinates of the support, and the hubs.
void set_motions(const Layout& z, const LinearModel& linear, const SupportedModel& machine,
                 LinearSupport& support) {
  SteadyModel& model = machine.support();
  const MatrixXd& Z = linear.subsystem(0).basis;
  const Index n = std::ssize(model.coordinates(0));
  support.motion = MatrixXd::Zero(n, z.all);
  support.motion.middleCols(z.base, z.own) = Z.rows() > 0 ? Z : MatrixXd::Identity(n, n);
  if (z.base > 0 && linear.couplings[0].following.size() > 0)
    support.motion.leftCols(z.base) = linear.couplings[0].following;
  support.base = MatrixXd::Zero(6, z.all);
  support.base.leftCols(z.base).setIdentity();
  support.axles = z.axles;
  support.J.resize(6 * static_cast<Index>(machine.rotors()), z.all);
  for (std::size_t r = 0; r < machine.rotors(); ++r) {
    const MatrixXd twists = model.twists(0, machine.parts(r).body);
    auto J = rows_of(r, support.J);
    J = twists.rightCols(n) * support.motion + twists.leftCols(6) * support.base;
    if (z.axles[r]) J(5, *z.axles[r]) = 1.0;
  }
}

/// Returns how z moves the generator of a rotor, whose joint is there if no drive prescribes its
/// motion.
Eigen::VectorXd find_generator(const RotorParts& rotor, const SteadyModel& model,
                               const LinearSupport& support) {
  const std::string name = rotor.prefix + std::string(spatial::kGeneratorName);
  const std::vector<SubsystemCoordinate>& all = model.coordinates(0);
  const auto at = std::find_if(
      all.begin(), all.end(),
      [&name](const SubsystemCoordinate& coordinate) { return coordinate.joint == name; });
  if (at == all.end()) return Eigen::VectorXd::Zero(support.motion.cols());
  return support.motion.row(at - all.begin()).transpose();
}

/// Adds the shaft of a drive train. The support has the shaft at rest at the hub: k/2 q^2/n^2 of
/// the generator's angle q, in place of k/2 (psi - q/n)^2. Returns how z moves what the drive acts
/// on, the generator, by the gear's ratio.
Eigen::VectorXd add_shaft(Index axle, const RotorParts& rotor, const SteadyModel& model,
                          LinearSupport& support) {
  const spatial::DriveTrain& train = *rotor.train;
  Eigen::VectorXd generator = find_generator(rotor, model, support) / train.gear_ratio;
  const Eigen::VectorXd turn = Eigen::VectorXd::Unit(generator.size(), axle) - generator;
  const MatrixXd missing = turn * turn.transpose() - generator * generator.transpose();
  support.K += train.stiffness * missing;
  support.C += train.damping * missing;
  return generator;
}

/// Adds the angle of a rotor that turns freely about its axle. A torque of slope `slope` acts
/// between hub, or generator, and carrier, so that it does work on that angle alone. The rotor's
/// moment on its hub stands while the axle tilts.
void add_axle(std::size_t r, Index axle, const Eigen::Vector3d& moment, const SupportedModel& model,
              LinearSupport& support) {
  const RotorParts& rotor = model.parts(r);
  Eigen::VectorXd drive = Eigen::VectorXd::Unit(support.M.rows(), axle);
  if (rotor.train) drive = add_shaft(axle, rotor, model.support(), support);
  support.C -= rotor.torque_slope * drive * drive.transpose();
  const Eigen::Vector3d tilting(-moment.y(), moment.x(), 0.0);  // axis x moment
  support.K.row(axle) -= tilting.transpose() * rows_of(r, support.J).bottomRows(3);
  support.drives[r] = drive;
}

/// Takes off the mass of what stands for a hub on the support, whose axle is held there.
void remove_ballast(std::size_t r, const SupportedModel& model, LinearSupport& support) {
  MatrixXd J = rows_of(r, support.J);
  if (support.axles[r]) J.col(*support.axles[r]).setZero();
  support.M -= J.transpose() * model.parts(r).ballast * J;
}

void name_entries(const Layout& z, const LinearModel& linear, const SupportedModel& machine,
                  LinearSupport& support) {
  const SteadyModel& model = machine.support();
  static constexpr const char* kBase[] = {"x", "y", "z", "rotation x", "rotation y", "rotation z"};
  const auto add = [&support](const std::string& of, const std::string& name,
                              const std::string& unit) {
    support.of.push_back(of);
    support.names.push_back(name);
    support.units.push_back(unit);
  };
  for (Index c = 0; c < z.base; ++c)
    add("fuselage", std::string("fuselage / ") + kBase[c], c < 3 ? "m" : "rad");
  for (const SubsystemCoordinate& own : list_independent(0, linear, model)) {
    const std::string& body = model.body_names(0)[static_cast<std::size_t>(own.body)];
    const std::string beam = body.substr(0, body.find(" / "));  // its parts go together
    add(own.node < 0 ? own.joint : beam, model.name_of(0) + " / " + own.name, own.unit());
  }
  for (const Index k : linear.subsystem(0).forces) support.forces.push_back(z.base + k);
  for (std::size_t r = 0; r < machine.rotors(); ++r) {
    const std::string axle = machine.parts(r).prefix + "axle";
    if (z.axles[r]) add(axle, model.name_of(0) + " / " + axle, "rad");
  }
}

/// Adds the support as a subsystem that follows the hubs' coordinates.
void add_subsystem(const LinearSupport& support, LinearModel& all) {
  LinearSubsystem& own = all.subsystems.emplace_back();
  own.M = own.C = own.K = MatrixXd::Zero(0, 0);
  own.basis = MatrixXd::Zero(support.motion.rows(), 0);
  all.alike.push_back(all.alike.size());
  const Index hubs = all.M.rows();
  const MatrixXd columns = MatrixXd::Zero(0, hubs), rows = MatrixXd::Zero(hubs, 0);
  all.couplings.push_back({columns, columns, columns, rows, rows, rows, support.motion});
}

LinearModel linearize_on(SupportedModel& model, const Equilibrium& equilibrium) {
  const SupportedEquilibrium parts = split(equilibrium, model);
  std::vector<LinearModel> rotors;
  std::vector<std::vector<std::size_t>> subsystems;
  for (std::size_t r = 0; r < model.rotors(); ++r) {
    rotors.push_back(linearize(parts.rotors[r], model.rotor(r), HubFreedom::all));
    subsystems.push_back(model.parts(r).subsystems);
  }
  LinearModel all = join_rotors(rotors, subsystems);
  const LinearModel own = linearize(parts.support, model.support());
  const Layout z(own, model);
  LinearSupport support;
  support.rotor_mass = all.M;
  set_matrices(z, own, support);
  set_motions(z, own, model, support);
  for (std::size_t r = 0; r < model.rotors(); ++r) {
    remove_ballast(r, model, support);
    const auto J = rows_of(r, support.J);
    support.K += J.transpose() * calc_dead_stiffness(r, parts.rotors[r], model) * J;
  }
  support.drives.assign(model.rotors(), Eigen::VectorXd::Zero(z.all));
  for (std::size_t r = 0; r < model.rotors(); ++r)
    if (z.axles[r]) add_axle(r, *z.axles[r], -equilibrium.wrenches[r].tail<3>(), model, support);
  name_entries(z, own, model, support);
  add_subsystem(support, all);
  all.support = std::move(support);
  return all;
}

}  // namespace

LinearModel linearize_machine(const Equilibrium& equilibrium, SteadyModel& model) {
  SupportedModel* machine = model.on_support();
  return machine ? linearize_on(*machine, equilibrium) : linearize(equilibrium, model);
}

void stand_on(const LinearSupport& support, LinearModel& rotor) {
  const MatrixXd& J = support.J;
  assert(J.rows() == rotor.M.rows() && support.M.rows() == J.cols());
  rotor.M = support.M + J.transpose() * rotor.M * J;
  rotor.C = support.C + J.transpose() * rotor.C * J;
  rotor.K = support.K + J.transpose() * rotor.K * J;
  for (HubCoupling& coupling : rotor.couplings) {
    for (MatrixXd* columns : {&coupling.M_bh, &coupling.C_bh, &coupling.K_bh})
      *columns = (*columns * J).eval();
    for (MatrixXd* rows : {&coupling.M_hb, &coupling.C_hb, &coupling.K_hb})
      *rows = (J.transpose() * *rows).eval();
  }
  rotor.round_off.force = J.cwiseAbs().transpose() * rotor.round_off.force;
  rotor.round_off.step = support.step;
}

}  // namespace spoke::steady
