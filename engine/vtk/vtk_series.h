#pragma once

// The deformed model over time for ParaView and other programs that read VTK's files: a .vtp file
// for each output time and blades.pvd, which lists them. docs/results.md documents them.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/simulation.h"
#include "engine/vtk/vtk_trees.h"

namespace spoke {

class VtkSeries {
 public:
  /// Makes the folder, free of an earlier series. Throws InputError if that cannot be done; so do
  /// the others.
  VtkSeries(const Simulation& simulation, std::filesystem::path folder);

  /// Writes the model at simulation.time() as the next file, whole or not at all.
  void write(const Simulation& simulation);
  /// Writes blades.pvd.
  void close();

  std::size_t size() const { return times_.size(); }

 private:
  std::filesystem::path folder_;
  std::vector<double> times_;
  std::vector<BladeShape> shapes_;  ///< by blade
  std::optional<VtkTrees> trees_;   ///< of a model in space
};

/// Removes the files of a series, and the folder if nothing else is in it. Throws InputError if
/// that cannot be done.
void remove_vtk_series(const std::filesystem::path& folder);

/// The text of a .vtp file: the blades at simulation.time(). `shapes` is memory, kept from call to
/// call.
std::string make_vtk_blades(const Simulation& simulation, std::vector<BladeShape>& shapes);

}  // namespace spoke
