// Shares out weights, and packs the values that the processes tell one another.

#include "engine/step/sharing.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

namespace spoke {

std::vector<int> share_out(std::span<const double> weights, int shares) {
  assert(shares >= 1 && static_cast<std::size_t>(shares) <= weights.size());
  const int count = static_cast<int>(weights.size());
  std::vector<double> before(weights.size() + 1, 0.0);
  std::partial_sum(weights.begin(), weights.end(), before.begin() + 1);
  std::vector<int> first{0};
  for (int share = 1; share < shares; ++share) {
    const double bound = before.back() * share / shares;
    const auto nearer = [&](double a, double b) {
      return std::abs(a - bound) < std::abs(b - bound);
    };
    const auto nearest = std::min_element(before.begin(), before.end(), nearer);
    first.push_back(std::clamp(static_cast<int>(nearest - before.begin()), first.back() + 1,
                               count - (shares - share)));
  }
  first.push_back(count);
  return first;
}

SharedPlaces::SharedPlaces(Exchange& exchange, std::vector<MemoryPieces> by_rank)
    : exchange_(exchange), places_(std::move(by_rank)), first_{0} {
  for (const MemoryPieces& places : places_)
    first_.push_back(std::accumulate(
        places.begin(), places.end(), first_.back(),
        [](std::size_t sum, std::span<std::byte> place) { return sum + place.size(); }));
  bytes_.resize(first_.back());
}

void SharedPlaces::share() noexcept {
  const auto own = static_cast<std::size_t>(exchange_.rank());
  std::byte* next = bytes_.data() + first_[own];
  for (const std::span<std::byte> place : places_[own])
    next = std::copy(place.begin(), place.end(), next);
  exchange_.share(bytes_, first_);
  for (std::size_t rank = 0; rank < places_.size(); ++rank) {
    if (rank == own) continue;
    const std::byte* from = bytes_.data() + first_[rank];
    for (const std::span<std::byte> place : places_[rank]) {
      std::copy_n(from, place.size(), place.begin());
      from += place.size();
    }
  }
}

}  // namespace spoke
