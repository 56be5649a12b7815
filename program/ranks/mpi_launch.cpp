// Begins and ends MPI, and offers its collective operations to the engine.

#include <mpi.h>

#include <cassert>
#include <exception>
#include <limits>

#include "program/ranks/launch.h"

namespace spoke::ranks {
namespace {

/// An error of MPI ends all processes.
class MpiExchange final : public Exchange {
 public:
  MpiExchange(int rank, int count)
      : rank_(rank), sizes_(static_cast<std::size_t>(count)), first_(sizes_.size()) {}

  int rank() const override { return rank_; }
  int count() const override { return static_cast<int>(sizes_.size()); }
  void share(std::span<std::byte> all, std::span<const std::size_t> first) noexcept override {
    assert(all.size() <= std::numeric_limits<int>::max());
    for (std::size_t r = 0; r < sizes_.size(); ++r) {
      sizes_[r] = static_cast<int>(first[r + 1] - first[r]);
      first_[r] = static_cast<int>(first[r]);
    }
    MPI_Allgatherv(MPI_IN_PLACE, 0, MPI_BYTE, all.data(), sizes_.data(), first_.data(), MPI_BYTE,
                   MPI_COMM_WORLD);
  }

 private:
  int rank_;
  std::vector<int> sizes_, first_;
};

}  // namespace

// Alone, MPI is not begun at all.
Launch::Launch() {
  if (!is_launched()) return;
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &count_);
}

Launch::~Launch() {
  int is_begun = 0;
  MPI_Initialized(&is_begun);
  if (is_begun != 0 && (is_released_ || std::uncaught_exceptions() == 0)) MPI_Finalize();
}

std::uint64_t Launch::broadcast(std::uint64_t number) const {
  if (count_ > 1) MPI_Bcast(&number, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
  return number;
}

std::vector<std::uint64_t> Launch::gather(std::uint64_t number) const {
  std::vector<std::uint64_t> all(static_cast<std::size_t>(count_), number);
  if (count_ > 1)
    MPI_Allgather(&number, 1, MPI_UINT64_T, all.data(), 1, MPI_UINT64_T, MPI_COMM_WORLD);
  return all;
}

std::unique_ptr<Exchange> Launch::make_exchange() const {
  if (count_ == 1) return nullptr;
  return std::make_unique<MpiExchange>(rank_, count_);
}

}  // namespace spoke::ranks
