// Declares the parts of spatial bodies.

#include "engine/bodies/kernels/body_parts.h"

#include "engine/bodies/table/body_kind.h"
#include "engine/bodies/table/body_parts.h"

namespace spoke {
namespace {

std::size_t handles_of(const BodyData<Space>& body) {
  return static_cast<std::size_t>(body.work.port.handles);
}

}  // namespace

void declare_motions(SubsystemData<Space>& data) {
  const PartMaker& maker = data.part_maker;
  SubsystemParts& parts = data.parts;
  parts.rotations = maker.cover("rotations", Mark::none, data.joints);
  parts.twists = maker.cover("twists", Mark::none, data.twists);
  parts.wrenches = maker.cover("wrenches", Mark::none, data.wrenches);
  for (BodyData<Space>& body : data.bodies) {
    const auto driven = static_cast<std::size_t>(body.model->joint.joint.driven);
    maker.add(parts.rotations, memory_of(body.work.handles, handles_of(body)), body.alpha,
              memory_of(body.joint.driven, driven));
    maker.add(parts.wrenches, memory_of(body.work.wrenches, handles_of(body)));
    const CoordinateBlock& joint = body.joint.coordinates;
    if (body.joint.a_found != joint.a)
      maker.add(parts.wrenches,
                memory_of(body.joint.a_found, static_cast<std::size_t>(joint.size)));
  }
}

void add_joint_coordinates(std::size_t j, SubsystemData<Space>& data) {
  const PartMaker& maker = data.part_maker;
  BodyData<Space>& body = data.bodies[j];
  const BodyParts& parts = data.parts.bodies[j];
  const CoordinateBlock& block = body.joint.coordinates;
  if (block.size == 0) return;
  const auto n = static_cast<std::size_t>(block.size);
  maker.add(parts.coordinates, memory_of(block.q, n), memory_of(block.v, n),
            body.joint.rotation->reference);
  maker.add(parts.accelerations, memory_of(block.a, n));
  for (double* h : block.history)
    if (h) maker.add(parts.history, memory_of(h, n));
  maker.add(parts.history, body.joint.rotation->sum);
}

void declare_terms(std::size_t j, SubsystemData<Space>& data) {
  const PartMaker maker = maker_of_body(j, data);
  BodyData<Space>& body = data.bodies[j];
  BodyParts& parts = data.parts.bodies[j];
  space::BodyTerms& terms = body.terms;
  parts.terms = maker.cover("terms", Mark::none, terms.S, terms.S_rate, terms.Theta, terms.Q,
                            terms.stiffening, terms.tension,
                            std::as_writable_bytes(body.kind->rows_of(body)));
  parts.power = maker.cover("power", Mark::reported, terms.load_power, terms.dissipation);
  if (body.joint.coordinates.size > 0) maker.add(parts.terms, *body.joint.forces);
  parts.scratch =
      maker.cover("scratch", Mark::none, std::as_writable_bytes(body.kind->scratch_of(body)));
  BodyReport& report = body.report;
  parts.report = maker.cover("report", Mark::reported, report.change, report.step_change,
                             report.deflection, report.error, report.failed, report.drive_power);
}

namespace {

void declare_port(const PartMaker& maker, bool by_mass, BodyData<Space>& body, BodyParts& parts) {
  const tree::MultiPort<Space>& port = body.work.port;
  const std::size_t n = handles_of(body);
  parts.port = maker.cover("port", Mark::none, memory_of(port.diagonal, by_mass ? 1 : n),
                           memory_of(port.free, n));
  if (by_mass) return;
  const int pairs = tree::MultiPort<Space>::count_pairs(port.handles);
  maker.add(parts.port, memory_of(port.pairs, static_cast<std::size_t>(pairs)));
}

}  // namespace

void declare_inverse(std::size_t j, structured::BodyWork<Space>& work, SubsystemData<Space>& data) {
  const PartMaker maker = maker_of_body(j, data);
  BodyData<Space>& body = data.bodies[j];
  BodyParts& parts = data.parts.bodies[j];
  parts.inverse = maker.cover("inverse", Mark::none, Memory{});
  declare_port(maker, work.by_mass, body, parts);
  body.kind->declare_inverse(maker, body, parts);
}

}  // namespace spoke
