// Replaces places on anchors by places on bodies.

#include "models/tree/anchors_on_bodies.h"

#include <algorithm>
#include <string>
#include <vector>

namespace spoke::spatial {
namespace {

bool is_on_body(const Anchor& anchor) { return anchor.frame == Anchor::Frame::body; }

/// Closes the loops of a tree on bodies. `own`: the name of its subsystem; empty: a blade.
void put_loops(const std::string& own, const std::vector<Anchor>& anchors,
               std::vector<Loop>& loops) {
  for (Loop& loop : loops) {
    LoopPlace& to = loop.to;
    if (to.carrier != LoopPlace::Carrier::anchor) continue;
    const auto anchor = std::find_if(anchors.begin(), anchors.end(),
                                     [&to](const Anchor& one) { return one.name == to.name; });
    if (anchor == anchors.end() || !is_on_body(*anchor)) continue;
    const std::string carrier =
        anchor->subsystem.empty() ? std::string(kSupportName) : anchor->subsystem;
    to.carrier = carrier == own ? LoopPlace::Carrier::body : LoopPlace::Carrier::elsewhere;
    if (carrier != own) to.subsystem = carrier;
    to.name = anchor->body;
    to.station = anchor->station;
    to.interface = anchor->interface;
    to.moved_by = static_cast<int>(anchor - anchors.begin());
  }
}

}  // namespace

std::optional<Model> put_on_bodies_of_anchors(const Model& model) {
  if (std::none_of(model.anchors.begin(), model.anchors.end(), is_on_body)) return std::nullopt;
  Model put = model;
  for (Blade& blade : put.blades) put_loops({}, model.anchors, blade.loops);
  for (Subsystem& subsystem : put.subsystems)
    put_loops(subsystem.name, model.anchors, subsystem.loops);
  return put;
}

}  // namespace spoke::spatial
