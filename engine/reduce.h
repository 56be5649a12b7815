#pragma once

// The reduction of solids, bodies from finite-element meshes, to modes.

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "models/scenario.h"
#include "models/solid_body.h"
#include "spoke/export.h"

namespace spoke {

/// How solids are reduced.
struct ReduceOptions {
  /// Called on the calling thread with what is being done and how much of it is done, 0 to 1. An
  /// exception that it throws ends the reduction.
  std::function<void(const std::string& step, double done)> progress{};
  /// Whether all is made anew, even if it was made before or is in the cache.
  bool anew = false;
};

/// An interface of a solid at rest.
struct SolidReductionInterface {
  std::string name;
  spatial::InterfaceKind kind = spatial::InterfaceKind::rigid;
  std::size_t nodes = 0;                           ///< number of its nodes
  Eigen::Vector3d point{Eigen::Vector3d::Zero()};  ///< in the frame of the body [m]
  double area = 0.0;                               ///< of its faces [m^2]; 0: it has none
};

/// A solid of a scenario, and its deformation coordinates: modes that are orthonormal with its mass
/// and stiffness, made of vibration modes with interfaces held and of the static shapes of these;
/// or, of one with the coordinates `nodal`, the displacements of its nodes, which are not listed.
struct SolidReduction {
  std::string subsystem;  ///< name of the subsystem
  std::string body;       ///< name of the body
  /// Index of the first result that is of an equal solid, which was made once; its own, if it is
  /// the first.
  std::size_t same_as = 0;
  std::string file;  ///< of the mesh, or of the stiffness matrix; empty: it was made in code
  spatial::SolidCoordinates kind = spatial::SolidCoordinates::reduced;
  int coordinates = 0;                ///< number of its deformation coordinates
  std::size_t elements = 0;           ///< number of elements; 0: its matrices are another program's
  bool has_locking_elements = false;  ///< whether linear elements, tet4 or hex8, make it too stiff
  double mass = 0.0;                  ///< [kg]
  std::vector<SolidReductionInterface> interfaces;
  /// Frequencies of the modes, ascending [Hz]; of `nodal` none.
  std::vector<double> frequencies;
  std::vector<double> damping_ratios;  ///< of the same modes
  /// Frequencies of the vibration modes from which they were made, with all interfaces held, or of
  /// the body alone with the frame `mean_axis` [Hz].
  std::vector<double> vibration_frequencies;
  std::vector<Eigen::Vector3d> nodes;  ///< places of the nodes in the frame of the body [m]
  std::vector<int> labels;             ///< numbers of the nodes in their file
  /// By mode, by node: displacement [m] at a modal coordinate of 1 m sqrt(kg).
  std::vector<std::vector<Eigen::Vector3d>> shapes;
  double seconds = 0.0;       ///< wall time that it took to make or to read [s]
  double memory_bytes = 0.0;  ///< of what is kept for simulations, about
  bool was_cached = false;    ///< whether it was read from the cache
  std::string cache_file;     ///< file of the cache; empty: there is none
};

/// Reduces the solids of a scenario, in the order of its bodies, as everything does that simulates
/// it, and puts them into the cache. What is made is kept with the scenario and its copies. Throws
/// InputError if the scenario is not valid, or if this machine lacks the memory.
SPOKE_EXPORT std::vector<SolidReduction> reduce(const Scenario& scenario,
                                                const ReduceOptions& options = {});

}  // namespace spoke
