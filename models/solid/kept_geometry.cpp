#include "models/solid/kept_geometry.h"

#include <utility>

#include "models/solid/content.h"

namespace spoke::solid {

bool is_of_mesh(const InputError& error) {
  return error.place().key.empty() || !error.place().file.empty();
}

std::shared_ptr<const KeptGeometry> find_geometry(const spatial::SolidBody& body) {
  const bool has_geometry = body.kept && has_same_shape(body.kept->of, body);
  if (has_geometry && is_same_solid(body.kept->of, body)) return body.kept;
  auto made = std::make_shared<KeptGeometry>();
  made->of = body;
  made->of.kept = nullptr;
  if (has_geometry) {
    made->geometry = body.kept->geometry;
    made->content = body.kept->content;
    return made;
  }
  made->geometry = make_geometry(body);
  if (!body.matrices) {
    made->of.mesh = made->geometry.mesh;
    made->of.material = made->geometry.material;
  }
  made->content = hash_content(made->of);
  return made;
}

void keep_geometry(spatial::SolidBody& body) {
  std::shared_ptr<const KeptGeometry> kept = find_geometry(body);
  body.mesh = kept->of.mesh;
  body.material = kept->of.material;
  body.kept = std::move(kept);
}

MadeConstants find_constants(const KeptGeometry& kept, const LoadedSets& sets,
                             const std::string& key, const Control& control, bool anew) {
  try {
    return kept.shelf->find_or_make(kept.of, kept.geometry, sets, control, anew);
  } catch (const InputError& error) {
    if (is_of_mesh(error)) throw;
    // A body of matrices has no key of the mesh.
    const bool is_of_matrices = kept.of.matrices && error.place().key == "mesh";
    const std::string full = key + '.' + (is_of_matrices ? "stiffness" : error.place().key);
    throw InputError(full + ": " + error.what(), {.key = full});
  }
}

}  // namespace spoke::solid
