#pragma once

// The lines of an aerofoil file that hold more than comments.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace spoke::air {

/// A line's words, of which there is one or more, and its number from 1.
struct AirfoilLine {
  int number = 0;
  std::vector<std::string_view> words;
};

/// Returns the lines of a text that hold words. Words are separated by blanks, tabs and commas;
/// `comment` characters begin comments, up to the end of the line.
std::vector<AirfoilLine> split_airfoil_lines(std::string_view text, std::string_view comment);

/// Throws InputError "file:line: what"; line 0: "file: what".
[[noreturn]] void refuse_airfoil(const std::string& file, int line, const std::string& what);

/// A table of angle of attack [degrees] and coefficients as it stands in a file.
struct AirfoilRows {
  std::vector<std::vector<double>> rows;
  std::vector<int> lines;  ///< of the rows in the file
};

/// Adds a row of numbers: the words of a line, `least` to `most` of them. What follows those is
/// ignored only if `may_go_on`. Refuses what is no finite number.
void add_row(const AirfoilLine& line, const std::string& file, std::size_t least, std::size_t most,
             bool may_go_on, AirfoilRows& out);

}  // namespace spoke::air
