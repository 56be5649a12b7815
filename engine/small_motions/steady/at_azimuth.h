#pragma once

// A model whose hub has turned to another azimuth than zero.

#include "engine/small_motions/steady/steady_model.h"

namespace spoke::steady {

/// An azimuth at which all that depends on it differs from that at zero [rad].
inline constexpr double kElsewhere = 1.0;

/// Puts the hub at an azimuth [rad] while it lives.
class AtAzimuth {
 public:
  AtAzimuth(double azimuth, SteadyModel& model) : model_(model) {
    model_.move_hub(azimuth, 0.0, 0.0);
  }
  ~AtAzimuth() { model_.move_hub(0.0, 0.0, 0.0); }
  AtAzimuth(const AtAzimuth&) = delete;
  AtAzimuth& operator=(const AtAzimuth&) = delete;

 private:
  SteadyModel& model_;
};

}  // namespace spoke::steady
