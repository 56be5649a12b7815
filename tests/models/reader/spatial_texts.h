#pragma once

// Scenarios in space that tests of the reader change line by line.

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "models/scenario.h"
#include "tests/message_of.h"

namespace spoke::test {

// Line numbers of messages refer to these texts.
inline const std::string kBladeText = R"(title = "test"
world = "space"
[hub]
radius = 0.1
[hub.drive]
kind = "constant"
speed = 4.0
[gravity]
acceleration = [0, 0, -9.81]
[blade]
count = 3
length = 8.0
[blade.sections]
station = [0.0, 3.0, 8.0]
mass_per_length = [3.0, 2.0, 1.0]
axial_stiffness = [3e7, 2e7, 1e7]
flap_stiffness = [3e3, 2e3, 1e3]
lag_stiffness = [3e4, 2e4, 1e4]
torsion_stiffness = [3e3, 2e3, 1e3]
twist = [0.2, 0.1, 0.0]
[[blade.joint]]
name = "flap"
station = 0.3
kind = "revolute"
axis = [0, -1, 0]
damping = 10.0
[[blade.joint]]
name = "pitch"
station = 0.5
kind = "revolute"
axis = [1, 0, 0]
motion = { mean = 0.1 }
[integration]
duration = 20.0
)";

inline const std::string kTreeText = R"(world = "space"
[hub]
support = "free"
mass = 100.0
inertia = [20.0, 20.0, 30.0]
[[subsystem]]
name = "arm"
[[subsystem.body]]
name = "boom"
kind = "beam"
length = 4.0
[subsystem.body.sections]
mass_per_length = 1.0
axial_stiffness = 1e7
flap_stiffness = 1e3
lag_stiffness = 1e3
torsion_stiffness = 1e3
[[subsystem.body]]
name = "mirror"
kind = "rigid"
mass = 5.0
inertia = [1.0, 2.0, 3.0]
[[subsystem.joint]]
parent = "hub"
child = "boom"
kind = "fixed"
[[subsystem.joint]]
parent = "boom"
child = "mirror"
kind = "spherical"
stiffness = 4.0
[integration]
duration = 20.0
)";

struct SpatialEdit {
  std::string part;         ///< part of the text
  std::string replacement;  ///< text in its place
  std::string message;      ///< expected
};

/// Returns the text with its first `part` replaced.
inline std::string edited(std::string text, const std::string& part,
                          const std::string& replacement) {
  const auto at = text.find(part);
  REQUIRE(at != std::string::npos);
  return text.replace(at, part.size(), replacement);
}

inline void check_edits(const std::string& text, const std::vector<SpatialEdit>& edits) {
  for (const SpatialEdit& edit : edits) {
    CAPTURE(edit.replacement);
    const std::string changed = edited(text, edit.part, edit.replacement);
    const std::string message = message_of([&] { parse_scenario(changed, "f.toml"); });
    CHECK(message == edit.message);
    CHECK(message.find('\n') == std::string::npos);
  }
}

}  // namespace spoke::test
