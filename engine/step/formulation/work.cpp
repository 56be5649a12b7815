// Allocates the memory of the chosen formulation, and estimates it.

#include "engine/step/formulation/work.h"

#include <set>

#include "engine/bodies/kernels/body_parts.h"
#include "engine/bodies/kernels/dense_body.h"
#include "engine/bodies/table/body_kind.h"
#include "engine/step/formulation/tree_joints.h"

namespace spoke {
namespace {

plane::ElasticBlock make_block(const plane::FlexibleBody& body, const ElasticShares& shares) {
  return make_elastic_block(body, shares.mass_factor, shares.stiffness_factor,
                            shares.damping_factor);
}
space::Block make_block(const space::Body& body, const ElasticShares& shares) {
  return kind_of(body).make_block(body, factors_of(shares));
}

/// Returns the dense Mhat of a body.
// The stiffness of strains of second order changes, and is added in every step.
Eigen::MatrixXd make_dense_block(const plane::FlexibleBody& body, const ElasticShares& shares) {
  if (body.is_nonlinear()) return make_dense_elastic_block(body, 1.0, 0.0);
  return make_dense_elastic_block(body, shares.mass_factor, shares.stiffness_factor,
                                  shares.damping_factor);
}
Eigen::MatrixXd make_dense_block(const space::Body& body, const ElasticShares& shares) {
  if (kind_of(body).has_nonlinear_strain(body)) return make_dense_elastic_block(body, {});
  return make_dense_elastic_block(body, factors_of(shares));
}

template <class World>
using BodyKey = const typename World::Body*;

/// Makes the dense elastic blocks of all bodies, by subsystem and body, shared by bodies of one
/// type.
template <class World>
std::vector<std::vector<subsystem::DenseBlocks>> make_dense_blocks(
    const StepData<World>& data, const ElasticShares& implicit, DenseConstants<World>& constants) {
  std::vector<std::vector<subsystem::DenseBlocks>> blocks;
  for (const SubsystemData<World>& subsystem : data.subsystems) {
    blocks.emplace_back();
    for (const BodyData<World>& member : subsystem.bodies) {
      const typename World::Body& body = *member.model->body;
      const auto make = [&](const ElasticShares& shares) {
        return std::make_shared<Eigen::MatrixXd>(make_dense_block(body, shares));
      };
      blocks.back().push_back(find_or_add(constants, &body, [&] {
        return subsystem::DenseBlocks{make(ElasticShares{}), make(implicit)};
      }));
    }
  }
  return blocks;
}

// What stiffens a body; in the plane only strains of second order, in implicit steps.

void make_tension(const ElasticShares& implicit, BodyMemory<Plane>& memory,
                  BodyData<Plane>& member) {
  if (implicit.tension_factor == 0.0 || !has_nonlinear_strain(member)) return;
  memory.strains.push_back(std::make_unique<plane::ImplicitStrain>(plane::make_implicit_strain(
      *member.model->body,
      {implicit.stiffness_factor, implicit.damping_factor, implicit.tension_factor})));
  member.strain = memory.strains.back().get();
}
void make_tension(const ElasticShares& implicit, BodyMemory<Space>& memory,
                  BodyData<Space>& member) {
  member.kind->make_tension(implicit, memory, member);
}

template <class World>
void make_elastic_blocks(const ElasticShares& implicit, StepData<World>& data,
                         BodyMemory<World>& memory) {
  for (SubsystemData<World>& subsystem : data.subsystems)
    for (std::size_t j = 0; j < subsystem.bodies.size(); ++j) {
      BodyData<World>& member = subsystem.bodies[j];
      const typename World::Body& body = *member.model->body;
      const auto& pair = find_or_add(memory.constants->blocks, &body, [&] {
        return std::array{make_block(body, ElasticShares{}), make_block(body, implicit)};
      });
      member.blocks = {&pair[0], &pair[1]};
      make_tension(implicit, memory, member);
      declare_tension(j, subsystem);
    }
}

// Memory of a body's constants, which bodies of one kind share, and of its data in the table, with
// the structured formulation's workspace [bytes].

/// Counts bands and their factors: some 44 numbers a coordinate.
double estimate_constants(const plane::FlexibleBody& body) {
  return 44.0 * sizeof(double) * body.coordinates();
}
double estimate_table(const TreeBody<Plane>& member) {
  // Three bands, three pairs of columns.
  constexpr double kStrain = 3.0 * (plane::NodalBand::kHalf + 1) + 6.0;
  const double strain = member.body->is_nonlinear() ? sizeof(double) * kStrain : 0.0;
  return (190.0 + strain) * member.body->coordinates() + 3100.0;
}

double estimate_constants(const space::Body& body) {
  return kind_of(body).estimate_constants(body);
}
double estimate_table(const TreeBody<Space>& member) {
  const BodyKind<Space>& kind = kind_of(*member.body);
  const auto history = static_cast<int>(CoordinateBlock{}.history.size());
  const auto vectors =
      static_cast<std::size_t>(space::make_layout(*member.body).stride() * (4 + history));
  // The state from which a failure can be repeated is a copy of the state.
  const std::size_t numbers = 2 * (vectors + space::count_state(member.joint.joint, history)) +
                              kind.count_work(*member.body);
  return kind.estimate_own(member) +
         static_cast<double>(sizeof(double) * numbers + sizeof(BodyData<Space>) +
                             sizeof(structured::BodyWork<Space>) + sizeof(space::JointMotion) +
                             sizeof(space::Pose) + 3 * sizeof(space::Twist));
}

/// Counts the constants of all kinds of bodies; in the dense formulations two full blocks each.
/// Bodies of tapered beams are all of kinds of their own.
template <class World>
double estimate_constants(const System<World>& system, Formulation formulation) {
  std::set<BodyKey<World>> kinds;
  double bytes = 0.0;
  for (const Subsystem<World>& subsystem : system.subsystems)
    for (const TreeBody<World>& member : subsystem.bodies) {
      if (!kinds.insert(member.body.get()).second) continue;
      const double nf = member.body->coordinates();
      bytes += estimate_constants(*member.body);
      if (formulation != Formulation::structured) bytes += 2.0 * sizeof(double) * nf * nf;
    }
  return bytes;
}

/// Counts a load or drag with its sections.
template <class Load>
double estimate_load(const Load& load) {
  return static_cast<double>(load.points.size()) * (sizeof(LoadPoint) + sizeof(plane::Section));
}
/// Counts a spatial load; the sections of a load per length are four at a time.
double estimate_load(const BodyLoad<Space>& load) {
  double bytes = 0.0;
  for (const BodyLoad<Space>::Point& point : load.points)
    bytes += sizeof(point) + sizeof(space::LoadedSections) / (point.length > 0.0 ? 4.0 : 1.0);
  return bytes;
}

/// Counts the loops of a subsystem, their constants and what is in the table; `joints`: the rows of
/// all its joints, by which the formulation `subsystem` has columns.
template <class World>
double estimate_loops(const Subsystem<World>& subsystem, Formulation formulation, double joints) {
  const double rows = subsystem.loop_rows();
  if (rows == 0.0) return 0.0;
  const auto bodies = static_cast<double>(subsystem.bodies.size());
  const auto loops = static_cast<double>(subsystem.loops.size());
  constexpr double kTwistBytes = sizeof(TwistOf<World>);
  // By row: its state, N and half of it, and at most a twist for each body and each joint.
  double bytes = bodies * (sizeof(PoseOf<World>) + kTwistBytes) + sizeof(double) * rows * rows +
                 rows * (sizeof(LoopRowState<World>) + 8.0 * sizeof(double) + 2.0 * kTwistBytes +
                         2.0 * bodies * kTwistBytes);
  // By loop: its model and its path, which has at most all bodies and their joints.
  bytes += rows * sizeof(LoopRow) + loops * (sizeof(LoopModel) + sizeof(LoopPath) +
                                             bodies * (sizeof(int) + sizeof(LoadedJoint)));
  if (formulation == Formulation::subsystem) bytes += 3.0 * sizeof(double) * rows * joints;
  return bytes;
}

}  // namespace

template <class World>
void allocate(const System<World>& system, Formulation formulation, const ElasticShares& implicit,
              StepData<World>& data, FormulationWork<World>& work) {
  const std::size_t count = data.subsystems.size();
  make_elastic_blocks(implicit, data, work.bodies);
  if (formulation == Formulation::structured) {
    work.structured.resize(count);
    for (std::size_t i = 0; i < count; ++i)
      structured::allocate(data.subsystems[i], work.structured[i]);
    return;
  }
  auto blocks = make_dense_blocks(data, implicit, *work.dense);
  if (formulation == Formulation::augmented)
    return augmented::allocate(system, std::move(blocks), data, work.augmented);
  work.subsystem.resize(count);
  for (std::size_t i = 0; i < count; ++i)
    subsystem::allocate(blocks[i], data.subsystems[i], work.subsystem[i]);
}

template <class World>
double estimate_memory(const System<World>& system, Formulation formulation) {
  constexpr double kNumber = sizeof(double);
  double bytes = estimate_constants(system, formulation);
  double unknowns = 2.0 * World::kTwist;
  for (const Subsystem<World>& subsystem : system.subsystems) {
    double joints = World::kTwist * static_cast<double>(subsystem.bodies.size());
    for (const TreeBody<World>& member : subsystem.bodies) {
      const double nf = member.body->coordinates(), coordinates = joint_coordinates(member);
      unknowns += 2.0 * World::kTwist + nf + coordinates;
      joints += coordinates;
      bytes += estimate_table(member);
      const double n = World::kTwist + nf;
      const double rows = World::kTwist * handle_count(*member.body);
      if (formulation == Formulation::subsystem) bytes += kNumber * n * (n + 2.0 * rows + 1.0);
      for (const BodyLoad<World>& load : member.loads) bytes += estimate_load(load);
      for (const BodyDrag<World>& drag : member.drags) bytes += estimate_load(drag);
    }
    if (formulation == Formulation::subsystem) bytes += kNumber * joints * joints;
    bytes += estimate_loops(subsystem, formulation, joints);
    unknowns += subsystem.loop_rows();
  }
  if (formulation == Formulation::augmented) bytes += 2.0 * kNumber * unknowns * unknowns;
  return bytes;
}

template void allocate(const System<Plane>&, Formulation, const ElasticShares&, StepData<Plane>&,
                       FormulationWork<Plane>&);
template void allocate(const System<Space>&, Formulation, const ElasticShares&, StepData<Space>&,
                       FormulationWork<Space>&);
template double estimate_memory(const System<Plane>&, Formulation);
template double estimate_memory(const System<Space>&, Formulation);

}  // namespace spoke
