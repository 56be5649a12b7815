#pragma once

// Lists of words as values of options. CLI11's own lists drop words that are empty.

#include <string>
#include <vector>

namespace spoke::cli {

/// Returns the words of a list "a,b,c"; one empty word for an empty list.
inline std::vector<std::string> split_words(const std::string& list) {
  std::vector<std::string> words{""};
  for (const char c : list) {
    if (c == ',') {
      words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  return words;
}

}  // namespace spoke::cli
