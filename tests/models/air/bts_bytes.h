#pragma once

// Files of TurbSim, made byte by byte as its manual describes them.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <functional>
#include <string>

namespace spoke::test {

/// A file to be.
struct BtsBytes {
  std::int16_t identifier = 8;
  std::size_t n_z = 4, n_y = 3, tower = 0, n_t = 40;
  float dz = 5.0f, dy = 8.0f, dt = 0.5f;
  float slope = 500.0f, offset = -1000.0f;
  std::function<double(std::size_t t, std::size_t z, std::size_t y, std::size_t component)>
      speed_of = [](std::size_t t, std::size_t z, std::size_t y, std::size_t c) {
        return 10.0 + std::cos(static_cast<double>(t + 2 * z + 3 * y + 5 * c));
      };

  template <class Value>
  static void put(Value value, std::string& bytes) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }

  std::string make() const {
    std::string bytes;
    put(identifier, bytes);
    for (const std::size_t count : {n_z, n_y, tower, n_t})
      put(static_cast<std::int32_t>(count), bytes);
    for (const float number : {dz, dy, dt, 11.0f, 90.0f, 10.0f}) put(number, bytes);
    for (int c = 0; c < 3; ++c) {
      put(slope, bytes);
      put(offset, bytes);
    }
    const std::string description = "made by a test";
    put(static_cast<std::int32_t>(description.size()), bytes);
    bytes += description;
    const auto put_speed = [&](double speed) {
      put(static_cast<std::int16_t>(std::lround(speed * slope + offset)), bytes);
    };
    for (std::size_t t = 0; t < n_t; ++t) {
      for (std::size_t z = 0; z < n_z; ++z)
        for (std::size_t y = 0; y < n_y; ++y)
          for (std::size_t c = 0; c < 3; ++c) put_speed(speed_of(t, z, y, c));
      for (std::size_t i = 0; i < 3 * tower; ++i) put_speed(1.0);
    }
    return bytes;
  }

  void write(const std::string& file) const { std::ofstream(file, std::ios::binary) << make(); }
};

}  // namespace spoke::test
