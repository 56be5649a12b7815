#pragma once

// Modes as values of Python, which diagrams and searches have, too.

#include <pybind11/pybind11.h>

#include <cstddef>
#include <memory>
#include <string>
#include <utility>

#include "engine/modes.h"
#include "models/scenario.h"

namespace spoke::python {

/// Modes, and further data of their page.
struct Modes {
  Modes(ModesResult found, const Scenario& of) : result(std::move(found)), scenario(of) {}

  ModesResult result;
  Scenario scenario;
};

/// One of the modes; the common equilibrium is part of its picture.
struct OneMode {
  std::shared_ptr<const Modes> modes;
  std::size_t index = 0;

  const Mode& mode() const { return modes->result.modes[index]; }
};

/// Returns the frame of this name: "turning", "fixed" or "floquet". Throws ValueError.
std::optional<ModeFrame> frame_of(const std::optional<std::string>& name);

}  // namespace spoke::python
