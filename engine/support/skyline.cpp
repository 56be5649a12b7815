// Cholesky's method within a skyline, and orders of rows.

#include "engine/support/skyline.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace spoke {
namespace {

using Neighbours = std::vector<std::vector<int>>;

std::size_t degree(const Neighbours& neighbours, int node) {
  return neighbours[static_cast<std::size_t>(node)].size();
}

/// Appends the part of a graph that hangs together with `root`, by distance from it, at equal
/// distance in the order of those before; neighbours of few neighbours first.
void append_by_distance(const Neighbours& neighbours, int root, std::vector<bool>& is_taken,
                        std::vector<int>& order) {
  std::size_t next = order.size();
  const auto take = [&](int node) {
    is_taken[static_cast<std::size_t>(node)] = true;
    order.push_back(node);
  };
  take(root);
  for (; next < order.size(); ++next) {
    const auto begin = static_cast<std::ptrdiff_t>(order.size());
    for (const int node : neighbours[static_cast<std::size_t>(order[next])])
      if (!is_taken[static_cast<std::size_t>(node)]) take(node);
    std::sort(order.begin() + begin, order.end(), [&](int a, int b) {
      return std::pair(degree(neighbours, a), a) < std::pair(degree(neighbours, b), b);
    });
  }
}

/// Returns a node at an end of the part of the graph that hangs together with `node`.
int find_end(const Neighbours& neighbours, int node, std::vector<bool>& is_taken) {
  constexpr int kWalks = 3;
  for (int k = 0; k < kWalks; ++k) {
    std::vector<int> order;
    append_by_distance(neighbours, node, is_taken, order);
    for (const int other : order) is_taken[static_cast<std::size_t>(other)] = false;
    node = order.back();
  }
  return node;
}

std::vector<int> order_by_distance(const Neighbours& neighbours) {
  std::vector<bool> is_taken(neighbours.size(), false);
  std::vector<int> order;
  for (std::size_t node = 0; node < neighbours.size(); ++node)
    if (!is_taken[node])
      append_by_distance(neighbours, find_end(neighbours, static_cast<int>(node), is_taken),
                         is_taken, order);
  std::reverse(order.begin(), order.end());
  return order;
}

/// Sums the squares of the lengths of all rows, which the products of a factorisation go with.
double count_products(const Neighbours& neighbours, const std::vector<int>& sizes,
                      const std::vector<int>& order) {
  std::vector<double> begin(order.size());  // row of the first of each node
  double rows = 0.0, products = 0.0;
  for (const int node : order) {
    begin[static_cast<std::size_t>(node)] = rows;
    rows += sizes[static_cast<std::size_t>(node)];
  }
  for (const int node : order) {
    const auto k = static_cast<std::size_t>(node);
    double first = begin[k];
    for (const int other : neighbours[k])
      first = std::min(first, begin[static_cast<std::size_t>(other)]);
    const double length = begin[k] + sizes[k] - first;
    products += sizes[k] * length * length;
  }
  return products;
}

}  // namespace

Skyline::Skyline(std::vector<int> first, Arena& arena) : first_(std::move(first)) {
  std::size_t size = 0;
  for (int r = 0; r < rows(); ++r) {
    assert(0 <= this->first(r) && this->first(r) <= r);
    const auto before = static_cast<std::size_t>(this->first(r));
    begin_.push_back(size - before);  // rows before, each of its diagonal at least, are as many
    size += static_cast<std::size_t>(r) + 1 - before;
  }
  values_ = ArenaVector<double>(size, 0.0, arena);
}

void Skyline::set_zero() noexcept { std::fill(values_.begin(), values_.end(), 0.0); }

void Skyline::factorise(std::span<double> pivots, int count) noexcept {
  assert(std::cmp_equal(pivots.size(), rows()) && 0 <= count && count <= rows());
  for (int r = 0; r < rows(); ++r) {
    double* const own = values_.data() + begin_[static_cast<std::size_t>(r)];
    const double diagonal = own[r];
    for (int c = first(r); c <= r; ++c) {
      const double* const other = values_.data() + begin_[static_cast<std::size_t>(c)];
      double sum = own[c];
      const int end = std::min(c, count);
      for (int k = std::max(first(r), first(c)); k < end; ++k) sum -= own[k] * other[k];
      if (c >= count) {
        own[c] = sum;
        continue;
      }
      if (c < r) {
        own[c] = sum / other[c];
        continue;
      }
      pivots[static_cast<std::size_t>(r)] = sum;
      own[r] = std::sqrt(sum > 0.0 ? sum : std::abs(diagonal) + 1e-300);
    }
  }
}

void Skyline::solve_upper(std::span<double> x, int count) noexcept {
  assert(std::cmp_equal(x.size(), rows()) && 0 <= count && count <= rows());
  for (int r = rows(); r-- > 0;) {
    if (r < count) x[static_cast<std::size_t>(r)] /= entry(r, r);
    const double own = x[static_cast<std::size_t>(r)];
    for (int c = first(r); c < r && c < count; ++c)
      x[static_cast<std::size_t>(c)] -= entry(r, c) * own;
  }
}

std::vector<int> find_low_order(const std::vector<std::vector<int>>& neighbours,
                                const std::vector<int>& sizes) {
  assert(neighbours.size() == sizes.size());
  std::vector<int> as_numbered(neighbours.size());
  for (std::size_t k = 0; k < as_numbered.size(); ++k) as_numbered[k] = static_cast<int>(k);
  std::vector<int> by_distance = order_by_distance(neighbours);
  return count_products(neighbours, sizes, by_distance) <
                 count_products(neighbours, sizes, as_numbered)
             ? by_distance
             : as_numbered;
}

}  // namespace spoke
