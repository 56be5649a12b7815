// Stands in for malloc and operator new.

#include "tests/engine/counted_allocations.h"

#include <cstdlib>
#include <new>

namespace spoke::test {

std::atomic<long> allocations{0};
std::atomic<std::size_t> allocated_bytes{0};
std::atomic<long> allocations_by_new{0};

long allocations_of_steps(const Scenario& scenario, const SimulationOptions& options, int steps) {
  Simulation simulation(scenario, options);
  for (int n = 0; n < 3; ++n) simulation.step();
  const long before = allocations.load();
  for (int n = 0; n < steps; ++n) simulation.step();
  return allocations.load() - before;
}

}  // namespace spoke::test

// Eigen and oneTBB allocate by malloc, everything else by operator new, which calls it.
extern "C" void* __libc_malloc(std::size_t size);
extern "C" void* malloc(std::size_t size) {
  spoke::test::allocations.fetch_add(1, std::memory_order_relaxed);
  spoke::test::allocated_bytes.fetch_add(size, std::memory_order_relaxed);
  return __libc_malloc(size);
}
void* operator new(std::size_t size) {
  spoke::test::allocations_by_new.fetch_add(1, std::memory_order_relaxed);
  void* const memory = std::malloc(size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
