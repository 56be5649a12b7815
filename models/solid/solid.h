#pragma once

// From the description of a solid to the constants of its equations of motion.

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "models/solid_body.h"
#include "models/space/solid.h"

namespace spoke::solid {

/// Nodes of an interface or of a set, and how they count.
struct ChosenNodes {
  std::vector<int> nodes;       ///< indices, ascending
  std::vector<double> weights;  ///< sum 1: by the area of the faces if there are any, else equal
  spatial::Vector point = spatial::Vector::Zero();  ///< its point, in the mesh's axes [m]
  double area = 0.0;                                ///< [m^2]; 0: no faces
};

/// What a description says of a solid at rest; lengths are scaled.
struct SolidGeometry {
  std::shared_ptr<const spatial::SolidMesh> mesh;
  spatial::SolidMaterial material;                          ///< the body's, or else the file's
  double mass = 0.0;                                        ///< [kg]
  spatial::Vector first_moment = spatial::Vector::Zero();   ///< about the first interface [kg m]
  Eigen::Matrix3d second_moment = Eigen::Matrix3d::Zero();  ///< int r r^T dm about it [kg m^2]
  std::vector<ChosenNodes> interfaces;                      ///< by interface
};

/// Reads a mesh from a file: gmsh .msh 2.2 or 4.1, or Abaqus .inp; lengths times `length_scale`. Of
/// an .inp file with one material sets `material`, unless null. Throws InputError, its text
/// "file:line: what is wrong, what is expected".
std::shared_ptr<const spatial::SolidMesh> read_mesh(
    const std::string& file, double length_scale, std::optional<spatial::SolidMaterial>* material);

/// Finds the nodes of a choice. Throws InputError, its place().key empty, "chooses no nodes, ...".
ChosenNodes choose_nodes(const spatial::SolidMesh& mesh, const spatial::NodeChoice& choice);

/// Finds mass and interfaces of a solid, whose mesh is read. Throws InputError with the key within
/// the body in place().key: "interface.2.nodes", "mesh", "material.density", ...
SolidGeometry make_geometry(const spatial::SolidBody& body);

/// Sets of nodes that loads act on, besides the interfaces.
using LoadedSets = std::vector<spatial::NodeChoice>;

/// The wishes of who has constants made.
struct Control {
  /// Told what is being done, a step's name, and how much of all is done, 0 to 1; may be empty.
  /// What it throws ends the making.
  std::function<void(const std::string& step, double done)> progress{};
  double memory = std::numeric_limits<double>::infinity();  ///< that may be used [bytes]
};

/// The cache's part in making constants.
struct CacheUse {
  bool reads = true;      ///< whether constants may be read from it; they are put there anyway
  std::string file{};     ///< set: the file there; empty: there is no cache
  bool was_read = false;  ///< set: whether they were read from it
};

/// Makes the constants, from the cache if they are there, and else puts them there. `at_rest`:
/// make_geometry() of the body. Throws InputError as make_geometry() does. `cache`: may be null.
std::shared_ptr<const space::SolidConstants> make_constants(const spatial::SolidBody& body,
                                                            const SolidGeometry& at_rest,
                                                            const LoadedSets& sets,
                                                            const Control& control = {},
                                                            CacheUse* cache = nullptr);
/// Makes the geometry, too.
std::shared_ptr<const space::SolidConstants> make_constants(const spatial::SolidBody& body,
                                                            const LoadedSets& sets,
                                                            const Control& control = {},
                                                            CacheUse* cache = nullptr);

}  // namespace spoke::solid
