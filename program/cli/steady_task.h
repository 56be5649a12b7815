#pragma once

// What the commands about steady states have in common: a scenario, and a folder for what is found.

#include <filesystem>
#include <string>

#include "engine/equilibrium.h"
#include "models/error.h"
#include "program/cli/arguments.h"

namespace spoke::cli {

class SteadyTask {
 public:
  /// Reads the scenario; without --out the folder is results/NAME/`command`. Throws InputError,
  /// also if the folder cannot be made.
  SteadyTask(const Arguments& arguments, const std::string& command);

  const Scenario& scenario() const { return scenario_; }
  /// For people.
  const std::string& title() const;
  /// "results/NAME/static/static.html".
  std::string path(const std::string& file) const { return (folder_ / file).string(); }

  /// What `solve` returns, which takes the scenario; InputErrors name the file.
  template <class Solve>
  auto solve(const Solve& solve) const {
    try {
      return solve(scenario_);
    } catch (const InputError& error) {
      throw InputError(file_ + ": " + error.what());
    }
  }

  /// A text in place of the file of that name, if there is one.
  struct File {
    std::string name, text;
  };
  /// Writes them, while no other command writes to the folder.
  void write(const std::vector<File>& files) const;
  /// On stderr, of what makes an equilibrium doubtful.
  static void warn(const EquilibriumResult& result);

 private:
  std::string file_;
  Scenario scenario_;
  std::filesystem::path folder_;
};

}  // namespace spoke::cli
