#pragma once

// The types of a body's constants and terms, by world: those that kernels keep in the table.

namespace spoke {

/// Specialised for each world, with the members
///   Layout          how its deformation coordinates lie in memory
///   Block           its constant elastic block, factorised
///   Section         a cross section anywhere on it
///   Terms           what its state determines of its equations of motion
///   Fields          what else it has of its own in the table
///   Condensed       what the formulation `structured` keeps of it
///   HandleWrenches  wrenches on its handles
///   JointMotion     motion of the joint that carries it; its member R is R_PB
///   ImplicitStrain  strains of second order in implicit steps
///   HubStiffening   what its geometric stiffening adds to the hub's equation
///   Attitude        what the hub's orientation has besides its coordinates
///   CarriedInertia    what the hub of a rotor on a support carries
///   RecordedRotation  what a step's record has of it besides position and velocity
template <class World>
struct BodyTypes;

/// What the engine asks a body by its kind (engine/bodies/table/body_kind.h).
template <class World>
class BodyKind;

}  // namespace spoke
