#pragma once

// A model whose subsystems are shared out over several processes: the subsystems of each, and the
// values that they tell one another. Every process has the whole table. Its nodes are those of its
// own subsystems and of the hub; results of others are put into the same places of the table as if
// it had found them itself, so that all that follows has the same bits in every process.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "engine/exchange.h"

namespace spoke {

/// Divides weights into shares of neighbours about equal in sum, none of them empty. Returns the
/// first index of each share, and at the end the number of weights. Precondition: 1 <= shares <=
/// weights.size().
std::vector<int> share_out(std::span<const double> weights, int shares);

/// Steps after which processes meet, at most, unless a window was asked for.
inline constexpr int kMostSharedSteps = 64;

/// Memory in pieces.
using MemoryPieces = std::vector<std::span<std::byte>>;

/// Places in the table that the processes tell one another of.
class SharedPlaces {
 public:
  /// `by_rank`: the places that each rank fills, of the same sizes in all processes.
  SharedPlaces(Exchange& exchange, std::vector<MemoryPieces> by_rank);

  /// Gives the values of the own places to the others, and fills in theirs.
  void share() noexcept;

 private:
  Exchange& exchange_;
  std::vector<MemoryPieces> places_;
  std::vector<std::size_t> first_;  ///< by rank, its first byte
  std::vector<std::byte> bytes_;
};

/// How the subsystems are shared out, and the places that are told at fixed times. Stays in place.
struct Sharing {
  Exchange& exchange;
  std::vector<int> first;  ///< by rank its first subsystem, and at the end their number
  // Places told in every pass where the hub has a free coordinate: effective inertias for the hub's
  // solve, and the bodies' reports for the end of the pass.
  SharedPlaces inertias, reports;
  SharedPlaces state;  ///< state of the subsystems, see state_values.h
  /// Sums of applied forces, told in every pass where the hub flies and tension depends on them.
  std::optional<SharedPlaces> forces;

  int own_first() const { return first[static_cast<std::size_t>(exchange.rank())]; }
  int own_last() const { return first[static_cast<std::size_t>(exchange.rank()) + 1]; }  ///< behind
};

}  // namespace spoke
