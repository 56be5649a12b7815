// Joins the matches of neighbouring states, with steps that adapt.

#include "engine/small_motions/vibration/follow_modes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace spoke::vibration {
namespace {

using List = std::vector<std::size_t>;

/// A state between others, at its value.
struct At {
  const ModesResult& state;
  double value = 0.0;
};

/// Follows modes from one state to the next one.
class Link {
 public:
  Link(ThroughZero through_zero, const BetweenStates* between)
      : through_zero_(through_zero), between_(between) {}

  /// `followed`: modes of the first state that matter.
  ModeMatch make(const At& from, const At& to, const List& followed, int depth = 0) {
    ModeMatch match = match_modes(from.state, to.state, through_zero_);
    if (!between_ || depth == kDeepest || left_ == 0) return match;
    const std::optional<double> share = find_split(from.state, to.state, match, followed);
    if (!share) return match;
    const double value = from.value + *share * (to.value - from.value);
    --left_;
    const std::optional<ModesResult> middle = between_->solve(value);
    if (!middle || middle->modes.empty()) return match;
    const At between{*middle, value};
    const ModeMatch first = make(from, between, followed, depth + 1);
    List images;
    for (const std::size_t m : followed)
      if (first.next[m]) images.push_back(*first.next[m]);
    return join(first, make(between, to, images, depth + 1));
  }

 private:
  static constexpr int kDeepest = 12;         ///< halvings of a step
  static constexpr double kAlike = 0.9;       ///< likeness at which a match is not looked into
  static constexpr double kMeet = 1e-3;       ///< distance of frequencies that meet, by their size
  static constexpr double kUncoupled = 1e-8;  ///< criterion of shapes that pass each other by

  static ModeMatch join(const ModeMatch& first, const ModeMatch& second) {
    ModeMatch match{std::vector<std::optional<std::size_t>>(first.next.size()), first.likeness, {}};
    for (std::size_t m = 0; m < first.next.size(); ++m) {
      if (!first.next[m]) continue;
      match.next[m] = second.next[*first.next[m]];
      match.likeness[m] = std::min(match.likeness[m], second.likeness[*first.next[m]]);
    }
    return match;
  }

  /// Returns where between two states to look, from 0 to 1: where frequencies cross, though shapes
  /// know of each other, or halfway where shapes are not alike; none if the match is good.
  static std::optional<double> find_split(const ModesResult& from, const ModesResult& to,
                                          const ModeMatch& match, const List& followed) {
    for (const std::size_t m : followed)
      if (!match.next[m] || match.likeness[m] < kAlike) return 0.5;
    for (const std::size_t m : followed)
      for (std::size_t other = 0; other < match.next.size(); ++other)
        if (other != m && match.next[other])
          if (const auto share = find_crossing(from, to, match, m, other)) return share;
    return std::nullopt;
  }

  static std::optional<double> find_crossing(const ModesResult& from, const ModesResult& to,
                                             const ModeMatch& match, std::size_t m,
                                             std::size_t other) {
    const auto frequency = [](const ModesResult& state, std::size_t k) {
      return state.modes[k].frequency;
    };
    const double before = frequency(from, m) - frequency(from, other);
    const double after = frequency(to, *match.next[m]) - frequency(to, *match.next[other]);
    if (before * after >= 0.0) return std::nullopt;
    const auto criterion = [&](std::size_t a, std::size_t b) {
      return match.criterion(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b));
    };
    const bool meet = std::abs(before) <= kMeet * frequency(from, m) ||
                      std::abs(after) <= kMeet * frequency(to, *match.next[m]);
    const bool is_coupled = criterion(m, *match.next[other]) > kUncoupled ||
                            criterion(other, *match.next[m]) > kUncoupled;
    if (meet || !is_coupled) return std::nullopt;
    return std::clamp(before / (before - after), 0.05, 0.95);
  }

  ThroughZero through_zero_;
  const BetweenStates* between_;
  int left_ = 100;  ///< states that may still be sought
};

/// Gives each branch its mode at state k, by those at state `before`.
void follow(std::size_t before, std::size_t k, const std::vector<ModesResult>& states,
            ThroughZero through_zero, const BetweenStates* between,
            std::vector<CampbellBranch>& branches) {
  List followed;
  for (const CampbellBranch& branch : branches)
    if (branch.modes[before]) followed.push_back(*branch.modes[before]);
  const auto value = [&](std::size_t at) { return between ? between->values[at] : 0.0; };
  const ModeMatch match =
      Link(through_zero, between)
          .make({states[before], value(before)}, {states[k], value(k)}, followed);
  for (CampbellBranch& branch : branches)
    if (branch.modes[before]) branch.modes[k] = match.next[*branch.modes[before]];
}

/// Names a branch as most of its modes are named.
void name(const std::vector<ModesResult>& states, CampbellBranch& branch) {
  std::map<std::pair<std::string, std::string>, int> votes;
  for (std::size_t k = 0; k < states.size(); ++k)
    if (branch.modes[k]) {
      const Mode& mode = states[k].modes[*branch.modes[k]];
      ++votes[{mode.of, mode.name}];
    }
  const auto most = std::max_element(
      votes.begin(), votes.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  branch.of = most->first.first;
  branch.name = most->first.second;
}

/// Makes the branches, which begin with the first modes of each subsystem, or of the whole model,
/// at state k.
std::vector<CampbellBranch> begin_branches(std::size_t k, const std::vector<ModesResult>& states,
                                           int count) {
  std::vector<CampbellBranch> branches;
  std::map<std::string, int> counts;
  const std::vector<Mode>& modes = states[k].modes;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    if (++counts[modes[m].of] > count) continue;
    branches.push_back({{}, {}, std::vector<std::optional<std::size_t>>(states.size())});
    branches.back().modes[k] = m;
  }
  return branches;
}

/// Erases branches of subsystems that have no modes of their own beyond the first state: those that
/// differ at rest by gravity are alike as soon as the hub turns.
void erase_alike(const ModesResult& first, std::size_t at, const ModesResult& second,
                 std::vector<CampbellBranch>& branches) {
  std::erase_if(branches, [&](const CampbellBranch& branch) {
    const std::size_t own = first_subsystem(first.modes[*branch.modes[at]]);
    return std::none_of(second.modes.begin(), second.modes.end(),
                        [own](const Mode& mode) { return first_subsystem(mode) == own; });
  });
}

}  // namespace

std::vector<CampbellBranch> follow_modes(const std::vector<ModesResult>& states, int count,
                                         ThroughZero through_zero, const BetweenStates* between) {
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < states.size(); ++k)
    if (!states[k].modes.empty()) found.push_back(k);
  if (found.size() < 2) return {};  // nothing vibrates
  std::vector<CampbellBranch> branches = begin_branches(found[0], states, count);
  erase_alike(states[found[0]], found[0], states[found[1]], branches);
  for (std::size_t i = 1; i < found.size(); ++i)
    follow(found[i - 1], found[i], states, through_zero, between, branches);
  for (CampbellBranch& branch : branches) name(states, branch);
  return branches;
}

}  // namespace spoke::vibration
