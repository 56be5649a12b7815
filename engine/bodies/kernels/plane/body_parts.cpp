// Declares the parts of planar bodies.

#include "engine/bodies/kernels/body_parts.h"

#include "engine/bodies/table/body_parts.h"

namespace spoke {

using graph::bytes_of;

void declare_motions(SubsystemData<Plane>& data) {
  const PartMaker& maker = data.part_maker;
  data.parts.rotations = maker.cover("rotations", Mark::none, data.joints);
  data.parts.twists = maker.cover("twists", Mark::none, data.twists);
  data.parts.wrenches = maker.cover("wrenches", Mark::none, data.wrenches);
}

void declare_terms(std::size_t j, SubsystemData<Plane>& data) {
  const PartMaker maker = maker_of_body(j, data);
  BodyData<Plane>& body = data.bodies[j];
  BodyParts& parts = data.parts.bodies[j];
  Memory flex;
  add_flex(flex, body.c_theta, body.layout);
  add_flex(flex, body.Q_f, body.layout);
  plane::Terms& terms = body.terms;
  parts.terms = maker.cover("terms", Mark::none, terms.S, terms.rotary_inertia, terms.Q,
                            terms.stiffening, flex);
  parts.power = maker.cover("power", Mark::reported, terms.load_power, terms.dissipation);
  BodyReport& report = body.report;
  parts.report = maker.cover("report", Mark::reported, report.change, report.step_change,
                             report.deflection, report.error, report.failed);
}

void declare_tension(std::size_t j, SubsystemData<Plane>& data) {
  const PartMaker maker = maker_of_body(j, data);
  BodyData<Plane>& body = data.bodies[j];
  BodyParts& parts = data.parts.bodies[j];
  if (!body.strain) return;
  plane::ImplicitStrain& strain = *body.strain;
  maker.add(parts.coordinates, strain.wrenches);  // those at the state at which a step begins
  maker.add(data.parts.twists, body.alpha);
  Memory memory;
  add_flex(memory, strain.lean.data(), body.layout);
  for (plane::NodalBand* band : {&strain.added, &strain.factor})
    memory.push_back(bytes_of(band->values()));
  for (auto& pair : strain.columns) memory.push_back(bytes_of(pair));
  parts.tension = maker.cover("tension", Mark::none, strain.turn, strain.S_W, memory);
}

void declare_inverse(std::size_t j, structured::BodyWork<Plane>& work, SubsystemData<Plane>& data) {
  const PartMaker maker = maker_of_body(j, data);
  const BodyData<Plane>& body = data.bodies[j];
  BodyParts& parts = data.parts.bodies[j];
  Memory flex;
  add_flex(flex, work.W_theta, body.layout);
  add_flex(flex, work.z, body.layout);
  parts.inverse = maker.cover("inverse", Mark::none, work.port, flex);
  parts.workspace =
      maker.cover("workspace", Mark::none,
                  memory_of(work.scratch, static_cast<std::size_t>(body.layout.scratch_size())));
}

}  // namespace spoke
