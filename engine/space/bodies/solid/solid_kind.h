#pragma once

// A body from a mesh as a kind: what reduced solids and those in nodal coordinates have in common.

#include "engine/table/body_kind.h"

namespace spoke {

class SolidKind : public BodyKind<Space> {
 public:
  std::size_t count_work(const space::Body& body) const override;
  space::BodyWork place_work(const space::Body& body, double* memory) const override;
  double calc_surely_linear(const space::Body& body, double range) const override;
  void make_tension(const ElasticShares& implicit, FormulationWork<Space>& work,
                    Data& body) const override;
  PlacedLoad<Space, BodyLoad<Space>> place_load(const BodyLoad<Space>& load,
                                                const space::Body& body) const override;

  void add_applied(double t, const space::Rotation& R_HB, std::size_t j,
                   SubsystemData<Space>& data) const noexcept override;
  void add_forces(double factor, const double* forces, Data& body) const noexcept override;
  space::Position sum_loads(double t, const space::Rotation& R_HB, const space::Rotation& R_0,
                            const Data& body) const noexcept override;
  space::Position calc_linear_momentum(const Data& body,
                                       const space::Twist& twist) const noexcept override;

 protected:
  ~SolidKind() = default;
};

/// Returns the constant block of a solid, explicit or implicit.
const space::SolidBlock& solid_block_of(const BodyData<Space>& body, bool implicit) noexcept;
/// Counts the doubles of its half solutions, and of what kernels read, in both blocks.
double count_solid_rows(const space::Solid& solid);

}  // namespace spoke
