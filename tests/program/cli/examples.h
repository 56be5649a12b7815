#pragma once

// Examples of documents: blocks of commands, each with the block behind it of what they print.

#include <string>
#include <vector>

/// Returns the words of a line of a shell; single quotes keep blanks within a word.
std::vector<std::string> words_of(const std::string& line);

struct Example {
  std::vector<std::string> commands;  ///< behind "spoke "
  std::vector<std::string> shown;     ///< lines that are not empty
};

/// Returns the examples of a document: blocks "sh" of commands, each with the block "text" behind
/// it. A line of a command that ends in "\" goes on in the next.
std::vector<Example> examples_of(const std::string& document);
