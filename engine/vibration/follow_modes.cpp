// Pairs modes of neighbouring states by their shapes.

#include "engine/vibration/follow_modes.h"

#include <algorithm>
#include <complex>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace spoke::vibration {
namespace {

/// Smallest modal assurance criterion at which a mode continues the one before.
constexpr double kLeastLikeness = 0.3;

/// Returns the first subsystem that moves in a mode.
std::size_t first_subsystem(const Mode& mode) {
  return static_cast<std::size_t>(std::find_if(mode.shape.begin(), mode.shape.end(),
                                               [](const auto& nodes) { return !nodes.empty(); }) -
                                  mode.shape.begin());
}

/// Returns the modal assurance criterion of two modes, from 0 to 1, or of one with the conjugate of
/// the other.
double likeness(const Mode& a, const Mode& b, bool is_conjugate) {
  if (a.coordinates.size() != b.coordinates.size() || first_subsystem(a) != first_subsystem(b))
    return 0.0;
  const std::complex<double> product = is_conjugate ? a.coordinates.conjugate().dot(b.coordinates)
                                                    : a.coordinates.dot(b.coordinates);
  return std::norm(product) / (a.coordinates.squaredNorm() * b.coordinates.squaredNorm());
}

/// Gives each branch that has none yet its mode at state k, by those at state `before`.
void follow(std::size_t before, std::size_t k, bool is_conjugate,
            const std::vector<ModesResult>& states, std::vector<CampbellBranch>& branches) {
  struct Pair {
    double likeness;
    std::size_t branch, mode;
  };
  std::vector<Pair> pairs;
  const std::vector<Mode>& modes = states[k].modes;
  std::vector<bool> is_taken(modes.size());
  for (const CampbellBranch& branch : branches)
    if (branch.modes[k]) is_taken[*branch.modes[k]] = true;
  for (std::size_t b = 0; b < branches.size(); ++b) {
    const std::optional<std::size_t> last = branches[b].modes[before];
    if (!last) continue;
    for (std::size_t m = 0; m < modes.size(); ++m)
      pairs.push_back({likeness(states[before].modes[*last], modes[m], is_conjugate), b, m});
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& a, const Pair& b) { return a.likeness > b.likeness; });
  for (const Pair& pair : pairs) {
    std::optional<std::size_t>& mode = branches[pair.branch].modes[k];
    if (pair.likeness < kLeastLikeness || mode || is_taken[pair.mode]) continue;
    mode = pair.mode;
    is_taken[pair.mode] = true;
  }
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

}  // namespace

std::vector<CampbellBranch> follow_modes(const std::vector<ModesResult>& states, int count,
                                         ThroughZero through_zero) {
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < states.size(); ++k)
    if (!states[k].modes.empty()) found.push_back(k);
  if (found.size() < 2) return {};  // nothing vibrates
  std::vector<CampbellBranch> branches = begin_branches(found[0], states, count);
  for (std::size_t i = 1; i < found.size(); ++i) {
    follow(found[i - 1], found[i], false, states, branches);
    if (through_zero == ThroughZero::yes) follow(found[i - 1], found[i], true, states, branches);
  }
  // Subsystems that differ at rest by gravity are alike as soon as the hub turns.
  std::erase_if(branches, [&](const CampbellBranch& branch) { return !branch.modes[found[1]]; });
  for (CampbellBranch& branch : branches) name(states, branch);
  return branches;
}

}  // namespace spoke::vibration
