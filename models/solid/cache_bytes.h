#pragma once

// Values as bytes of a cache file, and back. What is read is not trusted: sizes are those of what
// is left, or reading fails.

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "models/solid/assembly.h"
#include "models/space/solid.h"

namespace spoke::solid {

/// Appends values to bytes.
class ByteWriter {
 public:
  template <class Value>
  requires std::is_arithmetic_v<Value> || std::is_enum_v<Value>
  void operator()(const Value& value) { put(&value, sizeof value); }
  void operator()(const std::string& text) {
    (*this)(std::int64_t(text.size()));
    put(text.data(), text.size());
  }
  template <class Scalar, int rows, int columns, int options>
  void operator()(const Eigen::Matrix<Scalar, rows, columns, options>& matrix) {
    if (rows == Eigen::Dynamic) (*this)(std::int64_t{matrix.rows()});
    if (columns == Eigen::Dynamic) (*this)(std::int64_t{matrix.cols()});
    put(matrix.data(), sizeof(Scalar) * static_cast<std::size_t>(matrix.size()));
  }
  void operator()(const Sparse& matrix);
  template <class Value, std::size_t count>
  void operator()(const std::array<Value, count>& values) {
    for (const Value& value : values) (*this)(value);
  }
  template <class Value>
  void operator()(const std::vector<Value>& values) {
    (*this)(std::int64_t(values.size()));
    for (const Value& value : values) (*this)(value);
  }
  void operator()(const space::SolidPlace& place);

  const std::string& bytes() const { return bytes_; }

 private:
  void put(const void* first, std::size_t size) {
    bytes_.append(static_cast<const char*>(first), size);
  }
  std::string bytes_;
};

/// Takes values from bytes. After a failure it gives nothing more.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

  bool is_at_end() const { return !failed_ && rest_.empty(); }

  template <class Value>
  requires std::is_arithmetic_v<Value> || std::is_enum_v<Value>
  void operator()(Value& value) { take(&value, sizeof value); }
  void operator()(std::string& text) {
    text.resize(take_size(1));
    take(text.data(), text.size());
  }
  template <class Scalar, int rows, int columns, int options>
  void operator()(Eigen::Matrix<Scalar, rows, columns, options>& matrix) {
    std::int64_t height = rows, width = columns;
    if (rows == Eigen::Dynamic) (*this)(height);
    if (columns == Eigen::Dynamic) (*this)(width);
    if (!fits(height, width, sizeof(Scalar))) return;
    matrix.resize(height, width);
    take(matrix.data(), sizeof(Scalar) * static_cast<std::size_t>(matrix.size()));
  }
  void operator()(Sparse& matrix);
  template <class Value, std::size_t count>
  void operator()(std::array<Value, count>& values) {
    for (Value& value : values) (*this)(value);
  }
  template <class Value>
  void operator()(std::vector<Value>& values) {
    values.resize(take_size(sizeof(std::int32_t)));
    for (Value& value : values) (*this)(value);
  }
  void operator()(space::SolidPlace& place);

 private:
  /// Tells whether so many values can be left, else fails.
  bool fits(std::int64_t rows, std::int64_t columns, std::size_t size);
  /// Takes a number of values of at least `size` bytes each; 0 if there cannot be so many.
  std::size_t take_size(std::size_t size);
  void take(void* first, std::size_t size);

  std::string_view rest_;
  bool failed_ = false;
};

}  // namespace spoke::solid
