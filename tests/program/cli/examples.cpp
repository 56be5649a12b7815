#include "tests/program/cli/examples.h"

#include "tests/program/cli/program.h"

std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> words;
  bool is_quoted = false, is_in_word = false;
  for (const char c : line) {
    if (c == '\'') is_quoted = !is_quoted;
    const bool is_blank = c == ' ' && !is_quoted;
    if (!is_blank && !is_in_word) words.emplace_back();
    is_in_word = !is_blank;
    if (!is_blank && c != '\'') words.back() += c;
  }
  return words;
}

std::vector<Example> examples_of(const std::string& document) {
  std::vector<Example> examples;
  std::string kind;
  bool goes_on = false;
  for (const std::string& line : lines_of(document)) {
    if (line.starts_with("```")) {
      kind = kind.empty() ? line.substr(3) + ' ' : "";
      if (kind == "sh ") examples.emplace_back();
    } else if (kind == "sh " && (goes_on || line.starts_with("spoke "))) {
      if (!goes_on) examples.back().commands.emplace_back();
      std::string& command = examples.back().commands.back();
      command += goes_on ? line : line.substr(6);
      goes_on = line.ends_with('\\');
      if (goes_on) command.pop_back();
    } else if (kind == "text " && !line.empty()) {
      examples.back().shown.push_back(line);
    }
  }
  return examples;
}
