#pragma once

// A solid in modes as a kind.

#include "engine/bodies/kinds/solid/solid_kind.h"

namespace spoke {

class ReducedKind final : public SolidKind {
 public:
  space::Block make_block(const space::Body& body,
                          const space::BlockFactors& factors) const override;
  void declare_tension(std::size_t, SubsystemData<Space>&) const override {}
  std::span<double> rows_of(const Data& body) const noexcept override;
  std::span<double> scratch_of(const Data& body) const noexcept override;
  void declare_inverse(const PartMaker& maker, Data& body, BodyParts& parts) const override;
  double estimate_constants(const space::Body& body) const override;
  double estimate_own(const TreeBody<Space>&) const override { return 0.0; }

  void calc_terms(const System<Space>& system, double t, const space::ImplicitShares& shares,
                  std::size_t j, SubsystemData<Space>& data) const noexcept override;
  void condense(const space::Twist& twist, bool implicit, const structured::BodyWork<Space>& work,
                Data& body) const noexcept override;
  void recover(const structured::BodyWork<Space>& work, bool implicit, Data& body,
               double* a) const noexcept override;
};

}  // namespace spoke
