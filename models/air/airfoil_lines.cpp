// Splits the text of an aerofoil file; words become numbers as in mesh files.

#include "models/air/airfoil_lines.h"

#include <algorithm>

#include "models/error.h"
#include "models/solid/mesh_text.h"

namespace spoke::air {
namespace {

std::vector<std::string_view> split_words(std::string_view line) {
  constexpr std::string_view blanks = " \t\r\f\v,";
  constexpr std::size_t most = 64;  // no line needs more
  std::vector<std::string_view> words;
  while (words.size() < most) {
    const std::size_t begin = line.find_first_not_of(blanks);
    if (begin == std::string_view::npos) break;
    line.remove_prefix(begin);
    const std::size_t end = std::min(line.find_first_of(blanks), line.size());
    words.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
  return words;
}

const char* name_column(std::size_t column) {
  constexpr const char* names[] = {"an angle of attack (degrees)", "a lift coefficient",
                                   "a drag coefficient", "a moment coefficient"};
  return names[column];
}

}  // namespace

std::vector<AirfoilLine> split_airfoil_lines(std::string_view text, std::string_view comment) {
  std::vector<AirfoilLine> lines;
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    line = line.substr(0, line.find_first_of(comment));
    if (auto words = split_words(line); !words.empty()) lines.push_back({number, std::move(words)});
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

void refuse_airfoil(const std::string& file, int line, const std::string& what) {
  solid::refuse_mesh(file, line, what);
}

void add_row(const AirfoilLine& line, const std::string& file, std::size_t least, std::size_t most,
             bool may_go_on, AirfoilRows& out) {
  std::vector<double> row;
  for (std::size_t k = 0; k < line.words.size() && k < most; ++k) {
    double value = 0.0;
    if (!solid::read_number(line.words[k], value)) {
      if (may_go_on && k >= least) break;
      refuse_airfoil(file, line.number,
                     "is " + solid::show_text(line.words[k]) + ", expected " + name_column(k) +
                         ", a finite number");
    }
    row.push_back(value);
  }
  if (row.size() < least)
    refuse_airfoil(file, line.number,
                   "the line ends here, expected " + std::string(name_column(row.size())));
  if (!may_go_on && line.words.size() > most)
    refuse_airfoil(file, line.number,
                   "has " + std::to_string(line.words.size()) +
                       " columns, expected 3 or 4: angle of attack (degrees), lift, drag, moment");
  out.rows.push_back(std::move(row));
  out.lines.push_back(line.number);
}

}  // namespace spoke::air
