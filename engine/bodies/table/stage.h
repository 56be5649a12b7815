#pragma once

// A stage of a step: what nodes of one name do. Those of every pass are listed in
// engine/step/stages.h; those of actors stand with the actors.

namespace spoke {

/// What nodes of a stage do in a pass. Evaluations of subsystems alone
/// (engine/small_motions/steady) choose nodes by it.
enum class StageRole {
  given,     ///< set what a state is evaluated at: controls, motion of the hub, coordinates
  terms,     ///< lead to the terms of bodies: their motion, and what acts on them
  solution,  ///< lead from the terms to the accelerations
  system     ///< are of the hub and all subsystems, or end the pass
};

struct Stage {
  const char* name;
  StageRole role;

  constexpr operator const char*() const { return name; }
};

}  // namespace spoke
