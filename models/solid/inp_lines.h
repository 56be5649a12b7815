#pragma once

// Lines of an .inp file: keywords with parameters, and data separated by commas.

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "models/solid/mesh_text.h"

namespace spoke::solid {

/// Returns a text in capital letters, without quotes around it.
std::string in_capitals(std::string_view text);

/// A line "*ELEMENT, TYPE=C3D10, ELSET=ALL".
struct InpKeyword {
  std::string name;  ///< in capitals, without the star: "END PART"
  std::string key;   ///< the same without blanks, which count for nothing: "ENDPART"
  int line = 0;
  /// Names in capitals, values as they are.
  std::vector<std::pair<std::string, std::string>> parameters;

  /// Returns a parameter; null: it is not there.
  const std::string* find(std::string_view parameter) const;
};

/// Walks through the lines of an .inp file; comments and empty lines are passed over.
class InpLines {
 public:
  InpLines(std::string_view text, std::string file) : text_(text, std::move(file)) {}

  /// Passes over what is left of the data and reads the next keyword; false at the end of the file.
  bool next_keyword(InpKeyword& keyword);
  /// Goes to the next line of data; false before the next keyword and at the end of the file.
  bool next_data();
  /// Number of the line of data.
  int line() const { return line_; }
  /// Splits the line of data at its commas. Is its last character one, no empty item follows.
  const std::vector<std::string_view>& items();
  /// Whether the line of data ends in a comma, and so goes on in the next.
  bool goes_on() const { return data_.ends_with(','); }

  /// Reads a number from an item, or refuses the line; an empty item is 0.
  double number(std::string_view item, const char* what) const;
  int label(std::string_view item, const char* what) const;

  [[noreturn]] void refuse(const std::string& what) const { text_.refuse(line_, what); }
  [[noreturn]] void refuse(int line, const std::string& what) const { text_.refuse(line, what); }

 private:
  bool fill();  // reads the next line into next_, if it is empty

  MeshText text_;
  std::string_view next_;  // line that is read but not taken
  int next_line_ = 0;
  std::string_view data_;
  int line_ = 0;
  std::vector<std::string_view> items_;
};

}  // namespace spoke::solid
