#pragma once

// Common part of the commands about steady states: a scenario, and a folder for the results.

#include <filesystem>
#include <string>
#include <vector>

#include "engine/equilibrium.h"
#include "models/error.h"
#include "program/cli/arguments.h"
#include "program/cli/prepare_solids.h"

namespace spoke::cli {

class SteadyTask {
 public:
  /// Reads the scenario; without --out the folder is results/NAME/`command`. Throws InputError,
  /// also if the folder cannot be made, or if one of the files may not be written to it.
  SteadyTask(const Arguments& arguments, const std::string& command,
             const std::vector<std::string>& files);

  const Scenario& scenario() const { return scenario_; }
  /// Returns the scenario's title or, without one, its name.
  const std::string& title() const;
  /// Returns the path of a file in the folder, such as "results/NAME/static/static.html".
  std::string path(const std::string& file) const { return (folder_ / file).string(); }

  /// Returns solve(scenario), when solids are made; its InputErrors name the file.
  template <class Solve>
  auto solve(const Solve& solve) const {
    try {
      prepare_solids(scenario_);
      return solve(scenario_);
    } catch (const InputError& error) {
      if (!error.place().key.empty()) throw;  // the program finds its place
      throw InputError(file_ + ": " + error.what());
    }
  }

  /// A file to write, which replaces one of that name.
  struct File {
    std::string name, text;
  };
  /// Writes the files, while no other command writes to the folder.
  void write(const std::vector<File>& files) const;
  /// Prints on stderr the warnings that make an equilibrium doubtful.
  static void warn(const EquilibriumResult& result);

 private:
  std::string file_;
  Scenario scenario_;
  std::filesystem::path folder_;
};

}  // namespace spoke::cli
