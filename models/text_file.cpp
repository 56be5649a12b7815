// Reads a file that may be a pipe, up to a limit of size.

#include "models/text_file.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <istream>

#include "models/error.h"
#include "models/file_watch.h"

namespace spoke {
namespace {

/// Reads up to `most` bytes of a stream, in pieces: memory is touched only as far as there is text.
std::string read_at_most(std::istream& stream, std::size_t most) {
  std::string text;
  std::array<char, 16384> piece;
  while (text.size() < most && stream) {
    stream.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    text.append(piece.data(), static_cast<std::size_t>(stream.gcount()));
  }
  return text;
}

}  // namespace

std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  if (text.starts_with(kMark)) text.remove_prefix(kMark.size());
  return text;
}

std::string read_text(const std::filesystem::path& file, const std::string& kind,
                      std::size_t largest) {
  const auto refuse = [&](const std::string& what) {
    throw InputError(file.string() + ": " + what + ", expected " + kind, {.file = file.string()});
  };
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found) refuse("no such file");
  if (error) refuse(error.message());
  if (std::filesystem::is_directory(status)) refuse("is a directory");
  announce_reading(file);
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) refuse(std::strerror(errno));
  std::string text = read_at_most(stream, largest + 1);
  if (stream.bad()) refuse("cannot be read");
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    refuse("is text in UTF-16, not in UTF-8");
  text.erase(0, text.size() - without_byte_order_mark(text).size());
  if (text.empty()) refuse("is empty");
  if (text.size() > largest) refuse("is larger than " + std::to_string(largest >> 20) + " MiB");
  return text;
}

}  // namespace spoke
