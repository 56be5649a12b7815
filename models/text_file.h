#pragma once

// Reads whole text files.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace spoke {

/// Returns a text without the UTF-8 byte-order mark that it may begin with.
std::string_view without_byte_order_mark(std::string_view text);

/// Returns the text of a file without its byte-order mark. It may be a pipe: it is read once from
/// its beginning to its end. Messages call the file a scenario unless `kind` says otherwise. Throws
/// InputError, its text "file: what is wrong, what is expected", for anything that cannot be a text
/// file of sensible size: `largest` bytes, by default 16 MiB.
std::string read_text(const std::filesystem::path& file,
                      const std::string& kind = "a scenario file (TOML)",
                      std::size_t largest = std::size_t{16} << 20);

}  // namespace spoke
