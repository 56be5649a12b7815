// The header, then by time the velocities as whole numbers of 16 bits, in the order of bytes of all
// processors that Spoke runs on (little-endian).

#include "models/air/bts_reader.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "models/support/quantity.h"
#include "spoke/error.h"

namespace spoke::air {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr int kMostPoints = 10'000;  ///< along a side of the grid, or of the tower
constexpr int kMostSteps = 100'000'000;
constexpr int kMostText = 100'000;   ///< bytes of the description
constexpr double kFastest = 1000.0;  ///< [m/s]

/// Walks through the bytes of a file.
class BtsBytes {
 public:
  BtsBytes(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  [[noreturn]] void refuse(std::size_t place, const std::string& what) const {
    throw InputError(file_ + ": byte " + std::to_string(place) + ": " + what, {.file = file_});
  }
  template <class Value>
  Value take(const char* what) {
    if (bytes_.size() - at_ < sizeof(Value))
      refuse(bytes_.size(), std::string("the file ends here, expected ") + what);
    Value value;
    std::memcpy(&value, bytes_.data() + at_, sizeof(Value));
    at_ += sizeof(Value);
    return value;
  }
  std::size_t count(int least, int most, const char* what) {
    const std::size_t place = at_;
    const auto value = take<std::int32_t>(what);
    const Count range{least, most};
    if (!range.holds(value))
      refuse(place,
             "is " + std::to_string(value) + ", expected " + what + ", " + range.expectation());
    return static_cast<std::size_t>(value);
  }
  double number(const Quantity& range, const char* what) {
    const std::size_t place = at_;
    const double value = take<float>(what);
    const std::string expected = range.expectation_instead_of(value);
    if (!expected.empty())
      refuse(place, "is " + describe(value) + ", expected " + what + ", " + expected);
    return value;
  }
  void skip(std::size_t count) { at_ += count; }
  std::size_t at() const { return at_; }
  std::size_t size() const { return bytes_.size(); }

 private:
  std::string_view bytes_;
  const std::string& file_;
  std::size_t at_ = 0;
};

/// How numbers are velocities: (number - offset) / slope.
struct BtsScale {
  double slope, offset;
};

/// What stands in front of the velocities.
struct BtsHeader {
  WindBox box{};
  std::size_t tower = 0;  ///< points of the tower
  std::array<BtsScale, 3> scales{};
};

BtsHeader read_header(BtsBytes& bytes) {
  BtsHeader header;
  WindBox& box = header.box;
  const auto identifier = bytes.take<std::int16_t>("the identifier of TurbSim's files, 7 or 8");
  if (identifier != 7 && identifier != 8)
    bytes.refuse(0, "is " + std::to_string(identifier) +
                        ", expected the identifier of TurbSim's full-field files, 7 or 8");
  box.is_periodic = identifier == 8;
  box.n_z = bytes.count(2, kMostPoints, "the number of points upwards");
  box.n_y = bytes.count(2, kMostPoints, "the number of points across");
  header.tower = bytes.count(0, kMostPoints, "the number of points of the tower");
  box.n_t = bytes.count(2, kMostSteps, "the number of times");
  box.dz = bytes.number(Quantity::positive("m"), "the spacing of points upwards");
  box.dy = bytes.number(Quantity::positive("m"), "the spacing of points across");
  box.dt = bytes.number(Quantity::positive("s"), "the time step");
  box.speed = bytes.number(Quantity::positive("m/s"), "the mean speed at the hub");
  bytes.number(Quantity::any("m"), "the height of the hub");
  box.bottom = bytes.number(Quantity::any("m"), "the height of the lowest points");
  for (BtsScale& scale : header.scales) {
    const std::size_t place = bytes.at();
    scale.slope = bytes.number(Quantity::any("s/m"), "the slope of a scale");
    if (scale.slope == 0.0) bytes.refuse(place, "is 0, expected the slope of a scale");
    scale.offset = bytes.number(Quantity::any(""), "the offset of a scale");
  }
  const std::size_t length = bytes.count(0, kMostText, "the length of the description in bytes");
  if (bytes.size() - bytes.at() < length)
    bytes.refuse(bytes.size(), "the file ends here, expected a description of " +
                                   std::to_string(length) + " bytes from byte " +
                                   std::to_string(bytes.at()));
  bytes.skip(length);
  return header;
}

/// Refuses a file that has not as many velocities as its header says.
void check_size(const BtsHeader& header, const BtsBytes& bytes) {
  const WindBox& box = header.box;
  const std::uint64_t by_time = 6 * (std::uint64_t{box.n_y} * box.n_z + header.tower);
  const std::uint64_t expected = bytes.at() + box.n_t * by_time;
  if (bytes.size() == expected) return;
  const std::string velocities =
      std::to_string(box.n_t) + " times of " + std::to_string(box.n_y) + " x " +
      std::to_string(box.n_z) + " points" +
      (header.tower == 0 ? std::string()
                         : " and " + std::to_string(header.tower) + " of the tower");
  if (bytes.size() < expected)
    bytes.refuse(bytes.size(), "the file ends here, expected " + std::to_string(expected) +
                                   " bytes, for " + velocities);
  bytes.refuse(expected, "the file goes on, expected its end: it has " + velocities);
}

void read_velocities(const BtsHeader& header, BtsBytes& bytes, WindBox& box) {
  const std::size_t by_time = 3 * box.n_y * box.n_z;
  box.values.reserve(box.n_t * by_time);
  for (std::size_t t = 0; t < box.n_t; ++t) {
    for (std::size_t i = 0; i < by_time; ++i) {
      const BtsScale& scale = header.scales[i % 3];
      const double value = (bytes.take<std::int16_t>("a velocity") - scale.offset) / scale.slope;
      if (!(std::abs(value) <= kFastest))
        bytes.refuse(bytes.at() - 2, "is a velocity of " + describe(value) +
                                         " m/s, expected one of at most " + describe(kFastest));
      box.values.push_back(static_cast<float>(value));
    }
    bytes.skip(6 * header.tower);
  }
}

}  // namespace

WindBox parse_bts(std::string_view text, const std::string& file) {
  BtsBytes bytes(text, file);
  BtsHeader header = read_header(bytes);
  check_size(header, bytes);
  WindBox& box = header.box;
  read_velocities(header, bytes, box);
  if (!box.is_periodic) {
    box.start = box.half_width() / box.speed;
    if (box.end() <= 0.0)
      bytes.refuse(bytes.size(), "has wind of " +
                                     describe(static_cast<double>(box.n_t - 1) * box.dt) +
                                     " s, expected more than the box takes to pass its width, " +
                                     describe(2.0 * box.start) + " s");
  }
  return std::move(box);
}

}  // namespace spoke::air
