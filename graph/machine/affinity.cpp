// Affinity by Linux's system calls; nothing on other systems.

#include "graph/machine/affinity.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <numeric>

#ifdef __linux__
#include <sched.h>
#endif

namespace spoke::graph {

#ifdef __linux__

namespace {

/// A set of processors with the numbers below `bits`.
class Mask {
 public:
  explicit Mask(int bits) : bytes_(CPU_ALLOC_SIZE(bits)), set_(CPU_ALLOC(bits)) {
    if (set_) CPU_ZERO_S(bytes_, set_.get());
  }

  bool read() { return set_ && sched_getaffinity(0, bytes_, set_.get()) == 0; }
  void write() const {
    if (set_) sched_setaffinity(0, bytes_, set_.get());
  }
  bool has(int processor) const {
    return CPU_ISSET_S(static_cast<std::size_t>(processor), bytes_, set_.get());
  }
  void add(int processor) {
    if (set_) CPU_SET_S(static_cast<std::size_t>(processor), bytes_, set_.get());
  }

 private:
  struct Free {
    void operator()(cpu_set_t* set) const { CPU_FREE(set); }
  };
  std::size_t bytes_;
  std::unique_ptr<cpu_set_t, Free> set_;
};

}  // namespace

std::vector<int> thread_affinity() {
  // The kernel refuses a mask that is too short for the machine: try longer ones.
  for (int bits = CPU_SETSIZE; bits <= (1 << 20); bits *= 2) {
    Mask mask(bits);
    if (!mask.read()) continue;
    std::vector<int> processors;
    for (int processor = 0; processor < bits; ++processor)
      if (mask.has(processor)) processors.push_back(processor);
    return processors;
  }
  return {};
}

void set_thread_affinity(const std::vector<int>& processors) {
  if (processors.empty()) return;
  Mask mask(*std::max_element(processors.begin(), processors.end()) + 1);
  for (const int processor : processors) mask.add(processor);
  mask.write();
}

void set_widest_thread_affinity() {
  // Most processors of a machine; the kernel ignores those that are not there.
  constexpr int most = 1 << 16;
  std::vector<int> all(most);
  std::iota(all.begin(), all.end(), 0);
  set_thread_affinity(all);
}

#else

std::vector<int> thread_affinity() { return {}; }
void set_thread_affinity(const std::vector<int>&) {}
void set_widest_thread_affinity() {}

#endif

}  // namespace spoke::graph
