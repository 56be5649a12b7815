#pragma once

// Lists of lists in one array.

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace spoke::graph {

/// A list of lists in one array (compressed rows): per node of a graph its neighbours, per cluster
/// its nodes. Rows are appended at the end.
template <class T>
class CompressedRows {
 public:
  /// Makes a list of no rows.
  CompressedRows() = default;
  /// Takes arrays in which row i is values[begins[i]] up to, without, values[begins[i + 1]].
  CompressedRows(std::vector<std::size_t> begins, std::vector<T> values)
      : begins_(std::move(begins)), values_(std::move(values)) {}

  std::size_t row_count() const { return begins_.size() - 1; }
  std::size_t size() const { return values_.size(); }
  std::span<const T> row(std::size_t index) const {
    assert(index < row_count());
    return {values_.data() + begins_[index], values_.data() + begins_[index + 1]};
  }

  void reserve(std::size_t rows, std::size_t values) {
    begins_.reserve(rows + 1);
    values_.reserve(values);
  }
  /// Appends to the row that is being written; end_row() completes it.
  void push_back(const T& value) { values_.push_back(value); }
  template <class Range>
  void append(const Range& values) {
    values_.insert(values_.end(), values.begin(), values.end());
  }
  void end_row() { begins_.push_back(values_.size()); }
  /// Completes the row ascending and without repetitions.
  void end_row_sorted() {
    const auto begin = values_.begin() + static_cast<std::ptrdiff_t>(begins_.back());
    std::sort(begin, values_.end());
    values_.erase(std::unique(begin, values_.end()), values_.end());
    end_row();
  }

 private:
  std::vector<std::size_t> begins_{0};
  std::vector<T> values_;
};

/// Returns the transpose: row j lists, ascending, the rows of `rows` that contain j, each as often
/// as it does.
CompressedRows<int> transpose(const CompressedRows<int>& rows);

}  // namespace spoke::graph
