#pragma once

// The types of a body's constants and terms, by world: what kernels keep in the table.

namespace spoke {

/// Specialised for each world, with the members
///   Layout      how its deformation coordinates lie in memory
///   Block       its constant elastic block, factorised
///   Section     a cross section anywhere on it
///   Handle      where the coordinates of a handle stand in flex vectors
///   Terms       what its state determines of its equations of motion
///   Port        what it shows its neighbours once its deformation is eliminated
///   kCouplings  number of the flex vectors that couple its rotation to its deformation
template <class World>
struct BodyTypes;

}  // namespace spoke
