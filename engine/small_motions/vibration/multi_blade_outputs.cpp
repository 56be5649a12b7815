// Derivatives of what a blade shows, along axes that go with it.

#include "engine/small_motions/vibration/multi_blade_outputs.h"

#include <algorithm>

#include "engine/small_motions/steady/output_derivatives.h"
#include "engine/small_motions/vibration/family_blades.h"
#include "engine/small_motions/vibration/multi_blade_inputs.h"

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

}  // namespace

BladeOutputs find_outputs(const BladeFamily& family, const Linearised& all,
                          const StandingAxes& axes, std::vector<std::string>& left_out) {
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
