#pragma once

// A solid in nodal coordinates as a kind.

#include "engine/bodies/kinds/solid/solid_kind.h"

namespace spoke {

/// Does all in one node where the solid has one slice; else what is between the slices.
class NodalKind final : public SolidKind, public BodySlices {
 public:
  space::Block make_block(const space::Body& body,
                          const space::BlockFactors& factors) const override;
  void make_tension(const ElasticShares& implicit, BodyMemory<Space>& memory,
                    Data& body) const override;
  void declare_tension(std::size_t j, SubsystemData<Space>& data) const override;
  void declare_inverse(const PartMaker& maker, Data& body, BodyParts& parts) const override;
  double estimate_constants(const space::Body& body) const override;
  double estimate_own(const TreeBody<Space>& member) const override;
  double count_own_nodes(const space::Body& body) const override;

  void calc_terms(const System<Space>& system, double t, const space::ImplicitShares& shares,
                  std::size_t j, SubsystemData<Space>& data) const noexcept override;
  void condense(const space::Twist& twist, bool implicit, const structured::BodyWork<Space>& work,
                Data& body) const noexcept override;
  void recover(const structured::BodyWork<Space>& work, bool implicit, Data& body,
               double* a) const noexcept override;
  const BodySlices* slices(const Data& body) const noexcept override;

  // By slices.
  void calc_terms(const System<Space>& system, double t, int j, int p,
                  SubsystemData<Space>& data) const noexcept override;
  void condense(int p, bool implicit, Data& body) const noexcept override;
  void recover(int p, bool implicit, Data& body) const noexcept override;
  void take(const Data& body, double* a) const noexcept override;
};

}  // namespace spoke
