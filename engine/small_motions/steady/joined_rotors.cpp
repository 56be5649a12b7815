// Puts the blocks of rotors into larger matrices, and takes them out.

#include "engine/small_motions/steady/joined_rotors.h"

#include <algorithm>
#include <cassert>

namespace spoke::steady {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr Index kTwist = 6;

Index at(std::size_t rotor) { return kTwist * static_cast<Index>(rotor); }

MatrixXd place_columns(const MatrixXd& m, std::size_t rotor, std::size_t count) {
  MatrixXd placed = MatrixXd::Zero(m.rows(), at(count));
  placed.middleCols(at(rotor), kTwist) = m;
  return placed;
}

MatrixXd place_rows(const MatrixXd& m, std::size_t rotor, std::size_t count) {
  MatrixXd placed = MatrixXd::Zero(at(count), m.cols());
  rows_of(rotor, placed) = m;
  return placed;
}

void append(const Eigen::VectorXd& more, Eigen::VectorXd& list) {
  list.conservativeResize(list.size() + more.size());
  list.tail(more.size()) = more;
}

void set_hub(std::size_t rotor, const MatrixXd& own, MatrixXd& all) {
  all.block(at(rotor), at(rotor), kTwist, kTwist) = own;
}

/// Puts a subsystem's coupling with its hub in its place among those with `count` hubs.
HubCoupling place_coupling(const HubCoupling& own, std::size_t rotor, std::size_t count) {
  HubCoupling placed{place_columns(own.M_bh, rotor, count), place_columns(own.C_bh, rotor, count),
                     place_columns(own.K_bh, rotor, count), place_rows(own.M_hb, rotor, count),
                     place_rows(own.C_hb, rotor, count),    place_rows(own.K_hb, rotor, count)};
  if (own.following.size() > 0) placed.following = place_columns(own.following, rotor, count);
  return placed;
}

}  // namespace

LinearModel join_rotors(const std::vector<LinearModel>& rotors,
                        const std::vector<std::vector<std::size_t>>& subsystems) {
  assert(rotors.size() == subsystems.size());
  const std::size_t count = rotors.size();
  std::size_t size = 0;
  for (const std::vector<std::size_t>& own : subsystems) size += own.size();
  LinearModel all;
  all.M = all.C = all.K = MatrixXd::Zero(at(count), at(count));
  all.subsystems.resize(size);
  all.couplings.resize(size);
  all.alike.resize(size);
  for (std::size_t r = 0; r < count; ++r) {
    const LinearModel& rotor = rotors[r];
    set_hub(r, rotor.M, all.M);
    set_hub(r, rotor.C, all.C);
    set_hub(r, rotor.K, all.K);
    const std::vector<std::size_t>& numbers = subsystems[r];
    for (std::size_t own = 0; own < numbers.size(); ++own) {
      all.subsystems[numbers[own]] = rotor.subsystems[own];
      all.couplings[numbers[own]] = place_coupling(rotor.couplings[own], r, count);
      all.alike[numbers[own]] = numbers[rotor.alike[own]];
    }
    append(rotor.round_off.force, all.round_off.force);
    append(rotor.round_off.step, all.round_off.step);
    all.rate = std::max(all.rate, rotor.rate);
  }
  return all;
}

LinearModel take_rotor(const LinearModel& all, std::size_t rotor,
                       const std::vector<std::size_t>& numbers) {
  const Index first = at(rotor);
  const auto block = [first](const MatrixXd& m) -> MatrixXd {
    return m.block(first, first, kTwist, kTwist);
  };
  const auto columns = [first](const MatrixXd& m) -> MatrixXd {
    return m.middleCols(first, kTwist);
  };
  const auto rows = [rotor](const MatrixXd& m) -> MatrixXd { return rows_of(rotor, m); };
  LinearModel taken;
  taken.M = block(all.M);
  taken.C = block(all.C);
  taken.K = block(all.K);
  for (const std::size_t i : numbers) {
    taken.subsystems.push_back(all.subsystems[i]);
    const HubCoupling& own = all.couplings[i];
    taken.couplings.push_back({columns(own.M_bh), columns(own.C_bh), columns(own.K_bh),
                               rows(own.M_hb), rows(own.C_hb), rows(own.K_hb)});
    if (own.following.size() > 0) taken.couplings.back().following = columns(own.following);
    const auto like = std::find(numbers.begin(), numbers.end(), all.alike[i]);
    taken.alike.push_back(static_cast<std::size_t>(like - numbers.begin()));
  }
  taken.round_off = {all.round_off.force.segment(first, kTwist),
                     all.round_off.step.segment(first, kTwist)};
  taken.rate = all.rate;
  return taken;
}

}  // namespace spoke::steady
