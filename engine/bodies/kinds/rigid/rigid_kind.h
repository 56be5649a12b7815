#pragma once

// A rigid body as a kind.

#include "engine/bodies/table/body_kind.h"

namespace spoke {

class RigidKind : public BodyKind<Space> {
 public:
  std::size_t count_work(const space::Body& body) const override;
  space::BodyWork place_work(const space::Body& body, double* memory) const override;
  double calc_surely_linear(const space::Body& body, double range) const override;
  bool has_mass_alone() const override { return true; }
  space::Block make_block(const space::Body& body,
                          const space::BlockFactors& factors) const override;
  void make_tension(const ElasticShares&, BodyMemory<Space>&, Data&) const override {}
  void declare_tension(std::size_t, SubsystemData<Space>&) const override {}
  void declare_inverse(const PartMaker&, Data&, BodyParts&) const override {}
  PlacedLoad<Space, BodyLoad<Space>> place_load(const BodyLoad<Space>& load,
                                                const space::Body& body) const override;
  double estimate_constants(const space::Body& body) const override;
  double estimate_own(const TreeBody<Space>&) const override { return 0.0; }

  void place_handles(Data& body) const noexcept override;
  void calc_terms(const System<Space>& system, double t, const space::ImplicitShares& shares,
                  std::size_t j, SubsystemData<Space>& data) const noexcept override;
  void add_applied(double t, const space::Rotation& R_HB, std::size_t j,
                   SubsystemData<Space>& data) const noexcept override;
  void add_forces(double, const double*, Data&) const noexcept override {}
  space::Position sum_loads(double t, const space::Rotation& R_HB, const space::Rotation& R_0,
                            const Data& body) const noexcept override;
  space::Position calc_linear_momentum(const Data& body,
                                       const space::Twist& twist) const noexcept override;
  void condense(const space::Twist& twist, bool implicit, const structured::BodyWork<Space>& work,
                Data& body) const noexcept override;
  void recover(const structured::BodyWork<Space>& work, bool implicit, Data& body,
               double* a) const noexcept override;

  Eigen::MatrixXd make_dense_block(const space::Body& body,
                                   const space::BlockFactors& factors) const override;
  void calc_dense_mass(const Data& body, const Eigen::MatrixXd& elastic, bool implicit,
                       Eigen::Ref<Eigen::MatrixXd> mass) const override;
  void calc_dense_force(const Data& body, Eigen::Ref<Eigen::VectorXd> force) const override;
  void calc_handle_jacobian(const Data& body, int handle,
                            Eigen::Ref<Eigen::MatrixXd> J) const override;
  Eigen::MatrixXd calc_own_mass(const Data& body) const override;
  Eigen::VectorXd calc_frame_force(const Data& body) const override;

  space::Section place_marker(const std::string& whose, const Marker& marker,
                              const space::Body& body) const override;
  space::Section section_at(const space::Body& body, double station) const override;
  space::HandleMotion motion_at(const Data& body,
                                const space::Section& section) const noexcept override;
  space::Twist calc_section_acceleration(const Data& body, const space::Section& section,
                                         const space::HandleMotion& motion, const space::Twist& X,
                                         const space::Angular& w,
                                         const double* a) const noexcept override;
  space::Position find_tip(const Data& body) const noexcept override;
  space::BodyEnergies calc_energies(const Data& body, const space::Twist& twist,
                                    const space::BodyMotion& motion) const noexcept override;
  space::Twist calc_momentum(const Data& body, const space::Twist& twist) const noexcept override;

  const char* name() const noexcept override { return "rigid body"; }
  double reach(const space::Body& body) const noexcept override;
  void place_reading(const std::optional<double>& station, const TreeBody<Space>& member,
                     Reading<Space>& reading) const override;
  void add_shape(const Data& body, space::BodyShape& shape) const override;
  std::vector<LumpedNode> lump(const Data& body, const space::Pose& pose) const override;
};

/// Returns M_RR of a rigid body about the origin of its frame.
const space::SymmetricTwistMatrix& rigid_mass_of(const BodyData<Space>& body);

}  // namespace spoke
