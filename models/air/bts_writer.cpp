// Scales velocities to whole numbers of 16 bits.

#include "models/air/bts_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace spoke::air {
namespace {

constexpr int kLeast = -32768;
constexpr int kGreatest = 32767;

template <class Value>
void put(Value value, std::string& bytes) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// A velocity becomes slope * velocity + offset.
struct Scaling {
  float slope = 1.0f, offset = 0.0f;
};

/// Finds the scale that takes the velocities of a component to the whole range.
Scaling find_scaling(const WindBox& box, std::size_t component) {
  float least = box.values[component];
  float greatest = least;
  for (std::size_t i = component; i < box.values.size(); i += 3) {
    least = std::min(least, box.values[i]);
    greatest = std::max(greatest, box.values[i]);
  }
  const double range = std::max(static_cast<double>(greatest) - least, 1e-3);
  const auto slope = static_cast<float>((kGreatest - kLeast) / range);
  return {slope, static_cast<float>(kLeast - static_cast<double>(slope) * least)};
}

}  // namespace

std::string make_bts(const WindBox& box, double hub_height, const std::string& description) {
  std::string bytes;
  put(static_cast<std::int16_t>(box.is_periodic ? 8 : 7), bytes);
  for (const std::size_t count : {box.n_z, box.n_y, std::size_t{0}, box.n_t})
    put(static_cast<std::int32_t>(count), bytes);
  for (const double number : {box.dz, box.dy, box.dt, box.speed, hub_height, box.bottom})
    put(static_cast<float>(number), bytes);
  std::array<Scaling, 3> scales;
  for (std::size_t c = 0; c < 3; ++c) {
    scales[c] = find_scaling(box, c);
    put(scales[c].slope, bytes);
    put(scales[c].offset, bytes);
  }
  put(static_cast<std::int32_t>(description.size()), bytes);
  bytes += description;
  bytes.reserve(bytes.size() + 2 * box.values.size());
  for (std::size_t i = 0; i < box.values.size(); ++i) {
    const Scaling& scale = scales[i % 3];
    const double scaled =
        static_cast<double>(scale.slope) * box.values[i] + static_cast<double>(scale.offset);
    put(static_cast<std::int16_t>(std::clamp(std::lround(scaled), long{kLeast}, long{kGreatest})),
        bytes);
  }
  return bytes;
}

}  // namespace spoke::air
