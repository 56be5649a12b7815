#pragma once

// What sensors, loads and markers ask a body in space by its kind: places on it, and sums over it.

#include <string>

#include "engine/table/step_data.h"

namespace spoke {

struct SpatialMotion;
namespace space {
struct BodyEnergies;
}

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

 protected:
  ~BodyView() = default;
};

}  // namespace spoke
