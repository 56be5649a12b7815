// Walks from a process's groups up to the root, and takes the smallest limit.

#include "graph/machine/control_groups.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <string>

namespace spoke::graph {
namespace {

namespace fs = std::filesystem;

std::optional<double> smaller(std::optional<double> a, std::optional<double> b) {
  if (a && b) return std::min(*a, *b);
  return a ? a : b;
}

// A group is limited by every group it lies in as well. Inside a container the path may be the
// host's, which does not exist there; the walk to the mount point then still finds the container's
// own.
std::optional<double> limit_along(const fs::path& mount, const std::string& path,
                                  const GroupLimit& limit_of) {
  std::optional<double> limit = limit_of(mount);
  fs::path group = mount;
  for (const fs::path& step : fs::path(path).relative_path()) {
    group /= step;
    limit = smaller(limit, limit_of(group));
  }
  return limit;
}

bool contains(std::string_view controllers, std::string_view wanted) {
  while (!controllers.empty()) {
    const std::size_t comma = std::min(controllers.find(','), controllers.size());
    if (controllers.substr(0, comma) == wanted) return true;
    controllers.remove_prefix(std::min(comma + 1, controllers.size()));
  }
  return false;
}

}  // namespace

std::optional<double> smallest_group_limit(std::istream& membership, const fs::path& root,
                                           const GroupResource& resource) {
  std::optional<double> limit;
  // Lines read "number:controllers:path"; version 2 has number 0 and no controllers.
  for (std::string line; std::getline(membership, line);) {
    const std::size_t first = line.find(':');
    const std::size_t second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    const std::string path = line.substr(second + 1);
    if (controllers.empty()) {
      limit = smaller(limit, limit_along(root, path, resource.version_2));
    } else if (contains(controllers, resource.controller)) {
      limit = smaller(limit, limit_along(root / resource.controller, path, resource.version_1));
    }
  }
  return limit;
}

std::optional<double> parse_group_number(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{}) return std::nullopt;  // "max" ends here
  return value;
}

std::optional<double> read_group_number(const fs::path& file) {
  std::string word;
  std::ifstream(file) >> word;
  return parse_group_number(word);
}

}  // namespace spoke::graph
