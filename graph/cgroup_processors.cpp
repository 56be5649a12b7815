#include "graph/cgroup_processors.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <string>
#include <string_view>

namespace spoke::graph {
namespace {

namespace fs = std::filesystem;

std::optional<double> number_of(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{}) return std::nullopt;  // "max", the word for no limit, ends here
  return value;
}

std::optional<double> ratio_of(const std::string& quota_text, const std::string& period_text) {
  const auto quota = number_of(quota_text);
  const auto period = number_of(period_text);
  if (!quota || !period || *quota <= 0.0 || *period <= 0.0) return std::nullopt;
  return *quota / *period;
}

std::string first_word(const fs::path& file) {
  std::string word;
  std::ifstream(file) >> word;
  return word;
}

std::optional<double> limit_of_v2(const fs::path& group) {
  std::string quota;
  std::string period;
  std::ifstream(group / "cpu.max") >> quota >> period;
  return ratio_of(quota, period);
}

std::optional<double> limit_of_v1(const fs::path& group) {
  return ratio_of(first_word(group / "cpu.cfs_quota_us"), first_word(group / "cpu.cfs_period_us"));
}

std::optional<double> smaller(std::optional<double> a, std::optional<double> b) {
  if (a && b) return std::min(*a, *b);
  return a ? a : b;
}

// A group is limited by every group it lies in as well. Inside a container the path may be the
// host's, which is not there; the walk to the mount point then still finds the container's own.
template <class LimitOf>
std::optional<double> limit_along(const fs::path& mount, const std::string& path,
                                  LimitOf limit_of) {
  std::optional<double> limit = limit_of(mount);
  fs::path group = mount;
  for (const fs::path& step : fs::path(path).relative_path()) {
    group /= step;
    limit = smaller(limit, limit_of(group));
  }
  return limit;
}

bool names_cpu(std::string_view controllers) {
  while (!controllers.empty()) {
    const std::size_t comma = std::min(controllers.find(','), controllers.size());
    if (controllers.substr(0, comma) == "cpu") return true;
    controllers.remove_prefix(std::min(comma + 1, controllers.size()));
  }
  return false;
}

}  // namespace

std::optional<double> cgroup_processors(std::istream& membership, const fs::path& root) {
  std::optional<double> limit;
  // Lines read "number:controllers:path"; version 2 has number 0 and no controllers.
  for (std::string line; std::getline(membership, line);) {
    const std::size_t first = line.find(':');
    const std::size_t second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    const std::string path = line.substr(second + 1);
    if (controllers.empty()) {
      limit = smaller(limit, limit_along(root, path, limit_of_v2));
    } else if (names_cpu(controllers)) {
      limit = smaller(limit, limit_along(root / "cpu", path, limit_of_v1));
    }
  }
  return limit;
}

}  // namespace spoke::graph
