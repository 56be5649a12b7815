#pragma once

// A beam in space as it is described: a reference curve, and along it sections, twist and small
// masses (docs/formulation.md, section 10). Places are given by the station x [m], the coordinate
// along the x axis of the beam's frame.

#include <cstddef>
#include <optional>
#include <vector>

#include "models/space/reference_curve.h"
#include "models/space/section_matrices.h"

namespace spoke::space {

/// A small rigid mass that is fixed to a section.
struct PointMass {
  double station = 0.0;  ///< [m]
  /// Mass moments about the section's reference point, in its axes.
  MassMoments moments;
};

/// A cross section of a beam at a station.
struct SectionAt {
  Position p;        ///< its reference point in the beam's frame [m]
  Position tangent;  ///< dp/dx: of length 1 if the beam is straight
  Rotation axes;     ///< rotation from section axes to the beam's frame
};

/// A beam by stations that ascend. Sections and twist have one entry for each station, but either
/// `properties` or `matrices` is empty, and `twist` may be empty.
struct Beam {
  /// Stations from the first to the last place of the beam [m].
  std::vector<double> station;
  std::vector<SectionProperties> properties;  ///< linear between stations
  std::vector<StiffnessAndMass> matrices;     ///< linear between stations
  /// Twist of the sections about the tangent, right-handed, from the beam's y and z axes [rad];
  /// linear between stations.
  std::vector<double> twist;
  ReferenceCurve curve;
  std::vector<PointMass> masses;
  /// Damping in proportion to the stiffness, a factor [s] for each strain.
  Twist damping = Twist::Zero();
  /// Damping in proportion to the whole stiffness, besides [s].
  double stiffness_damping = 0.0;
  bool is_nonlinear = false;  ///< whether its strains are of second order

  bool is_damped() const { return !damping.isZero(0.0) || stiffness_damping != 0.0; }

  SectionMatrices section(double x) const;
  double twist_at(double x) const;
  SectionAt geometry(double x) const;

  /// Returns the stations between `from` and `to` [m] at which a property, the twist, the curve or
  /// the mass outboard changes its law, both ends included, in order.
  std::vector<double> breaks(double from, double to) const;

  /// Returns the number of the first station of the stretch of equal sections, equally twisted,
  /// in which all between `from` and `to` [m] lies, both ends included; none if the axis is not
  /// straight, sections differ there, or a small mass stands there.
  std::optional<std::size_t> uniform_stretch(double from, double to) const;
  /// Returns a beam of this length [m] from 0 on, of the sections of a stretch.
  Beam uniform_piece(std::size_t stretch, double length) const;

 private:
  std::size_t interval(double x) const;
};

}  // namespace spoke::space
