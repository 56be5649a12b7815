#include "models/text_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>

#include "models/error.h"

namespace spoke {
namespace {

constexpr std::size_t kLargestFile = std::size_t{16} << 20;

}  // namespace

std::string read_text(const std::filesystem::path& file) {
  const std::string expected = ", expected a scenario file (TOML)";
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found) {
    throw InputError(file.string() + ": no such file" + expected);
  }
  if (error) throw InputError(file.string() + ": " + error.message() + expected);
  if (std::filesystem::is_directory(status)) {
    throw InputError(file.string() + ": is a directory" + expected);
  }
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(file.string() + ": " + std::strerror(errno) + expected);
  std::string text(kLargestFile + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad()) throw InputError(file.string() + ": cannot be read" + expected);
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.empty()) throw InputError(file.string() + ": is empty" + expected);
  if (text.size() > kLargestFile) {
    throw InputError(file.string() + ": is larger than 16 MiB" + expected);
  }
  return text;
}

}  // namespace spoke
