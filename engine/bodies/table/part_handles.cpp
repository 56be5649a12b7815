#include "engine/bodies/table/part_handles.h"

namespace spoke {

using graph::PartId;

std::vector<PartId> SubsystemParts::all(PartId BodyParts::*member) const {
  std::vector<PartId> list;
  for (const BodyParts& body : bodies) list.push_back(body.*member);
  return list;
}

std::vector<PartId> SubsystemParts::tiles() const {
  std::vector<PartId> list;
  for (const BodyParts& body : bodies)
    list.insert(list.end(), body.tiles.begin(), body.tiles.end());
  return list;
}

std::vector<PartId> SubsystemParts::joints() const {
  std::vector<PartId> list;
  for (const BodyParts& body : bodies)
    if (!body.is_root) list.push_back(body.joint);
  return list;
}

std::vector<PartId> SubsystemParts::ports() const {
  std::vector<PartId> list;
  for (const BodyParts& body : bodies) graph::add_to(list, graph::maybe(body.port));
  return list;
}

}  // namespace spoke
