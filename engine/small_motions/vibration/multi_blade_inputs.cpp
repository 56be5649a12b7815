// Compares the effects of inputs on equal blades, at three azimuths of the hub.

#include "engine/small_motions/vibration/multi_blade_inputs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <utility>

#include "engine/small_motions/vibration/family_blades.h"
#include "engine/small_motions/vibration/shaft_turn.h"

namespace spoke::vibration {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using steady::InputEffect;
using steady::LoadEffect;

/// Effects are linear in the direction of a load, so that three azimuths say all.
constexpr int kAzimuths = 3;
constexpr double kNegligible = 1e-9, kAlikeEffects = 1e-6;  // of effects' sizes

double azimuth_of(int sample) { return 2.0 * std::numbers::pi * sample / kAzimuths; }

/// The effects of all inputs, at each azimuth.
using Samples = std::array<std::vector<InputEffect>, kAzimuths>;

Samples sample_effects(const Scenario& scenario, const Linearised& all) {
  Samples samples;
  for (int k = 0; k < kAzimuths; ++k)
    samples[static_cast<std::size_t>(k)] =
        calc_effects_at(azimuth_of(k), scenario, all.equilibrium, all.model);
  return samples;
}

bool does_nothing(const LoadEffect& effect) {
  return effect.force.isZero(0.0) && effect.hub_force.isZero(0.0) && effect.outputs.isZero(0.0);
}

/// Returns values at the azimuths of the hub as a function of that of a blade, which is `azimuth`
/// further on.
Turning see_over_turn(const std::array<VectorXd, kAzimuths>& values, double azimuth) {
  const MatrixXd zero = MatrixXd::Zero(values[0].size(), 1);
  Turning found{zero, zero, zero};
  for (int k = 0; k < kAzimuths; ++k) {
    const VectorXd& value = values[static_cast<std::size_t>(k)];
    const double psi = azimuth_of(k) + azimuth;
    found.mean += value / kAzimuths;
    found.cosine += 2.0 * std::cos(psi) / kAzimuths * value;
    found.sine += 2.0 * std::sin(psi) / kAzimuths * value;
  }
  const double least =
      kNegligible * std::max({found.mean.norm(), found.cosine.norm(), found.sine.norm()});
  for (MatrixXd* part : {&found.mean, &found.cosine, &found.sine})
    if (part->norm() <= least) part->setZero();
  return found;
}

bool is_same(const Turning& a, const Turning& b) {
  const double size = std::max({a.mean.norm(), a.cosine.norm(), a.sine.norm()});
  return std::max({(a.mean - b.mean).norm(), (a.cosine - b.cosine).norm(),
                   (a.sine - b.sine).norm()}) <= kAlikeEffects * size;
}

/// Finds the inputs of one model.
class InputFinder {
 public:
  InputFinder(const Scenario& scenario, const Linearised& all, const Turning& T)
      : all_(all), T_(T), samples_(sample_effects(scenario, all)) {}

  void add_family(const BladeFamily& family);
  /// Adds what acts on a shaft along standing axes.
  void add_shaft(const BladeFamily& family);
  /// Adds what acts on a subsystem that is no blade of a family.
  void add_subsystem(std::size_t i);
  void add_hub(std::size_t hub);
  MultiBladeInputs take() { return std::move(found_); }

 private:
  /// An input of a blade that has found no place yet.
  struct Open {
    std::string name;
    BladeInput input;
  };

  std::size_t count() const { return samples_[0].size(); }
  const LoadEffect& effect(int sample, std::size_t input, std::size_t i) const {
    return samples_[static_cast<std::size_t>(sample)][input].subsystems[i];
  }
  std::array<VectorXd, kAzimuths> at_azimuths(const std::function<VectorXd(int)>& value) const {
    return {value(0), value(1), value(2)};
  }
  BladeInput see_along_blade(std::size_t input, const std::vector<FamilyBlade>& blades,
                             std::size_t b) const;
  bool acts_on(std::size_t input, const FamilyBlade& blade) const;
  std::vector<Open> list_inputs_of(const std::vector<FamilyBlade>& blades, std::size_t b) const;
  std::optional<VectorXd> stand(const std::array<VectorXd, kAzimuths>& wrench) const;
  void add_wrench(const LinearSignal& signal, std::size_t hub,
                  const std::array<VectorXd, kAzimuths>& wrench);
  LinearSignal name(std::size_t input, const std::string& of) const {
    const LinearSignal& signal = samples_[0][input].input;
    return {of + " / " + signal.name, signal.unit};
  }

  const Linearised& all_;
  const Turning& T_;
  Samples samples_;
  MultiBladeInputs found_;
};

/// `b`: place of the blade in its family.
BladeInput InputFinder::see_along_blade(std::size_t input, const std::vector<FamilyBlade>& blades,
                                        std::size_t b) const {
  const FamilyBlade& blade = blades[b];
  const std::size_t i = blade.subsystem;
  const double azimuth = blade.azimuth();
  const MatrixXd to_blade = T_.at(azimuth).transpose();
  const MatrixXd& Z = all_.linear.subsystem(i).basis;
  const MatrixXd following = find_following(i, all_);
  const auto take = [&](const std::function<VectorXd(const LoadEffect&)>& part) {
    return see_over_turn(at_azimuths([&](int k) { return part(effect(k, input, i)); }), azimuth);
  };
  BladeInput seen{{}, {}, {}, {}};
  seen.force = take([&](const LoadEffect& by) {
    return VectorXd(
        blade.independent.of(Z.rows() > 0 ? VectorXd(Z.transpose() * by.force) : by.force));
  });
  seen.hub = take([&](const LoadEffect& by) {
    VectorXd on_hub = by.hub_force;
    if (following.size() > 0) on_hub += following.transpose() * by.force;
    return VectorXd(to_blade * on_hub);
  });
  for (std::size_t k = 0; k < blades.size(); ++k) {
    const FamilyBlade& other = blades[(b + k) % blades.size()];
    if (other.subsystem != i) continue;
    const MatrixXd turn = other.model->turn_outputs(other.own, other.azimuth());
    seen.outputs.push_back(
        take([&](const LoadEffect& by) { return VectorXd(turn * other.outputs.of(by.outputs)); }));
  }
  return seen;
}

/// Whether an input acts on a blade: of several that loops tie it is the one with a force.
bool InputFinder::acts_on(std::size_t input, const FamilyBlade& blade) const {
  constexpr double kHandedOver = 1e-9;  // of the force, as round-off by ties
  for (int sample = 0; sample < kAzimuths; ++sample) {
    const LoadEffect& by = effect(sample, input, blade.subsystem);
    const bool is_alone = blade.coordinates.count == by.force.size();
    if (is_alone ? !does_nothing(by)
                 : blade.coordinates.of(by.force).norm() > kHandedOver * by.force.norm())
      return true;
  }
  return false;
}

std::vector<InputFinder::Open> InputFinder::list_inputs_of(const std::vector<FamilyBlade>& blades,
                                                           std::size_t b) const {
  std::vector<Open> list;
  for (std::size_t k = 0; k < count(); ++k) {
    if (!acts_on(k, blades[b])) continue;
    Open& open = list.emplace_back(Open{samples_[0][k].input.name, see_along_blade(k, blades, b)});
    open.input.input = name(k, blades[b].name());
  }
  return list;
}

void InputFinder::add_family(const BladeFamily& family) {
  const std::vector<FamilyBlade> blades = list_blades(family, all_);
  std::vector<std::vector<Open>> open;
  for (std::size_t b = 0; b < blades.size(); ++b) open.push_back(list_inputs_of(blades, b));
  std::vector<BladeInput>& list = found_.families.emplace_back();
  for (Open& first : open[0]) {
    // Of inputs that do the same those of one name go together, and loads that name each its own
    // blade.
    std::vector<std::vector<Open>::iterator> others;
    std::string names = first.name;
    for (std::size_t b = 1; b < open.size(); ++b) {
      const auto does_same = [&](const Open& other) {
        return is_same(first.input.force, other.input.force) &&
               is_same(first.input.hub, other.input.hub);
      };
      auto found = std::find_if(open[b].begin(), open[b].end(), [&](const Open& other) {
        return other.name == first.name && does_same(other);
      });
      if (found == open[b].end()) found = std::find_if(open[b].begin(), open[b].end(), does_same);
      if (found == open[b].end()) break;
      if (found->name != first.name) names += ", " + found->name;
      others.push_back(found);
    }
    if (others.size() + 1 < open.size()) {
      found_.left_out.push_back(first.input.input.name);
      continue;
    }
    for (std::size_t b = 1; b < open.size(); ++b) open[b].erase(others[b - 1]);
    BladeInput& input = list.emplace_back(std::move(first.input));
    input.input.name = name_family(family, all_.model) + " / " + names;
  }
  for (std::size_t b = 1; b < open.size(); ++b)
    for (const Open& left : open[b]) found_.left_out.push_back(left.input.input.name);
}

/// Returns the mean of values at the azimuths that are the same; none if they are not.
std::optional<VectorXd> find_common(const std::array<VectorXd, kAzimuths>& values) {
  VectorXd mean = VectorXd::Zero(values[0].size());
  for (const VectorXd& value : values) mean += value / kAzimuths;
  for (const VectorXd& value : values)
    if ((value - mean).norm() > kAlikeEffects * value.norm()) return std::nullopt;
  return mean;
}

/// Returns the wrench along standing axes; none if it turns.
std::optional<VectorXd> InputFinder::stand(const std::array<VectorXd, kAzimuths>& wrench) const {
  return find_common(at_azimuths(
      [&](int k) { return VectorXd(T_.at(azimuth_of(k)) * wrench[static_cast<std::size_t>(k)]); }));
}

void InputFinder::add_shaft(const BladeFamily& family) {
  const FamilyBlade shaft = list_blades(family, all_)[0];
  const std::size_t i = shaft.subsystem;
  const MatrixXd& Z = all_.linear.subsystem(i).basis;
  const MatrixXd following = find_following(i, all_);
  std::vector<BladeInput>& list = found_.families.emplace_back();
  for (std::size_t k = 0; k < count(); ++k) {
    if (!acts_on(k, shaft)) continue;
    const auto force = find_common(at_azimuths([&](int sample) {
      const VectorXd& by = effect(sample, k, i).force;
      return VectorXd(turn_by(family.turn, -azimuth_of(sample)).transpose() *
                      (Z.rows() > 0 ? VectorXd(Z.transpose() * by) : by));
    }));
    const auto on_hub = stand(at_azimuths([&](int sample) {
      const LoadEffect& by = effect(sample, k, i);
      return following.size() > 0 ? VectorXd(by.hub_force + following.transpose() * by.force)
                                  : VectorXd(by.hub_force);
    }));
    const LinearSignal signal = name(k, shaft.name());
    if (!force || !on_hub) {
      found_.left_out.push_back(signal.name);
      continue;
    }
    VectorXd shown = VectorXd::Zero(shaft.outputs.count);
    for (int sample = 0; sample < kAzimuths; ++sample)
      shown += shaft.model->turn_outputs(shaft.own, -azimuth_of(sample)) *
               shaft.outputs.of(effect(sample, k, i).outputs) / kAzimuths;
    const auto standing = [](const VectorXd& mean) {
      const MatrixXd zero = MatrixXd::Zero(mean.size(), 1);
      return Turning{mean, zero, zero};
    };
    list.push_back({signal, standing(*force), standing(*on_hub), {standing(shown)}});
  }
}

/// Adds an input by what it does to a hub at the azimuths.
void InputFinder::add_wrench(const LinearSignal& signal, std::size_t hub,
                             const std::array<VectorXd, kAzimuths>& wrench) {
  if (const std::optional<VectorXd> standing = stand(wrench))
    found_.standing.push_back({signal, hub, *standing, {}});
  else
    found_.left_out.push_back(signal.name);
}

void InputFinder::add_subsystem(std::size_t i) {
  for (std::size_t k = 0; k < count(); ++k) {
    const LoadEffect& first = effect(0, k, i);
    const LinearSignal signal = name(k, all_.model.name_of(i));
    if (all_.model.stands(i)) {
      if (!does_nothing(first))
        found_.standing.push_back({signal, 0, VectorXd::Zero(T_.mean.rows()), first});
      continue;
    }
    const auto wrench = at_azimuths([&](int s) { return effect(s, k, i).hub_force; });
    if (std::all_of(wrench.begin(), wrench.end(), [](const VectorXd& w) { return w.isZero(0.0); }))
      continue;
    add_wrench(signal, all_.model.hub_of(i), wrench);
  }
}

void InputFinder::add_hub(std::size_t hub) {
  for (std::size_t k = 0; k < count(); ++k) {
    const auto wrench =
        at_azimuths([&](int s) { return samples_[static_cast<std::size_t>(s)][k].hubs[hub]; });
    if (std::all_of(wrench.begin(), wrench.end(), [](const VectorXd& w) { return w.isZero(0.0); }))
      continue;
    add_wrench(name(k, all_.model.prefix_of(hub) + "hub"), hub, wrench);
  }
}

}  // namespace

std::string name_family(const BladeFamily& family, const steady::SteadyModel& model) {
  std::vector<std::size_t> blades = family.blades;
  std::sort(blades.begin(), blades.end());
  return name_subsystems(blades, model);
}

MatrixXd find_following(std::size_t subsystem, const Linearised& all) {
  if (!all.linear.is_coupled()) return {};
  const MatrixXd& by_free = all.linear.couplings[subsystem].following;
  const Eigen::Index d = all.model.twist_size();
  if (by_free.size() == 0) return by_free;
  if (all.linear.support)
    return by_free.middleCols(d * static_cast<Eigen::Index>(all.model.hub_of(subsystem)), d);
  MatrixXd following = MatrixXd::Zero(by_free.rows(), d);
  following(Eigen::all, all.model.free_components()) = by_free;
  return following;
}

MultiBladeInputs find_inputs(const Scenario& scenario, const Linearised& all,
                             const FixedFrame& frame, const Turning& T) {
  InputFinder finder(scenario, all, T);
  std::vector<bool> is_blade(all.model.subsystems(), false);
  for (const BladeFamily& family : frame.families) {
    family.is_shaft() ? finder.add_shaft(family) : finder.add_family(family);
    for (const std::size_t i : family.blades) is_blade[i] = true;
  }
  for (std::size_t i = 0; i < is_blade.size(); ++i)
    if (!is_blade[i]) finder.add_subsystem(i);
  if (all.linear.is_coupled())
    for (std::size_t h = 0; h < all.model.hubs(); ++h) finder.add_hub(h);
  return finder.take();
}

}  // namespace spoke::vibration
