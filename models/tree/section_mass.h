#pragma once

// The mass of a beam's sections, from whichever data the beam has.

#include <vector>

#include "models/spatial_model.h"

namespace spoke::spatial {

/// Of a slice of unit length, about its point of the axis, in section axes (x normal).
struct SectionMass {
  double mass = 0.0;                     ///< [kg/m]
  Vector first_moment = Vector::Zero();  ///< [kg]; x is 0
  Tensor inertia = Tensor::Zero();       ///< [kg m]; of a thin slice: xx is the sum of yy and zz
};

/// The 6 x 6 mass matrices of a beam's sections at its stations, in the axes of the sections, about
/// the axis; of sections given by values those that follow. Precondition: the sections are fine.
std::vector<SectionMatrix> make_mass_matrices(const Sections& sections);

/// Between stations the entries of the matrices are linear.
class SectionMasses {
 public:
  explicit SectionMasses(const Sections& sections);
  SectionMass at(double x) const;

 private:
  const std::vector<double>& station_;
  std::vector<SectionMatrix> matrices_;
};

}  // namespace spoke::spatial
