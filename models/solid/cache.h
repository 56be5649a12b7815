#pragma once

// The cache of constants: a file for each solid that was made, under a hash of all that they follow
// from. A file that is not what was written is as if it were not there.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "models/solid/assembly.h"
#include "models/space/solid.h"
#include "models/support/hash_bytes.h"

namespace spoke::solid {

/// Collects what constants follow from. It starts with the format of the files, and with program
/// and compiler, since others round otherwise.
class CacheKey {
 public:
  CacheKey();
  void add(const void* first, std::size_t size) { value_ = hash_bytes(first, size, value_); }
  void add(std::string_view text);
  void add(double value) { add(&value, sizeof value); }
  void add(std::int64_t value) { add(&value, sizeof value); }
  void add(const std::vector<int>& values);
  void add(const std::vector<double>& values);
  void add(const Sparse& matrix);
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_;
};

/// Returns the folder of the cache: $SPOKE_CACHE, or else spoke in $XDG_CACHE_HOME or
/// $HOME/.cache; none if SPOKE_CACHE is "none", or it cannot be made.
std::optional<std::filesystem::path> find_cache_folder();

/// Returns the file of a key in a folder.
std::filesystem::path cache_file(const std::filesystem::path& folder, std::uint64_t key);

/// Reads constants; none if the file is not there, damaged, or of another key. Damping, mesh, nodes
/// and stress are not in it.
std::optional<space::SolidConstants> read_constants(const std::filesystem::path& file,
                                                    std::uint64_t key);

/// Writes constants to a file of another name, which is then renamed. Tells whether that went well;
/// if not, there is no file.
bool write_constants(const std::filesystem::path& file, std::uint64_t key,
                     const space::SolidConstants& constants);

}  // namespace spoke::solid
