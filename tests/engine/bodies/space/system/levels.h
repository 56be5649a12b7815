#pragma once

// Scenarios of rotors on what other rotors carry: four levels, or the same machine as one tree.

#include <string>

namespace spoke::test {

/// What the machine stands on, and what is different about it.
struct LevelsCase {
  std::string support;         ///< table [support], whose body "stage" carries the first axle
  std::string loops{};         ///< closures of the innermost body, whose `to` ends with TO(...)
  std::string damping{};       ///< of hinges
  std::string drive = "free";  ///< of the middle hub
  bool is_at_rest = false;     ///< whether nothing moves at the start, and the first hub is held
  std::string arm{};           ///< keys of the joint of the arm besides
  std::string couplings{};     ///< of the innermost hinge, likewise
};

extern const std::string kOnBush;  ///< on a bushing on the ground
extern const std::string kFlying;  ///< on a fuselage in flight
extern const std::string kLevelsWeight;
extern const std::string kBoom;  ///< a body: a beam of 1 m

/// Returns the tables of a rotor, by the keys of its drive and of its axle.
std::string make_hub_of(const std::string& name, const std::string& drive, const std::string& axle);

/// Four levels: the support; an arm and a boom on the hub "main"; a twig on the hub "middle" of the
/// boom; a leaf on the hub "top" of the twig, which is fixed to it. `base`: "ground" or "fuselage".
std::string make_levels(const LevelsCase& of, const std::string& base, const std::string& weight);

/// The same machine as one tree, that of the support, whose rotor is a body of its own.
std::string make_one_level(const LevelsCase& of, const std::string& base,
                           const std::string& weight);

/// Adds a hub that adds nothing to speak of, as a model has one at least.
std::string with_dummy(const std::string& text);

/// Replaces a part of a text wherever it is.
std::string replace(std::string text, const std::string& old, const std::string& made);

}  // namespace spoke::test
