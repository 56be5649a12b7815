#pragma once

// What sensors, loads, markers and pictures ask a body in space by its kind: places on it, sums
// over it, its limits and names.

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/bodies/table/step_data.h"
#include "engine/load.h"

namespace spoke {

struct SpatialMotion;
namespace space {
struct BodyEnergies;
struct BodyShape;
}  // namespace space

/// A coordinate that is not finite or beyond its limit; if its name is empty, there is none.
struct CoordinateViolation {
  std::string coordinate;  ///< "rotation ty of node 3"
  double value = 0.0;
  double limit = 0.0;
};

/// A deformation coordinate.
struct CoordinateName {
  std::string name;    ///< "node 3 / v"
  int node = 0;        ///< of the body
  bool turns = false;  ///< true: an angle [rad]; false: a length [m]
  double scale = 1.0;  ///< a large value of it [rad, m]
};

/// A place on a body with mass that is lumped there, in H.
struct LumpedNode {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();         ///< [m]
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< of its section, columns
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();    ///< of its mass; p but for rigid bodies [m]
  double mass = 0.0;                                   ///< [kg]
  double inertia = 0.0;                                ///< about its axis [kg m^2]
};

template <class World>
class BodyView;

template <>
class BodyView<Space> {
 public:
  using Data = BodyData<Space>;

  // Places. Rates and accelerations are those of the coordinates in the table.

  /// Returns the section at a marker; `whose` begins the message. Throws InputError if the body has
  /// no such place.
  virtual space::Section place_marker(const std::string& whose, const Marker& marker,
                                      const space::Body& body) const = 0;
  /// Returns the section at a station of its beam [m]; of other bodies the inboard end.
  virtual space::Section section_at(const space::Body& body, double station) const = 0;
  /// Returns the number of the place of a handle among those of a solid; -1: it is no solid.
  virtual int place_of_handle(const space::Body&, std::size_t) const { return -1; }
  /// Returns the motion of a section against the frame of its body.
  virtual space::HandleMotion motion_at(const Data& body,
                                        const space::Section& section) const noexcept = 0;
  /// Returns the acceleration of a section less gravity, in B, at the acceleration X and the
  /// angular velocity w of B and the flex vector a = q''. `motion`: of motion_at().
  virtual space::Twist calc_section_acceleration(const Data& body, const space::Section& section,
                                                 const space::HandleMotion& motion,
                                                 const space::Twist& X, const space::Angular& w,
                                                 const double* a) const noexcept = 0;
  /// Returns the share of the deformation in the acceleration of a handle: (u'', H th'').
  virtual space::Twist calc_handle_deformation(const Data&, int) const noexcept {
    return space::Twist::Zero();
  }
  /// Adds its angular part, in the order of the coordinates.
  virtual void add_handle_turning(const Data&, int, space::Angular&) const noexcept {}

  // By how much the stiffening draws places inward, along the axes of B.

  virtual space::DrawnInward calc_handle_drawn(const Data&, int) const noexcept { return {}; }
  virtual space::DrawnInward calc_section_drawn(const Data&, const space::Section&) const noexcept {
    return {};
  }
  // As sensors show it: of beams the foreshortening by bending; with its derivatives, added to the
  // motion `shown` for a body whose frame moves by `frame`. Handle 0: the tip.
  virtual space::Position calc_shown_drawn(const Data&, int) const noexcept {
    return space::Position::Zero();
  }
  virtual space::Position calc_shown_drawn(const Data&, const space::Section&) const noexcept {
    return space::Position::Zero();
  }
  virtual void add_shown_drawn(const Data&, int, const SpatialMotion&,
                               SpatialMotion&) const noexcept {}
  virtual void add_shown_drawn(const Data&, const space::Section&, const SpatialMotion&,
                               SpatialMotion&) const noexcept {}

  // Sums over the body.

  /// Returns the place of its outermost point, deformed, less the foreshortening, in B [m].
  virtual space::Position find_tip(const Data& body) const noexcept = 0;
  /// Returns its energies and its first moment.
  virtual space::BodyEnergies calc_energies(const Data& body, const space::Twist& twist,
                                            const space::BodyMotion& motion) const noexcept = 0;
  /// Returns its elastic energy [J].
  virtual double calc_strain_energy(const Data&) const noexcept { return 0.0; }
  /// Returns its momentum and the moment of that about B's origin, in B.
  virtual space::Twist calc_momentum(const Data& body,
                                     const space::Twist& twist) const noexcept = 0;
  /// Returns the loss of angular momentum about the hub's origin by geometric stiffening, Lambda
  /// w0, in H. Precondition: the body is stiffened in its tree.
  virtual space::Angular calc_stiffening_momentum(const Data&,
                                                  const space::Angular&) const noexcept {
    return space::Angular::Zero();
  }

  // Limits and names.

  /// Returns what kind of body messages call it: "solid".
  virtual const char* name() const noexcept = 0;
  /// Whether a coordinate is not finite or beyond its limit.
  virtual bool has_left_limits(const Data&) const noexcept { return false; }
  /// Returns the largest deflection at its nodes and in the middle between them, by its length; 0
  /// if it is within the linear range.
  virtual double find_large_deflection(const Data&) const noexcept { return 0.0; }
  /// Finds the first coordinate that is not finite, or else the one farthest beyond its limit.
  virtual CoordinateViolation find_violation(const Data&) const { return {}; }
  /// Returns the name of the first coordinate whose acceleration is not finite; empty if there is
  /// none.
  virtual std::string find_lost(const Data&) const { return {}; }
  /// Names its coordinates, in their order.
  virtual std::vector<CoordinateName> name_coordinates(const space::Body&) const { return {}; }
  /// Returns its extent [m], and the size of its coordinates, by which errors of these are measured
  /// [m]; 0 for a rigid body.
  virtual double length(const space::Body&) const noexcept { return 0.0; }
  virtual double coordinate_size(const space::Body& body) const noexcept { return length(body); }
  /// Returns how far a rigid body extends: to its handles, its centre, and by its inertia [m]; 0
  /// for others.
  virtual double reach(const space::Body&) const noexcept { return 0.0; }

  // Sensors of the scenario, and pictures.

  /// Returns the distance of the undeformed body from the root of its subsystem, along its beam
  /// [m]; 0 for others.
  virtual double station_of(const TreeBody<Space>&) const noexcept { return 0.0; }
  /// Sets the section of a reading at a station of the scenario's beam [m]; without a station, at
  /// the end.
  virtual void place_reading(const std::optional<double>& station, const TreeBody<Space>& member,
                             Reading<Space>& reading) const = 0;
  /// Adds the mass and the loads outboard of a reading's section to it.
  virtual void find_outboard(const TreeBody<Space>&, Reading<Space>&) const {}
  /// Returns the load of the section of a beam by the deformation of its element; none for others.
  /// `modal`: a deformation to be added (flex vector), or null.
  virtual std::optional<space::Twist> calc_stress(const Data&, const space::Section&, double,
                                                  const double*) const {
    return std::nullopt;
  }
  /// Returns the constants of a body from a mesh; null for others.
  virtual std::shared_ptr<const space::SolidConstants> mesh(const space::Body&) const {
    return nullptr;
  }
  /// Return the sections at a place and at a node of such a body, by their numbers; of others the
  /// inboard end.
  virtual space::Section section_at_place(const space::Body& body, int) const {
    return section_at(body, 0.0);
  }
  virtual space::Section section_at_node(const space::Body& body, int) const {
    return section_at(body, 0.0);
  }
  /// Adds what pictures show of it, which is empty.
  virtual void add_shape(const Data& body, space::BodyShape& shape) const = 0;
  /// Returns which of these nodes carries what hangs at a handle.
  virtual std::size_t node_of_handle(const space::Body&, std::size_t) const { return 0; }
  /// Returns its nodes with its mass; `pose`: of its frame in H.
  virtual std::vector<LumpedNode> lump(const Data& body, const space::Pose& pose) const = 0;
  /// Returns the axes of the section at its outer end, in H.
  virtual Eigen::Matrix3d outer_axes(const Data& body, const space::Pose& pose) const {
    return lump(body, pose).back().axes;
  }
  /// Returns those of the section at its inboard end, in B.
  virtual Eigen::Matrix3d inboard_axes(const Data&) const { return Eigen::Matrix3d::Identity(); }

 protected:
  ~BodyView() = default;
};

}  // namespace spoke
