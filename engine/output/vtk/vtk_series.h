#pragma once

// The deformed model over time for ParaView and other programs that read VTK's files: a .vtp file
// for each output time, a .vtu file beside it for the meshes of solids, and blades.pvd, which lists
// them. docs/results.md documents them.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/output/vtk/solid_vtk.h"
#include "engine/output/vtk/spatial_vtk.h"
#include "engine/simulation.h"

namespace spoke {

class VtkSeries {
 public:
  /// Makes the folder, free of an earlier series. All functions throw InputError if their work
  /// cannot be done.
  VtkSeries(const Simulation& simulation, std::filesystem::path folder);

  /// Writes the model at simulation.time() as the next file, whole or not at all.
  void write(const Simulation& simulation);
  /// Writes blades.pvd.
  void close();

  std::size_t size() const { return times_.size(); }

 private:
  std::filesystem::path folder_;
  std::vector<double> times_;
  std::vector<BladeShape> shapes_;     ///< by subsystem, in the plane
  std::optional<SpatialVtk> spatial_;  ///< only for a model in space
  std::optional<SolidVtk> solids_;     ///< only for one that has solids
};

/// Returns the names of the files in a folder that are named as those of a series.
std::vector<std::string> find_vtk_series(const std::filesystem::path& folder);

/// Removes these files of a series, and the folder if nothing else is in it. Throws InputError if
/// that cannot be done.
void remove_vtk_series(const std::filesystem::path& folder);

/// Makes the text of a .vtp file of a rotor in the plane at simulation.time(). `shapes` is memory
/// that is kept from call to call.
std::string make_planar_vtk(const Simulation& simulation, std::vector<BladeShape>& shapes);

}  // namespace spoke
