#pragma once

// Examples of documents: blocks of commands, each with the block behind it of what they print.

#include <string>
#include <vector>

/// Returns the words of a line of a shell without quotes.
std::vector<std::string> words_of(const std::string& line);

struct Example {
  std::vector<std::string> commands;  ///< behind "spoke "
  std::vector<std::string> shown;     ///< lines that are not empty
};

/// Returns the examples of a document: blocks "sh" of commands, each with the block "text" behind
/// it.
std::vector<Example> examples_of(const std::string& document);
