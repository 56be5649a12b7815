// Derivatives of what a blade shows, along axes that go with it.

#include "engine/small_motions/vibration/multi_blade_outputs.h"

#include <algorithm>

#include "engine/small_motions/steady/at_azimuth.h"
#include "engine/small_motions/steady/output_derivatives.h"
#include "engine/small_motions/vibration/family_blades.h"
#include "engine/small_motions/vibration/multi_blade_inputs.h"
#include "engine/small_motions/vibration/shaft_turn.h"

namespace spoke::vibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Returns the name of an output without that of its blade: "tip.x".
std::string strip(const std::string& name) { return name.substr(name.find('.') + 1); }

bool shows(const FamilyBlade& blade, const std::string& stripped) {
  const std::vector<LinearSignal>& outputs = blade.model->outputs(blade.own);
  return std::any_of(outputs.begin(), outputs.end(),
                     [&](const LinearSignal& signal) { return strip(signal.name) == stripped; });
}

/// Returns the outputs of the first blade that all have, and lists the others.
std::vector<Index> choose(const std::vector<FamilyBlade>& blades,
                          std::vector<std::string>& left_out) {
  std::vector<Index> chosen;
  for (const FamilyBlade& blade : blades) {
    const std::vector<LinearSignal>& outputs = blade.model->outputs(blade.own);
    for (std::size_t k = 0; k < outputs.size(); ++k) {
      const std::string name = strip(outputs[k].name);
      const bool is_common =
          std::all_of(blades.begin(), blades.end(),
                      [&](const FamilyBlade& other) { return shows(other, name); });
      if (!is_common)
        left_out.push_back(outputs[k].name);
      else if (&blade == &blades[0])
        chosen.push_back(static_cast<Index>(k));
    }
  }
  return chosen;
}

/// Returns the columns for the hub's coordinates x, which turn.
SecondOrder make_hub_columns(std::size_t i, const steady::OutputDerivatives& by,
                             const Linearised& all) {
  const steady::HubKinematics hub = make_hub_kinematics(all.model.rotor(all.model.hub_of(i)));
  SecondOrder columns{by.by_acceleration, by.by_twist + by.by_acceleration * hub.P1,
                      by.by_turn + by.by_twist * hub.W + by.by_acceleration * hub.P0};
  const MatrixXd following = find_following(i, all);
  if (following.size() > 0) {
    columns.C += by.by_v * following;
    columns.K += by.by_q * following;
  }
  return columns;
}

/// Appends rows that are zero.
MatrixXd extend(const MatrixXd& top, Index rows) {
  MatrixXd extended = MatrixXd::Zero(top.rows() + rows, top.cols());
  extended.topRows(top.rows()) = top;
  return extended;
}

/// What a shaft shows at an azimuth, along standing axes: rows by its coordinates as they are seen
/// from outside, by their rates, and by the hub's.
struct ShaftRows {
  MatrixXd by_y, by_rate;
  SecondOrder by_hub;
};

/// `by`: along the hub's axes, with a row each for coordinates of joints behind the outputs.
ShaftRows stand_rows(double psi, const BladeFamily& family, const FamilyBlade& shaft,
                     const steady::OutputDerivatives& by, const Linearised& all,
                     const StandingAxes& axes) {
  const MatrixXd back = turn_by(family.turn, -psi);
  MatrixXd turn = MatrixXd::Identity(by.by_q.rows(), by.by_q.rows());
  turn.topLeftCorner(shaft.outputs.count, shaft.outputs.count) =
      shaft.model->turn_outputs(shaft.own, -psi);
  const steady::LinearSubsystem& own = all.linear.subsystem(shaft.subsystem);
  const MatrixXd by_y = turn * by_independent(by.by_q, by.by_forces, own);
  const MatrixXd by_rate = turn * by_independent(by.by_v, MatrixXd(), own);
  const SecondOrder hub = stand_columns(make_hub_columns(shaft.subsystem, by, all), axes);
  const MatrixXd T = axes.T.at(psi).transpose();
  // y = exp(-G psi) z, y' = exp(-G psi) (z' - W G z)
  return {by_y * back - axes.speed * by_rate * back * family.turn,
          by_rate * back,
          {turn * hub.M * T, turn * hub.C * T, turn * hub.K * T}};
}

/// Whether a row is the same in matrices at two azimuths.
bool is_constant(Index row, const ShaftRows& a, const ShaftRows& b) {
  constexpr double kSame = 1e-6;
  const auto same = [row](const MatrixXd& x, const MatrixXd& y) {
    return (x.row(row) - y.row(row)).norm() <= kSame * x.row(row).norm() + 1e-12 * x.norm();
  };
  return same(a.by_y, b.by_y) && same(a.by_rate, b.by_rate) && same(a.by_hub.M, b.by_hub.M) &&
         same(a.by_hub.C, b.by_hub.C) && same(a.by_hub.K, b.by_hub.K);
}

/// Takes derivatives to rows for all outputs of a shaft, and behind them for these coordinates.
steady::OutputDerivatives append_joints(steady::OutputDerivatives by,
                                        const std::vector<Index>& joints) {
  const Index first = by.by_q.rows(), more = std::ssize(joints);
  for (MatrixXd* m :
       {&by.by_q, &by.by_v, &by.by_turn, &by.by_twist, &by.by_acceleration, &by.by_forces})
    *m = extend(*m, more);
  for (Index k = 0; k < more; ++k) by.by_q(first + k, joints[static_cast<std::size_t>(k)]) = 1.0;
  return by;
}

/// Finds what a shaft shows: outputs whose dependence on what is seen from outside is constant.
BladeOutputs find_shaft_outputs(const BladeFamily& family, const Linearised& all,
                                const StandingAxes& axes, std::vector<std::string>& left_out) {
  const FamilyBlade shaft = list_blades(family, all)[0];
  const std::size_t i = shaft.subsystem;
  std::vector<LinearSignal> signals = shaft.model->outputs(shaft.own);
  for (LinearSignal& signal : signals) signal.name = strip(signal.name);
  std::vector<Index> joints;
  for (Index k = 0; k < shaft.coordinates.count; ++k) {
    const steady::SubsystemCoordinate& coordinate =
        shaft.model->coordinates(shaft.own)[static_cast<std::size_t>(k)];
    if (coordinate.node >= 0) continue;
    joints.push_back(shaft.coordinates.first + k);
    signals.push_back({coordinate.name, coordinate.unit()});
  }
  const steady::OutputDerivatives by = append_joints(
      calc_output_derivatives(i, steady::make_state(all.equilibrium.q[i]), all.model), joints);
  const ShaftRows here = stand_rows(0.0, family, shaft, by, all, axes);
  const ShaftRows there = stand_rows(steady::kElsewhere, family, shaft, by, all, axes);
  BladeOutputs outputs;
  std::vector<Index> rows;
  for (std::size_t k = 0; k < signals.size(); ++k) {
    const auto row = static_cast<Index>(k);
    if (!is_constant(row, here, there)) {
      left_out.push_back(shaft.name() + '.' + signals[k].name);
      continue;
    }
    rows.push_back(row);
    if (row < shaft.outputs.count) outputs.shown.push_back(row);
    outputs.signals.push_back(signals[k]);
  }
  const auto take = [&rows](const MatrixXd& m) { return MatrixXd(m(rows, Eigen::all)); };
  outputs.by_y = {take(here.by_y)};
  outputs.by_rate = {take(here.by_rate)};
  outputs.by_hub = {take(here.by_hub.M), take(here.by_hub.C), take(here.by_hub.K)};
  return outputs;
}

}  // namespace

BladeOutputs find_outputs(const BladeFamily& family, const Linearised& all,
                          const StandingAxes& axes, std::vector<std::string>& left_out) {
  if (family.is_shaft()) return find_shaft_outputs(family, all, axes, left_out);
  const std::vector<FamilyBlade> blades = list_blades(family, all);
  const FamilyBlade& blade = blades[0];
  const std::size_t i = blade.subsystem;
  BladeOutputs outputs;
  outputs.shown = choose(blades, left_out);
  for (const Index k : outputs.shown) {
    const LinearSignal& signal = blade.model->outputs(blade.own)[static_cast<std::size_t>(k)];
    outputs.signals.push_back({strip(signal.name), signal.unit});
  }
  const steady::OutputDerivatives by =
      calc_output_derivatives(i, steady::make_state(all.equilibrium.q[i]), all.model);
  std::vector<Index> joints;
  for (Index k = 0; k < blade.coordinates.count; ++k) {
    const steady::SubsystemCoordinate& coordinate =
        blade.model->coordinates(blade.own)[static_cast<std::size_t>(k)];
    if (coordinate.node >= 0) continue;
    joints.push_back(blade.coordinates.first + k);
    outputs.signals.push_back({coordinate.name, coordinate.unit()});
  }
  const Index more = std::ssize(joints);
  const MatrixXd turn = blade.model->turn_outputs(blade.own, family.azimuths[0]);
  const auto rows = [&](const MatrixXd& m) {
    const MatrixXd turned = turn * m.middleRows(blade.outputs.first, blade.outputs.count);
    return extend(MatrixXd(turned(outputs.shown, Eigen::all)), more);
  };
  steady::OutputDerivatives all_rows{rows(by.by_q),
                                     rows(by.by_v),
                                     rows(by.by_turn),
                                     rows(by.by_twist),
                                     rows(by.by_acceleration),
                                     rows(by.by_forces)};
  for (Index k = 0; k < more; ++k)
    all_rows.by_q(std::ssize(outputs.shown) + k, joints[static_cast<std::size_t>(k)]) = 1.0;
  const auto split = [&](const MatrixXd& m, const MatrixXd& by_forces) {
    const MatrixXd by_y = by_independent(m, by_forces, all.linear.subsystem(i));
    std::vector<MatrixXd> parts;
    for (const FamilyBlade& other : blades)
      if (other.subsystem == i)
        parts.push_back(by_y.middleCols(other.independent.first, other.independent.count));
    return parts;
  };
  outputs.by_y = split(all_rows.by_q, all_rows.by_forces);
  outputs.by_rate = split(all_rows.by_v, MatrixXd());
  const SecondOrder standing = stand_columns(make_hub_columns(i, all_rows, all), axes);
  const MatrixXd T = axes.T.at(family.azimuths[0]);
  outputs.by_hub = {standing.M * T, standing.C * T, standing.K * T};
  return outputs;
}

}  // namespace spoke::vibration
