#pragma once

// How many modes are wanted.

namespace spoke::vibration {

/// Number of modes that are wanted, of each subsystem where subsystems do not couple, in the frame
/// that turns; else of the whole model.
struct ModeCount {
  int asked = 0;  ///< a note says if there are fewer
  int most = 10;
};

}  // namespace spoke::vibration
