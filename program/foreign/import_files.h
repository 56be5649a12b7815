#pragma once

// Makes a scenario of files of other programs.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "models/scenario.h"
#include "program/foreign/beamdyn_reader.h"

namespace spoke::foreign {

/// What the files do not say.
struct ImportOptions {
  std::optional<double> blade_length;  ///< of an ElastoDyn blade without its primary file [m]
  std::optional<double> tower_height;  ///< likewise of a tower [m]
  /// Folder of the aerofoils' tables, relative to that of the scenario.
  std::string airfoil_folder = "airfoils";
  std::string wind_table = "wind.txt";  ///< table of a uniform wind, likewise
  std::string folder;                   ///< of the scenario; empty: that of the program
  /// Whether there is a file, of which the scenario has but the path: of wind, a library.
  std::function<bool(const std::string& name)> is_there = [](const std::string& name) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(name, ignored);
  };
};

/// Returns the text of a file that another one names. Throws InputError.
using ReadFile = std::function<std::string(const std::string& name)>;

/// A scenario made of files, and how.
struct Imported {
  std::string text;                   ///< the scenario (TOML)
  std::vector<SourceFile> tables;     ///< files that it names, relative to its folder
  Scenario scenario;                  ///< what it says, checked
  std::vector<std::string> sources;   ///< files that were read, and what they are
  std::vector<std::string> left_out;  ///< what could not be carried over, worst first
};

/// Makes a scenario of files, which it tells apart by their first line or, in YAML, their ending. A
/// file that one of them names is read by `read` from the folder of the one that names it, unless
/// one of its kind is given. Throws InputError with file and line.
Imported import_files(const std::vector<SourceFile>& files, const ReadFile& read,
                      const ImportOptions& options = {});

}  // namespace spoke::foreign
