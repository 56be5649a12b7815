// Asks the OpenMP runtime for its limits and for where it binds threads.

#include "graph/execute/openmp_runtime.h"

#include <omp.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>

#include "spoke/error.h"

namespace spoke::graph {

namespace {

/// Whether the environment may ask for bound threads. If not, the runtime is not queried: LLVM's
/// starts at the first query, which costs time, and a process that is then killed leaves a file in
/// /dev/shm that may keep a later process of the same number from using OpenMP.
bool may_bind() {
  const auto is_set = [](const char* name) { return std::getenv(name) != nullptr; };
  return is_set("OMP_PROC_BIND") || is_set("OMP_PLACES") || is_set("GOMP_CPU_AFFINITY") ||
         is_set("KMP_AFFINITY");
}

/// Whether LLVM's runtime survives this value of OMP_NUM_THREADS: whole numbers, joined by commas.
/// With other values it ends the process, or takes memory for as many threads as an int can count.
bool is_harmless(std::string_view text) {
  constexpr int most = 65536;
  while (true) {
    const std::size_t comma = std::min(text.find(','), text.size());
    std::string_view part = text.substr(0, comma);
    part.remove_prefix(std::min(part.find_first_not_of(" \t"), part.size()));
    part = part.substr(0, part.find_last_not_of(" \t") + 1);
    int number = 0;
    const auto [end, fault] = std::from_chars(part.data(), part.data() + part.size(), number);
    if (fault != std::errc{} || end != part.data() + part.size() || number < 1 || number > most)
      return false;
    if (comma == text.size()) return true;
    text.remove_prefix(comma + 1);
  }
}

/// Whether the runtime may be queried at all: LLVM's reads its environment at the first query.
bool may_be_asked() {
  const char* const text = std::getenv("OMP_NUM_THREADS");
  return text == nullptr || is_harmless(text);
}

}  // namespace

void check_openmp_environment() {
  if (may_be_asked()) return;
  throw InputError("OMP_NUM_THREADS is \"" + std::string(std::getenv("OMP_NUM_THREADS")) +
                   "\", which the OpenMP runtime may not survive, expected numbers from 1 to 65536 "
                   "joined by commas, or none");
}

std::optional<OpenMpBinding> openmp_binding() {
  if (!may_bind() || !may_be_asked() || omp_get_proc_bind() == omp_proc_bind_false) return {};
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
  check_openmp_environment();
  const int limit = omp_get_thread_limit();
  if (threads.total() <= limit) return;
  throw InputError(std::string(name_of(kind)) + " on " + name_of(threads) +
                   " threads: OMP_THREAD_LIMIT allows " + std::to_string(limit));
}

}  // namespace spoke::graph
