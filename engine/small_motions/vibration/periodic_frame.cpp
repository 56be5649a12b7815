// Joins rotors that turn, each at its azimuth, with rotors in multi-blade coordinates.

#include "engine/small_motions/vibration/periodic_frame.h"

#include <numbers>
#include <numeric>
#include <utility>

#include "engine/small_motions/steady/azimuths.h"
#include "engine/small_motions/steady/joined_rotors.h"
#include "engine/small_motions/steady/supported_model.h"
#include "engine/small_motions/vibration/fixed_modes.h"
#include "engine/small_motions/vibration/require_period.h"

namespace spoke::vibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using steady::LinearModel;

/// Parts of a turn at which matrices of fourth degree are found.
constexpr std::size_t kParts = 9;

/// Returns the part of a turn at which a rotor is while one of speed `leading` is at `part`.
std::size_t find_part(double speed, double leading, std::size_t part) {
  if (speed == 0.0) return 0;
  return (speed > 0.0) == (leading > 0.0) ? part : (kParts - part) % kParts;
}

}  // namespace

PeriodicFrame::PeriodicFrame(const Linearised& all) : all_(all) {
  numbers_.resize(all.model.subsystems());
  std::iota(numbers_.begin(), numbers_.end(), std::size_t{0});
  if (all.model.on_support()) take_seats();
}

void PeriodicFrame::take_seats() {
  const steady::SupportedModel& machine = *all_.model.on_support();
  std::vector<FixedFrame> frames;
  std::vector<std::vector<std::size_t>> subsystems;
  std::size_t next = 0, patterns = 0;
  for (const bool is_outside : require_period(all_, {})) {
    const std::size_t r = seats_.size();
    const std::vector<std::size_t>& own = machine.parts(r).subsystems;
    Seat& seat = seats_.emplace_back(
        Seat{is_outside, is_outside ? 0.0 : machine.parts(r).speed, frames.size(), own});
    if (is_outside) {
      frames.push_back(see_rotor_from_outside(r, all_));
      subsystems.push_back(own);
      seat.parts.resize(frames.back().patterns.size());
      std::iota(seat.parts.begin(), seat.parts.end(), patterns);
      patterns += seat.parts.size();
    }
    seat.starts.resize(seat.parts.size());
    std::iota(seat.starts.begin(), seat.starts.end(), next);
    next += seat.parts.size();
    for (std::size_t k = 0; k < own.size() && !is_outside; ++k) numbers_[own[k]] = seat.starts[k];
  }
  outside_ = join(frames, subsystems);
  numbers_[machine.support_index()] = next;
}

bool PeriodicFrame::is_outside(std::size_t subsystem) const {
  return !seats_.empty() && !all_.model.stands(subsystem) &&
         seats_[all_.model.on_support()->rotor_of(subsystem)].is_outside;
}

std::vector<std::size_t> PeriodicFrame::patterns_of(std::size_t subsystem) const {
  return seats_[all_.model.on_support()->rotor_of(subsystem)].parts;
}

VectorXcd PeriodicFrame::motion_outside(const VectorXcd& x, const PeriodicSystem& system) const {
  VectorXcd motion = VectorXcd::Zero(outside_.start(outside_.patterns.size()));
  for (const Seat& seat : seats_)
    for (std::size_t k = 0; k < seat.parts.size() && seat.is_outside; ++k) {
      const std::size_t pattern = seat.parts[k];
      const Index at = outside_.start(pattern), size = outside_.start(pattern + 1) - at;
      motion.segment(at, size) = x.segment(system.starts[seat.starts[k]], size);
    }
  return motion;
}

VectorXcd PeriodicFrame::motion_of(std::size_t i, const VectorXcd& x,
                                   const PeriodicSystem& system) const {
  if (is_outside(i)) return outside_.motion_of(i, motion_outside(x, system));
  return x.segment(system.starts[numbers_[i]], all_.linear.subsystem(i).M.rows());
}

/// Returns the speed of the first rotor whose matrices turn.
double PeriodicFrame::speed() const {
  if (seats_.empty()) return all_.model.speed();
  for (const Seat& seat : seats_)
    if (seat.speed != 0.0) return seat.speed;
  return 0.0;
}

/// Returns the standing axes of all hubs, by the azimuth of the first one whose matrices turn:
/// those of others are as fast as it, or turn against it, or stand.
StandingAxes PeriodicFrame::make_axes() const {
  const std::vector<int>& components = all_.model.free_components();
  if (seats_.empty()) return make_standing_axes(components, all_.model.is_spatial(), speed());
  const Index count = 6 * std::ssize(seats_);
  const MatrixXd zero = MatrixXd::Zero(count, count);
  StandingAxes all{{zero, zero, zero}, zero, speed()};
  Index at = 0;
  for (const Seat& seat : seats_) {
    const StandingAxes own = make_standing_axes(components, true, seat.speed);
    const double sense = (seat.speed > 0.0) == (all.speed > 0.0) ? 1.0 : -1.0;
    const bool stands = seat.speed == 0.0;
    all.W.block<6, 6>(at, at) = own.W;
    all.T.mean.block<6, 6>(at, at) = stands ? own.T.at(0.0) : own.T.mean;
    if (!stands) {
      all.T.cosine.block<6, 6>(at, at) = own.T.cosine;
      all.T.sine.block<6, 6>(at, at) = sense * own.T.sine;
    }
    at += 6;
  }
  return all;
}

/// Returns the model where the first rotor that turns is at a part of a turn. `turned`: linear
/// models with all hubs at each part, or one that is theirs at every part.
LinearModel PeriodicFrame::join_at(std::size_t part, const std::vector<LinearModel>& turned) const {
  const auto at = [&](std::size_t k) -> const LinearModel& {
    return turned[turned.size() == 1 ? 0 : k];
  };
  if (seats_.empty()) return at(part);
  std::vector<LinearModel> rotors;
  std::vector<std::vector<std::size_t>> numbers;
  for (std::size_t r = 0; r < seats_.size(); ++r) {
    const Seat& seat = seats_[r];
    const LinearModel& of =
        seat.is_outside ? outside_.model : at(find_part(seat.speed, speed(), part));
    rotors.push_back(steady::take_rotor(of, seat.is_outside ? seat.place : r, seat.parts));
    numbers.push_back(seat.starts);
  }
  LinearModel all = steady::join_rotors(rotors, numbers);
  all.subsystems.push_back(all_.linear.subsystems.back());  // the support
  all.couplings.push_back(all_.linear.couplings.back());
  all.alike.push_back(all.alike.size());
  return all;
}

/// Takes rotors to standing axes at their hubs. What springs do that a hub turns against, which
/// meet the axes of the hub twice, is of second degree, beside turning the hub's own coordinates
/// and equations.
PeriodicSystem PeriodicFrame::make_on_hubs() const {
  const StandingAxes axes = make_axes();
  PeriodicSystem system = make_periodic(join_at(0, {all_.linear}), axes);
  if (!steady::depends_on_azimuth(all_.model)) return system;
  const auto azimuth = [](std::size_t part) {
    return 2.0 * std::numbers::pi * static_cast<double>(part) / static_cast<double>(kParts);
  };
  std::vector<LinearModel> turned;
  for (std::size_t part = 0; part < kParts; ++part)
    turned.push_back(steady::linearize_at(azimuth(part), all_.equilibrium, all_.model));
  std::vector<MatrixXd> M, C, K;
  for (std::size_t part = 0; part < kParts; ++part) {
    const PeriodicSystem there = make_periodic(join_at(part, turned), axes);
    M.push_back(there.M.at(azimuth(part)));
    C.push_back(there.C.at(azimuth(part)));
    K.push_back(there.K.at(azimuth(part)));
  }
  system.M = interpolate(M);
  system.C = interpolate(C);
  system.K = interpolate(K);
  return system;
}

PeriodicSystem PeriodicFrame::make_system() const {
  PeriodicSystem system = make_on_hubs();
  if (const auto& support = all_.linear.support)
    system = stand_on(system, support->J, {support->M, support->C, support->K});
  if (seats_.size() > 1) return system;
  system.alike = all_.linear.alike;
  system.azimuths = all_.model.azimuths();
  return system;
}

}  // namespace spoke::vibration
