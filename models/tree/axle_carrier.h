#pragma once

// Which blade or subsystem carries the axle of a rotor, and what of a tree is then its tip.

#include <cstddef>
#include <string>

#include "models/tree/tree.h"

namespace spoke::spatial {

/// Returns the name of the tree of a blade, by its number from 1: "blade 2". No subsystem has it.
std::string name_of_blade(std::size_t number);

/// Returns the number of the blade that carries an axle, Axle::subsystem being the name of its
/// tree; 0: none does. It may be larger than the number of blades.
int find_blade_of(const Axle& axle);

/// Returns the rotors whose axles a blade of the model carries, ascending.
std::vector<int> find_rotors_on(const Model& model, const Blade& blade);

/// Returns the index of the body at a tree's tip: the last one; of a tree on a hub the last one
/// that is not of a rotor that it carries.
std::size_t find_tip_body(const Tree& tree);

}  // namespace spoke::spatial
