#pragma once

// Names of modes in which the support of a rotor moves.

#include <string>

#include "engine/small_motions/vibration/mode_parts.h"

namespace spoke::vibration {

/// Returns the name of a mode by its motion z of the support, "tower fore-aft": the body or joint
/// that holds most of the potential energy, or without any, moves most; then the direction of what
/// it carries. In the plane of the axle and the vertical, the z axis of the base, that is
/// "fore-aft", across it "side-side"; or "vertical", or about the vertical "yaw". Where the axle is
/// vertical, "fore-aft" is along the x axis of the base. A rotor whose axle goes round, across
/// itself, has a "forward whirl" with the rotation, or a "backward whirl" against it. Turning about
/// the axle is "axle", of a further rotor "tail.axle". Of several rotors that of the first one
/// gives the directions, and each has its own sense. Precondition: all.linear.support.
std::string name_support_motion(const Eigen::VectorXcd& z, const Linearised& all);

/// Whether most of the energy of a mode is in its support and in what moves with the hub.
inline bool is_of_support(const ModeEnergy& energy) { return energy.support + energy.hub > 0.5; }

}  // namespace spoke::vibration
