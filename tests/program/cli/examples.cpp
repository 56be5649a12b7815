#include "tests/program/cli/examples.h"

#include <sstream>

#include "tests/program/cli/program.h"

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::vector<Example> examples_of(const std::string& document) {
  std::vector<Example> examples;
  std::string kind;
  for (const std::string& line : lines_of(document)) {
    if (line.starts_with("```")) {
      kind = kind.empty() ? line.substr(3) + ' ' : "";
      if (kind == "sh ") examples.emplace_back();
    } else if (kind == "sh " && line.starts_with("spoke ")) {
      examples.back().commands.push_back(line.substr(6));
    } else if (kind == "text " && !line.empty()) {
      examples.back().shown.push_back(line);
    }
  }
  return examples;
}
