#pragma once

// A body from a mesh as a kind: what reduced solids and those in nodal coordinates have in common.

#include "engine/bodies/table/body_kind.h"

namespace spoke {

class SolidKind : public BodyKind<Space> {
 public:
  std::size_t count_work(const space::Body& body) const override;
  space::BodyWork place_work(const space::Body& body, double* memory) const override;
  double calc_surely_linear(const space::Body& body, double range) const override;
  void make_tension(const ElasticShares& implicit, BodyMemory<Space>& memory,
                    Data& body) const override;
  PlacedLoad<Space, BodyLoad<Space>> place_load(const BodyLoad<Space>& load,
                                                const space::Body& body) const override;

  void place_handles(Data& body) const noexcept override;
  void leave_inboard(const Data& body, space::JointMotion& joint,
                     space::Twist& twist) const noexcept override;
  void add_applied(double t, const space::Rotation& R_HB, std::size_t j,
                   SubsystemData<Space>& data) const noexcept override;
  void add_forces(double factor, const double* forces, Data& body) const noexcept override;
  space::Position sum_loads(double t, const space::Rotation& R_HB, const space::Rotation& R_0,
                            const Data& body) const noexcept override;
  space::Position calc_linear_momentum(const Data& body,
                                       const space::Twist& twist) const noexcept override;

  Eigen::MatrixXd make_dense_block(const space::Body& body,
                                   const space::BlockFactors& factors) const override;
  void calc_dense_mass(const Data& body, const Eigen::MatrixXd& elastic, bool implicit,
                       Eigen::Ref<Eigen::MatrixXd> mass) const override;
  void calc_dense_force(const Data& body, Eigen::Ref<Eigen::VectorXd> force) const override;
  void calc_handle_jacobian(const Data& body, int handle,
                            Eigen::Ref<Eigen::MatrixXd> J) const override;
  void add_stiffness_trace(const space::Body& body, double& trace) const override;
  Eigen::VectorXd calc_frame_force(const Data& body) const override;

  space::Section place_marker(const std::string& whose, const Marker& marker,
                              const space::Body& body) const override;
  space::Section section_at(const space::Body& body, double station) const override;
  int place_of_handle(const space::Body& body, std::size_t handle) const override;
  space::HandleMotion motion_at(const Data& body,
                                const space::Section& section) const noexcept override;
  space::Twist calc_section_acceleration(const Data& body, const space::Section& section,
                                         const space::HandleMotion& motion, const space::Twist& X,
                                         const space::Angular& w,
                                         const double* a) const noexcept override;
  space::Twist calc_handle_deformation(const Data& body, int handle) const noexcept override;
  void add_handle_turning(const Data& body, int handle,
                          space::Angular& sum) const noexcept override;
  space::DrawnInward calc_handle_drawn(const Data& body, int handle) const noexcept override;
  space::DrawnInward calc_section_drawn(const Data& body,
                                        const space::Section& section) const noexcept override;
  space::Position calc_shown_drawn(const Data& body, int handle) const noexcept override;
  space::Position calc_shown_drawn(const Data& body,
                                   const space::Section& section) const noexcept override;
  void add_shown_drawn(const Data& body, int handle, const SpatialMotion& frame,
                       SpatialMotion& shown) const noexcept override;
  void add_shown_drawn(const Data& body, const space::Section& section, const SpatialMotion& frame,
                       SpatialMotion& shown) const noexcept override;
  space::Position find_tip(const Data& body) const noexcept override;
  space::BodyEnergies calc_energies(const Data& body, const space::Twist& twist,
                                    const space::BodyMotion& motion) const noexcept override;
  space::Twist calc_momentum(const Data& body, const space::Twist& twist) const noexcept override;
  double calc_strain_energy(const Data& body) const noexcept override;
  space::Angular calc_stiffening_momentum(const Data& body,
                                          const space::Angular& hub_w) const noexcept override;

  const char* name() const noexcept override { return "solid"; }
  bool has_left_limits(const Data& body) const noexcept override;
  double find_large_deflection(const Data& body) const noexcept override;
  CoordinateViolation find_violation(const Data& body) const override;
  std::string find_lost(const Data& body) const override;
  std::vector<CoordinateName> name_coordinates(const space::Body& body) const override;
  double length(const space::Body& body) const noexcept override;
  double coordinate_size(const space::Body& body) const noexcept override;
  void place_reading(const std::optional<double>& station, const TreeBody<Space>& member,
                     Reading<Space>& reading) const override;
  std::shared_ptr<const space::SolidConstants> mesh(const space::Body& body) const override;
  space::Section section_at_place(const space::Body& body, int place) const override;
  space::Section section_at_node(const space::Body& body, int node) const override;
  void add_shape(const Data& body, space::BodyShape& shape) const override;
  std::size_t node_of_handle(const space::Body& body, std::size_t handle) const override;
  std::vector<LumpedNode> lump(const Data& body, const space::Pose& pose) const override;
  Eigen::Matrix3d outer_axes(const Data& body, const space::Pose& pose) const override;
  Eigen::Matrix3d inboard_axes(const Data& body) const override;

 protected:
  ~SolidKind() = default;
};

/// Returns the constant block of a solid, explicit or implicit.
const space::SolidBlock& solid_block_of(const BodyData<Space>& body, bool implicit) noexcept;
/// Counts the doubles of its half solutions, and of what kernels read, in both blocks.
double count_solid_rows(const space::Solid& solid);

}  // namespace spoke
