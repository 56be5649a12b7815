#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace spoke::test {

/// All bytes of a file; none if there is no such file.
inline std::string file_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace spoke::test
