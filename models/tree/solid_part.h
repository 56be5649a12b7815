#pragma once

// A solid of a tree, with the sets of nodes that loads act on.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "models/solid/kept_geometry.h"
#include "models/solid/solid.h"
#include "models/spatial_model.h"

namespace spoke::spatial {

/// A body from a finite-element mesh. Bodies of one description share all of this.
struct SolidPart {
  std::shared_ptr<const solid::KeptGeometry> kept;
  /// Sets of nodes besides the interfaces that loads of the model act on.
  solid::LoadedSets sets{};
  std::string key{};   ///< of the first such body in the model, "subsystem.1.body.2"
  std::string name{};  ///< of the same body, "wing / spar"

  const SolidBody& body() const { return kept->of; }
  const solid::SolidGeometry& geometry() const { return kept->geometry; }
  /// Returns the point of an interface in the body's frame.
  Vector place_of(std::size_t interface) const {
    return geometry().interfaces[interface].point - geometry().interfaces.front().point;
  }
};

/// Finds or makes the constants of a part; `control` hears the body's name. `anew`: makes them in
/// any case, without the cache. Throws InputError as solid::find_constants() does.
solid::MadeConstants find_constants(const SolidPart& part, const solid::Control& control,
                                    bool anew = false);

/// Returns the set of nodes that a load on a solid acts on; none if it acts on an interface.
std::optional<NodeChoice> find_loaded_set(const PointLoad& load, const SolidBody& body);

/// Returns the place of a load on a solid: interfaces come first, sets behind them.
std::size_t find_loaded_place(const PointLoad& load, const SolidPart& part);

/// Returns the body of a subsystem that a load acts on, if it is a solid; else null.
const SolidBody* find_loaded_solid(const PointLoad& load, const Model& model);

/// The solids of a model, as parts of its trees.
class SolidParts {
 public:
  /// Reads meshes that are not read yet, and makes geometries that are not kept.
  explicit SolidParts(const Model& model);

  /// Returns the part of a body of the model.
  const SolidPart& of(const SolidBody& body) const;
  /// Makes the constants of all parts, which the model keeps: what takes seconds of building it.
  void make_constants(const solid::Control& control) const;

 private:
  std::size_t find(const SolidBody& body) const;

  std::vector<const SolidBody*> described_;  ///< by part
  std::vector<SolidPart> parts_;
};

/// Returns the number of coordinates of a solid; of a reduced one at most so many, besides its
/// modes up to a frequency (SolidBody::up_to), whose number is not known before they are made.
std::int64_t count_coordinates(const SolidPart& part);

}  // namespace spoke::spatial
