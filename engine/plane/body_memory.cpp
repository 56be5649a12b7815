// Lists the memory of planar bodies.

#include "engine/formulation/body_memory.h"

namespace spoke {

using graph::bytes_of;

Memory memory_of_motions(SubsystemData<Plane>& data) {
  return {bytes_of(data.joints[0], data.joints.size())};
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
