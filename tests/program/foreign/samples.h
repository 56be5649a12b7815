#pragma once

// The small files of the tests, as they are and with faults; a second way to turn them into
// sections.

#include <Eigen/Core>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "program/foreign/import_files.h"

namespace spoke::test {

/// Texts by the names of the files.
using Texts = std::map<std::string, std::string>;

/// Returns the files of the folder: small_BeamDyn.dat and so on.
const Texts& samples();

/// Returns a text with its first `from` replaced; requires that it is there.
std::string replaced(std::string text, std::string_view from, std::string_view to);
/// Returns a text without one line, counted from 1.
std::string without_line(const std::string& text, int line);
/// Returns a text up to a line, itself included.
std::string up_to_line(const std::string& text, int line);
/// Returns a text with one line, counted from 1, replaced.
std::string with_line(const std::string& text, int line, const std::string& replacement);

/// Imports files by name; what they name is read from the texts as well.
foreign::Imported import_texts(const Texts& texts, const std::vector<std::string>& names,
                               const foreign::ImportOptions& options = {});

/// A fault of a file and the message expected.
struct WrongText {
  std::string text;
  std::string message;
};
/// Requires that each text, in the place of `name`, is refused by a message of one line that begins
/// with the name of the file and a line, and contains what is expected.
void check_refused(const std::string& name, const std::vector<std::string>& names,
                   const std::vector<WrongText>& wrong, const foreign::ImportOptions& options = {});

/// Returns the numbers in each line of a text; lines with words have those before the first word.
std::vector<std::vector<double>> numbers_by_line(const std::string& text);

/// Natural cubic splines of columns over the first, by a dense solution for all second derivatives.
class DenseSpline {
 public:
  DenseSpline(std::vector<double> x, std::vector<std::vector<double>> columns);
  double at(std::size_t column, double x) const;
  double slope(std::size_t column, double x) const;
  /// Returns the arc length of the curve of x and the first two columns between places, by
  /// Simpson's rule.
  double arc_length(double from, double to) const;
  /// Returns the x at an arc length from the first place, by bisection.
  double find_x(double arc_length) const;

 private:
  std::size_t piece(double x) const;
  std::vector<double> x_;
  std::vector<std::vector<double>> values_, second_;
};

/// Returns K in Spoke's axes from BeamDyn's, by the rotation between them.
Eigen::Matrix<double, 6, 6> rotate_from_beamdyn(const Eigen::Matrix<double, 6, 6>& matrix);

/// Requires equal sections: stations and shape to 1e-10 of their size, matrices to 1e-10 of their
/// diagonals.
void check_same(const spatial::Sections& found, const spatial::Sections& expected);

/// Requires equal frequencies at rest of the first modes of two scenarios.
void check_same_frequencies(const Scenario& found, const Scenario& expected, int count);

/// Returns frequencies at rest [Hz].
std::vector<double> frequencies_of(const Scenario& scenario, int count);

/// Returns a scenario of one blade of this beam on a hub that is held.
Scenario held_blade(const spatial::Beam& beam);

}  // namespace spoke::test
