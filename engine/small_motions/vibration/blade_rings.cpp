// Turns rings on by one blade, and compares their matrices.

#include "engine/small_motions/vibration/blade_rings.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "engine/small_motions/steady/alike_subsystems.h"
#include "engine/small_motions/steady/azimuths.h"

namespace spoke::vibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using steady::SubsystemPart;

constexpr double kTurnOfRing = 2.0 * std::numbers::pi;
constexpr double kAlikeInRing = 1e-6;

/// The blades of a ring in order, with their places among the independent coordinates.
struct Members {
  std::vector<SubsystemPart> parts;
  std::vector<Index> starts;
  Index size = 0;
};

/// Finds the independent coordinates of each member; `size` is -1 if they are not the same.
Members list_members(std::size_t i, const Linearised& all) {
  Members members{all.model.members(i), {}};
  std::sort(members.parts.begin(), members.parts.end(),
            [](const SubsystemPart& a, const SubsystemPart& b) {
              return a.model->azimuth(a.subsystem) < b.model->azimuth(b.subsystem);
            });
  const std::vector<Index>& independent = all.linear.subsystem(i).independent;
  std::vector<Index> first;
  for (const SubsystemPart& part : members.parts) {
    std::vector<Index> own;
    const auto begin = std::lower_bound(independent.begin(), independent.end(), part.first);
    for (auto k = begin; k != independent.end() && *k < part.first + part.count; ++k)
      own.push_back(*k - part.first);
    members.starts.push_back(begin - independent.begin());
    if (members.starts.size() == 1) first = own;
    if (own != first || part.count != members.parts.front().count) members.size = -1;
  }
  if (members.size == 0) members.size = std::ssize(first);
  return members;
}

/// Whether the members stand at equal angles.
bool stand_evenly(const Members& members) {
  constexpr double kSame = 1e-9;
  const auto count = static_cast<double>(members.parts.size());
  const auto azimuth_of = [](const SubsystemPart& part) {
    return part.model->azimuth(part.subsystem);
  };
  for (std::size_t m = 0; m < members.parts.size(); ++m) {
    const double expected =
        azimuth_of(members.parts[0]) + kTurnOfRing * static_cast<double>(m) / count;
    if (std::abs(azimuth_of(members.parts[m]) - expected) > kSame) return false;
  }
  return true;
}

/// Whether each member is moved by its own independent coordinates alone.
bool move_alone(const Members& members, const MatrixXd& basis) {
  if (basis.rows() == 0) return true;
  const double least = 1e-12 * basis.lpNorm<Eigen::Infinity>();
  for (const SubsystemPart& part : members.parts)
    for (std::size_t m = 0; m < members.parts.size(); ++m) {
      if (members.parts[m].number == part.number) continue;
      const auto by_other = basis.block(part.first, members.starts[m], part.count, members.size);
      if (by_other.size() > 0 && by_other.lpNorm<Eigen::Infinity>() > least) return false;
    }
  return true;
}

/// Returns for each independent coordinate the one that is it on the next blade.
std::vector<Index> list_next(const Members& members) {
  const std::size_t count = members.starts.size();
  std::vector<Index> next(count * static_cast<std::size_t>(members.size));
  for (std::size_t m = 0; m < count; ++m)
    for (Index k = 0; k < members.size; ++k)
      next[static_cast<std::size_t>(members.starts[m] + k)] = members.starts[(m + 1) % count] + k;
  return next;
}

/// Whether the coupling with the hub stays as it is when each blade takes the place of the next.
bool couple_alike(const std::vector<Index>& next, std::size_t i, const Linearised& all) {
  if (!all.linear.is_coupled()) return true;
  const steady::HubCoupling& hub = all.linear.couplings[i];
  const steady::SteadyModel& rotor =
      all.model.rotor(std::min(all.model.hub_of(i), all.model.hubs() - 1));
  const std::vector<int> free = hub.M_bh.cols() == rotor.twist_size()
                                    ? steady::list_components(rotor, steady::HubFreedom::all)
                                    : rotor.free_components();
  const double angle = kTurnOfRing / static_cast<double>(all.model.members(i).size());
  const MatrixXd turn = steady::turn_hub(angle, rotor)(free, free);
  const double rate = std::max(1.0, std::abs(all.model.speed_of(i)));
  const auto differ = [&](const MatrixXd& by_hub, const MatrixXd& on_hub, double size) {
    const double least = kAlikeInRing * (size + by_hub.lpNorm<Eigen::Infinity>());
    return (by_hub(next, Eigen::all) * turn - by_hub).lpNorm<Eigen::Infinity>() > least ||
           (turn.transpose() * on_hub(Eigen::all, next) - on_hub).lpNorm<Eigen::Infinity>() > least;
  };
  const double mass = hub.M_bh.lpNorm<Eigen::Infinity>();
  return !differ(hub.M_bh, hub.M_hb, 0.0) && !differ(hub.C_bh, hub.C_hb, rate * mass) &&
         !differ(hub.K_bh, hub.K_hb, rate * rate * mass);
}

BladeRing find_ring(std::size_t i, const Linearised& all) {
  BladeRing ring;
  const Members members = list_members(i, all);
  ring.is_tied = members.parts.size() > 1;
  const steady::LinearSubsystem& own = all.linear.subsystem(i);
  if (members.parts.size() < 3 || members.size < 0 || !stand_evenly(members) ||
      !move_alone(members, own.basis))
    return ring;
  const std::vector<Index> next = list_next(members);
  const auto turned = [&next](const MatrixXd& m) { return MatrixXd(m(next, next)); };
  const steady::SizedMatrices here = steady::with_sizes(own);
  const steady::SizedMatrices there{turned(here.M), turned(here.C), turned(here.K),
                                    here.K_terms.size() > 0 ? turned(here.K_terms) : here.K_terms};
  if (!steady::are_same(here, there, all.model.speed_of(i)) || !couple_alike(next, i, all))
    return ring;
  for (const SubsystemPart& part : members.parts)
    ring.azimuths.push_back(part.model->azimuth(part.subsystem));
  ring.starts = members.starts;
  ring.size = members.size;
  return ring;
}

}  // namespace

std::vector<BladeRing> find_rings(const Linearised& all) {
  std::vector<BladeRing> rings;
  for (std::size_t i = 0; i < all.model.subsystems(); ++i)
    rings.push_back(all.model.stands(i) ? BladeRing{} : find_ring(i, all));
  return rings;
}

}  // namespace spoke::vibration
