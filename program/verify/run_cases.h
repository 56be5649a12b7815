#pragma once

// Runs cases, several at once, and judges them.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "program/verify/case.h"

namespace spoke::verify {

/// A file of cases, of a scenario or of what that reads, by its path: "cases/beams.toml",
/// "scenarios/column.toml".
struct CaseFile {
  std::string path;
  std::string text;
};
/// Returns the files that come with the program.
std::vector<CaseFile> copy_shipped_files();
/// Returns the files of a user's folder, cases/*.toml, scenarios/*.toml and scenarios/meshes/*.inp
/// in the order of their names, and behind them the scenarios that come with the program. Throws
/// InputError if there are no cases.
std::vector<CaseFile> read_files(const std::filesystem::path& folder);

/// Returns all cases in the order of their files. Throws InputError, also if two have one name.
std::vector<Case> read_all_cases(const std::vector<CaseFile>& files);

/// Returns those of the names, which are of cases or groups, in the order of `cases`; all if there
/// are no names. Throws InputError, with the nearest name, if one is neither.
std::vector<Case> choose_cases(const std::vector<Case>& cases,
                               const std::vector<std::string>& names);

/// Returns the scenarios of the cases, and what these read, by their paths below the folder of
/// scenarios, each with a first line that says what it is. Throws InputError if one is missing.
std::vector<CaseFile> find_needed_files(const std::vector<Case>& cases,
                                        const std::vector<CaseFile>& files);

/// What came of a case.
struct CaseResult {
  Case of;
  std::vector<double> values;  ///< by figure; empty: the case failed
  std::string failure;         ///< why there are none
  double seconds = 0.0;        ///< wall time, with the reading of the scenario

  bool holds() const;
};

/// Returns how far a value is from the exact one, a share of the figure's scale.
double error_of(const Figure& figure, double value);
/// Whether a value is within the stated error; one that is not a number is not.
bool holds(const Figure& figure, double value);

/// Runs the cases, whose scenarios are in a folder, each on a thread, so many at once; results are
/// in the order of the cases. `progress` is called with the number that is done.
std::vector<CaseResult> run_cases(const std::vector<Case>& cases,
                                  const std::filesystem::path& folder, int threads,
                                  const std::function<void(std::size_t)>& progress);

/// Numbers of cases and figures, and how many figures hold.
struct Tally {
  std::size_t cases = 0, figures = 0, held = 0;
  bool all_hold() const { return held == figures; }
};
Tally count(const std::vector<CaseResult>& results);

}  // namespace spoke::verify
