// Lists the memory of planar bodies.

#include "engine/formulation/body_memory.h"

namespace spoke {

using graph::bytes_of;

Memory memory_of_motions(SubsystemData<Plane>& data) {
  return {bytes_of(data.joints[0], data.joints.size())};
}

Memory memory_of_twists(SubsystemData<Plane>& data) {
  Memory memory{bytes_of(data.twists[0], data.twists.size())};
  for (BodyData<Plane>& body : data.bodies)
    if (body.strain) memory.push_back(bytes_of(body.alpha));
  return memory;
}

Memory memory_of_wrenches(SubsystemData<Plane>& data) {
  return {bytes_of(data.wrenches[0], data.wrenches.size())};
}

Memory memory_of_terms(BodyData<Plane>& body) {
  Memory memory{bytes_of(body.terms)};
  add_flex(memory, body.c_theta, body.layout);
  add_flex(memory, body.Q_f, body.layout);
  if (!body.element_forces.empty())
    memory.push_back(memory_of(body.element_forces.data(), body.element_forces.size()));
  return memory;
}

Memory memory_of_wrenches_at_start(BodyData<Plane>& body) {
  if (!body.strain) return {};
  return {bytes_of(body.strain->wrenches[0], body.strain->wrenches.size())};
}

Memory memory_of_tension(BodyData<Plane>& body) {
  if (!body.strain) return {};
  plane::ImplicitStrain& strain = *body.strain;
  Memory memory{bytes_of(strain.turn), bytes_of(strain.S_W)};
  add_flex(memory, strain.lean.data(), body.layout);
  for (plane::NodalBand* band : {&strain.added, &strain.factor})
    memory.push_back(bytes_of(band->values()[0], band->values().size()));
  for (auto& pair : strain.columns) memory.push_back(bytes_of(pair[0], pair.size()));
  return memory;
}

Memory memory_of_inverse(BodyData<Plane>& body, plane::Condensed& work) {
  Memory memory{bytes_of(work.port)};
  add_flex(memory, work.W_theta, body.layout);
  add_flex(memory, work.z, body.layout);
  return memory;
}

Memory memory_of_workspace(BodyData<Plane>& body, plane::Condensed& work) {
  return {bytes_of(*work.scratch, static_cast<std::size_t>(body.layout.scratch_size()))};
}

}  // namespace spoke
