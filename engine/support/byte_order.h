#pragma once

// Numbers as bytes, the same on every machine.

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace spoke {

/// Appends numbers to a string of bytes, least significant byte first on every machine.
class ByteWriter {
 public:
  template <class Unsigned>
  void add(Unsigned number) {
    for (std::size_t k = 0; k < sizeof number; ++k)
      bytes_ += static_cast<char>(static_cast<std::uint64_t>(number) >> (8 * k) & 0xFF);
  }
  void add_number(double number) { add(std::bit_cast<std::uint64_t>(number)); }
  void add_count(std::size_t count) { add(static_cast<std::uint64_t>(count)); }
  void add_text(std::string_view text) {
    add_count(text.size());
    bytes_ += text;
  }

  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Takes numbers from bytes that may be anything. Once they do not suffice, it has failed and gives
/// zeros.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  template <class Unsigned>
  Unsigned take() {
    std::uint64_t number = 0;
    const std::string_view part = take_bytes(sizeof(Unsigned));
    for (std::size_t k = 0; k < part.size(); ++k)
      number |= static_cast<std::uint64_t>(static_cast<unsigned char>(part[k])) << (8 * k);
    return static_cast<Unsigned>(number);
  }
  double take_number() { return std::bit_cast<double>(take<std::uint64_t>()); }
  /// Takes a number of items of at least `size` bytes each; a number larger than the bytes can hold
  /// is a failure.
  std::size_t take_count(std::size_t size) {
    const auto count = take<std::uint64_t>();
    if (count <= bytes_.size() / size) return static_cast<std::size_t>(count);
    has_failed_ = true;
    return 0;
  }
  std::string take_text() { return std::string(take_bytes(take_count(1))); }

  /// Whether all bytes were taken, and none beyond.
  bool is_done() const { return !has_failed_ && bytes_.empty(); }

 private:
  /// Returns nothing if there are not as many.
  std::string_view take_bytes(std::size_t count) {
    if (has_failed_ || count > bytes_.size()) {
      has_failed_ = true;
      return {};
    }
    const std::string_view part = bytes_.substr(0, count);
    bytes_.remove_prefix(count);
    return part;
  }

  std::string_view bytes_;
  bool has_failed_ = false;
};

}  // namespace spoke
