// Derivatives of what a blade shows, along axes that go with it.

#include "engine/small_motions/vibration/multi_blade_outputs.h"

#include <algorithm>

#include "engine/small_motions/steady/output_derivatives.h"
#include "engine/small_motions/vibration/multi_blade_inputs.h"

namespace spoke::vibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Returns the name of an output without that of its blade: "tip.x".
std::string strip(const std::string& name) { return name.substr(name.find('.') + 1); }

bool shows(std::size_t i, const std::string& stripped, const steady::SteadyModel& model) {
  const std::vector<LinearSignal>& outputs = model.outputs(i);
  return std::any_of(outputs.begin(), outputs.end(),
                     [&](const LinearSignal& signal) { return strip(signal.name) == stripped; });
}

/// Returns the outputs of the first blade that all have, and lists the others.
std::vector<Index> choose(const BladeFamily& family, const steady::SteadyModel& model,
                          std::vector<std::string>& left_out) {
  std::vector<Index> chosen;
  for (const std::size_t i : family.blades) {
    const std::vector<LinearSignal>& outputs = model.outputs(i);
    for (std::size_t k = 0; k < outputs.size(); ++k) {
      const std::string name = strip(outputs[k].name);
      const bool is_common =
          std::all_of(family.blades.begin(), family.blades.end(),
                      [&](std::size_t other) { return shows(other, name, model); });
      if (!is_common)
        left_out.push_back(outputs[k].name);
      else if (i == family.blades[0])
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
  const std::size_t i = family.blades[0];
  const steady::SteadyModel& model = all.model;
  const double azimuth = family.azimuths[0];
  BladeOutputs outputs;
  outputs.shown = choose(family, model, left_out);
  for (const Index k : outputs.shown) {
    const LinearSignal& signal = model.outputs(i)[static_cast<std::size_t>(k)];
    outputs.signals.push_back({strip(signal.name), signal.unit});
  }
  const steady::OutputDerivatives by =
      calc_output_derivatives(i, steady::make_state(all.equilibrium.q[i]), all.model);
  std::vector<Index> joints;
  for (std::size_t k = 0; k < model.coordinates(i).size(); ++k) {
    const steady::SubsystemCoordinate& coordinate = model.coordinates(i)[k];
    if (coordinate.node >= 0) continue;
    joints.push_back(static_cast<Index>(k));
    outputs.signals.push_back({coordinate.name, coordinate.turns ? "rad" : "m"});
  }
  const Index more = std::ssize(joints);
  const MatrixXd turn = model.turn_outputs(i, azimuth);
  const auto rows = [&](const MatrixXd& m) {
    return extend(MatrixXd((turn * m)(outputs.shown, Eigen::all)), more);
  };
  steady::OutputDerivatives all_rows{rows(by.by_q), rows(by.by_v), rows(by.by_turn),
                                     rows(by.by_twist), rows(by.by_acceleration)};
  for (Index k = 0; k < more; ++k)
    all_rows.by_q(std::ssize(outputs.shown) + k, joints[static_cast<std::size_t>(k)]) = 1.0;
  const MatrixXd& Z = all.linear.subsystem(i).basis;
  const auto reduce = [&](const MatrixXd& m) { return Z.rows() > 0 ? MatrixXd(m * Z) : m; };
  outputs.by_y = reduce(all_rows.by_q);
  outputs.by_rate = reduce(all_rows.by_v);
  const SecondOrder standing = stand_columns(make_hub_columns(i, all_rows, all), axes);
  const MatrixXd T = axes.T.at(azimuth);
  outputs.by_hub = {standing.M * T, standing.C * T, standing.K * T};
  return outputs;
}

}  // namespace spoke::vibration
