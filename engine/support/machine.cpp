// Reads the description of the machine from Linux.

#include "engine/support/machine.h"

#include <sys/utsname.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string_view>

#include "engine/support/memory.h"
#include "graph/calibrate/capacity.h"
#include "graph/executor.h"

namespace spoke {
namespace {

/// Returns the text after the separator in the first line of a file that begins with `key`; else
/// nothing.
std::string value_in_file(const char* file, std::string_view key, char separator) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with(key)) continue;
    const auto begin = line.find_first_not_of(" \t\"", line.find(separator) + 1);
    if (begin == std::string::npos) return {};
    return line.substr(begin, line.find_last_not_of(" \t\"") - begin + 1);
  }
  return {};
}

std::string operating_system() {
  std::string name = value_in_file("/etc/os-release", "PRETTY_NAME", '=');
  utsname kernel{};
  if (uname(&kernel) != 0) return name;
  if (!name.empty()) name += ", ";
  return name + kernel.sysname + ' ' + kernel.release + ' ' + kernel.machine;
}

std::string compiler() {
#if defined(__clang__)
  return "Clang " __clang_version__;
#elif defined(__GNUC__)
  return "GCC " __VERSION__;
#else
  return {};
#endif
}

}  // namespace

Machine this_machine() {
  // Read once, as a run tells them twice.
  static const std::string cpu = value_in_file("/proc/cpuinfo", "model name", ':');
  static const std::string os = operating_system();
  return {cpu, graph::available_threads(), physical_memory(), os, compiler()};
}

double load_average() {
  double load = -1.0;
  return getloadavg(&load, 1) == 1 ? load : -1.0;
}

double Capacity::bound(double work, double span, int threads_used) const {
  assert(is_known());
  const double at_once = std::min(static_cast<double>(threads_used), std::max(before, after));
  return std::max(work / at_once, span);
}

std::string Capacity::text() const {
  assert(is_known());
  std::array<char, 96> text;
  std::snprintf(text.data(), text.size(), "%d threads do %.2f times the work of one here", threads,
                std::max(before, after));
  return text.data();
}

Capacity measure_capacity() {
  constexpr double seconds = 0.02;
  const int threads = graph::available_threads();
  const double factor = graph::measure_capacity(threads, seconds);
  return {threads, factor, factor};
}

bool is_busy(double load, int processors) { return load > 0.5 * processors; }

}  // namespace spoke
