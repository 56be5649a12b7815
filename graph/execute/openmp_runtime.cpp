// Asks the OpenMP runtime for its limits and for where it binds threads.

#include "graph/execute/openmp_runtime.h"

#include <omp.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>

#include "spoke/error.h"

namespace spoke::graph {

namespace {

/// Whether the environment may ask for bound threads. Without, the runtime is not asked either:
/// LLVM's begins at the first question, which costs time, and a process that is then killed leaves
/// a file in /dev/shm that may keep a later process of the same number from using OpenMP.
bool may_bind() {
  const auto is_set = [](const char* name) { return std::getenv(name) != nullptr; };
  return is_set("OMP_PROC_BIND") || is_set("OMP_PLACES") || is_set("GOMP_CPU_AFFINITY") ||
         is_set("KMP_AFFINITY");
}

}  // namespace

std::optional<OpenMpBinding> openmp_binding() {
  if (!may_bind() || omp_get_proc_bind() == omp_proc_bind_false) return {};
  OpenMpBinding binding;
  // The runtime begins by counting the processors, then makes places, then binds.
  binding.processors = omp_get_num_procs();
  for (int place = 0; place < omp_get_num_places(); ++place) {
    std::vector<int> numbers(static_cast<std::size_t>(omp_get_place_num_procs(place)));
    omp_get_place_proc_ids(place, numbers.data());
    binding.places.insert(binding.places.end(), numbers.begin(), numbers.end());
  }
  if (binding.places.empty()) return {};
  std::sort(binding.places.begin(), binding.places.end());
  binding.places.erase(std::unique(binding.places.begin(), binding.places.end()),
                       binding.places.end());
  return binding;
}

int processors_for_openmp() {
  const auto binding = openmp_binding();
  return binding ? std::min(available_threads(), static_cast<int>(binding->places.size()))
                 : available_threads();
}

std::size_t openmp_stack() {
  const char* const text = std::getenv("OMP_STACKSIZE");
  if (text == nullptr) return 0;
  char* end = nullptr;
  const unsigned long long number = std::strtoull(text, &end, 10);
  while (std::isspace(static_cast<unsigned char>(*end)) != 0) ++end;
  const std::string units = "BKMG";
  const char unit = *end == '\0' ? 'K' : static_cast<char>(std::toupper(*end));
  const auto place = units.find(unit);
  const bool is_negative = std::string_view(text).find('-') != std::string_view::npos;
  if (end == text || is_negative || place == std::string::npos) return 0;
  const unsigned shift = 10 * static_cast<unsigned>(place);
  constexpr unsigned long long most = std::numeric_limits<std::size_t>::max();
  return number > (most >> shift) ? most : static_cast<std::size_t>(number << shift);
}

void check_openmp_limit(ExecutorKind kind, const Threads& threads) {
  const int limit = omp_get_thread_limit();
  if (threads.total() <= limit) return;
  throw InputError(std::string(name_of(kind)) + " on " + name_of(threads) +
                   " threads: OMP_THREAD_LIMIT allows " + std::to_string(limit));
}

}  // namespace spoke::graph
