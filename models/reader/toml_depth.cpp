// Scans a TOML text for keys, past strings and comments.

#include "models/reader/toml_depth.h"

#include <algorithm>

namespace spoke {
namespace {

/// Returns the end of the string that begins at `begin` with a quote: behind its last quote, or
/// where the line or the text ends without one.
std::size_t find_string_end(std::string_view text, std::size_t begin) {
  const char quote = text[begin];
  const std::string_view same(text.data() + begin, std::min<std::size_t>(3, text.size() - begin));
  const bool many_lines = same.size() == 3 && same[1] == quote && same[2] == quote;
  std::size_t at = begin + (many_lines ? 3 : 1);
  for (; at < text.size(); ++at) {
    if (text[at] == '\\' && quote == '"') {
      ++at;
    } else if (!many_lines && (text[at] == quote || text[at] == '\n')) {
      return at + 1;
    } else if (many_lines && text.substr(at, 3) == same) {
      // Up to two more quotes belong to the string.
      const std::size_t behind = text.substr(0, at + 5).find_first_not_of(quote, at);
      return std::min({behind, at + 5, text.size()});
    }
  }
  return text.size();
}

}  // namespace

std::optional<std::size_t> find_deep_key(std::string_view text, std::size_t most) {
  constexpr std::string_view between_keys = "=,[]{}\n";
  std::size_t names = 1;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (c == '"' || c == '\'') {
      at = find_string_end(text, at);
      continue;
    }
    if (c == '#') {
      at = std::min(text.find('\n', at), text.size());
      continue;
    }
    if (c == '.' && ++names > most) return at;
    if (between_keys.find(c) != std::string_view::npos) names = 1;
    ++at;
  }
  return std::nullopt;
}

}  // namespace spoke
