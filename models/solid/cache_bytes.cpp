#include "models/solid/cache_bytes.h"

#include <cassert>
#include <limits>

namespace spoke::solid {

void ByteWriter::operator()(const Sparse& matrix) {
  assert(matrix.isCompressed());
  (*this)(std::int64_t{matrix.rows()});
  (*this)(std::int64_t{matrix.cols()});
  (*this)(std::int64_t{matrix.nonZeros()});
  const auto count = static_cast<std::size_t>(matrix.nonZeros());
  put(matrix.outerIndexPtr(), sizeof(int) * static_cast<std::size_t>(matrix.cols() + 1));
  put(matrix.innerIndexPtr(), sizeof(int) * count);
  put(matrix.valuePtr(), sizeof(double) * count);
}

void ByteWriter::operator()(const space::SolidPlace& place) {
  (*this)(place.name);
  (*this)(place.p);
  (*this)(place.area);
  (*this)(place.at);
  (*this)(place.columns);
}

void ByteReader::take(void* first, std::size_t size) {
  if (failed_ || size > rest_.size()) {
    failed_ = true;
    return;
  }
  if (size > 0) std::memcpy(first, rest_.data(), size);
  rest_.remove_prefix(size);
}

bool ByteReader::fits(std::int64_t rows, std::int64_t columns, std::size_t size) {
  const auto most = static_cast<std::int64_t>(rest_.size() / size);
  if (rows < 0 || columns < 0 || (rows > 0 && columns > most / rows)) failed_ = true;
  // A matrix without rows may have any number of columns: none that counts is greater.
  if (rows == 0 && columns > std::numeric_limits<int>::max()) failed_ = true;
  return !failed_;
}

std::size_t ByteReader::take_size(std::size_t size) {
  std::int64_t count = 0;
  (*this)(count);
  return fits(count, 1, size) ? static_cast<std::size_t>(count) : 0;
}

void ByteReader::operator()(Sparse& matrix) {
  std::int64_t rows = 0, columns = 0, entries = 0;
  (*this)(rows);
  (*this)(columns);
  (*this)(entries);
  if (rows < 0 || rows > std::numeric_limits<int>::max() || !fits(columns, 1, sizeof(int)) ||
      !fits(entries, 1, sizeof(int) + sizeof(double)))
    failed_ = true;
  if (failed_) return;
  std::vector<int> outer(static_cast<std::size_t>(columns) + 1),
      inner(static_cast<std::size_t>(entries));
  take(outer.data(), sizeof(int) * outer.size());
  take(inner.data(), sizeof(int) * inner.size());
  if (outer.front() != 0 || outer.back() != entries) failed_ = true;
  for (std::size_t j = 1; j < outer.size() && !failed_; ++j) {
    if (outer[j] < outer[j - 1]) failed_ = true;
    for (int k = outer[j - 1]; k < outer[j] && !failed_; ++k) {
      const int row = inner[static_cast<std::size_t>(k)];
      const int before = k > outer[j - 1] ? inner[static_cast<std::size_t>(k) - 1] : -1;
      if (row <= before || row >= rows) failed_ = true;
    }
  }
  if (failed_) return;
  matrix.resize(rows, columns);
  matrix.resizeNonZeros(entries);
  std::copy(outer.begin(), outer.end(), matrix.outerIndexPtr());
  std::copy(inner.begin(), inner.end(), matrix.innerIndexPtr());
  take(matrix.valuePtr(), sizeof(double) * static_cast<std::size_t>(entries));
}

void ByteReader::operator()(space::SolidPlace& place) {
  (*this)(place.name);
  (*this)(place.p);
  (*this)(place.area);
  (*this)(place.at);
  (*this)(place.columns);
}

}  // namespace spoke::solid
