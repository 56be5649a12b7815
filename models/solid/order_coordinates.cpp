// Cuts the graph of the matrices across its longest course, and orders each slice by minimum
// degree.

#include "models/solid/order_coordinates.h"

#include <Eigen/OrderingMethods>
#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

namespace spoke::solid {
namespace {

/// Coordinates that a matrix couples, each with itself too, column by column.
struct CoordinateGraph {
  explicit CoordinateGraph(const space::NodalSolid& solid) {
    // Values are of one sign: none cancel.
    Eigen::SparseMatrix<double> m(solid.Xi.rows(), solid.Xi.rows());
    std::vector<Eigen::Triplet<double>> entries;
    for (int j = 0; j < solid.m.outerSize(); ++j)
      for (Eigen::SparseMatrix<double>::InnerIterator e(solid.m, j); e; ++e)
        for (int c = 0; c < 3; ++c)
          entries.emplace_back(3 * static_cast<int>(e.row()) + c, 3 * j + c, 1.0);
    m.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SparseMatrix<double> Xi = of_ones(solid.Xi);
    matrix = Eigen::SparseMatrix<double>(Xi.transpose()) * Eigen::SparseMatrix<double>(m * Xi) +
             of_ones(solid.K);
    matrix.makeCompressed();
  }
  static Eigen::SparseMatrix<double> of_ones(Eigen::SparseMatrix<double> other) {
    other.makeCompressed();
    std::fill_n(other.valuePtr(), other.nonZeros(), 1.0);
    return other;
  }
  int size() const { return static_cast<int>(matrix.cols()); }
  template <class Visit>
  void for_neighbours(int i, Visit&& visit) const {
    for (Eigen::SparseMatrix<double>::InnerIterator e(matrix, i); e; ++e)
      visit(static_cast<int>(e.row()));
  }

  Eigen::SparseMatrix<double> matrix;
};

/// A course through the coordinates: their ranks in it, and cuts across.
struct Course {
  std::vector<int> rank;  ///< by coordinate
  std::vector<int> last;  ///< by coordinate: the highest rank that it is coupled with
  std::vector<int> cuts;  ///< ascending: the first rank behind each
  int between = 0;        ///< coordinates that couple slices

  int slice(int of_rank) const {
    return static_cast<int>(std::upper_bound(cuts.begin(), cuts.end(), of_rank) - cuts.begin());
  }
  bool couples(int i) const {
    const auto at = static_cast<std::size_t>(i);
    return slice(rank[at]) < slice(last[at]);
  }
};

Course make_course(const CoordinateGraph& graph, const std::vector<double>& key) {
  const auto n = static_cast<std::size_t>(graph.size());
  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&key](int a, int b) {
    return key[static_cast<std::size_t>(a)] < key[static_cast<std::size_t>(b)];
  });
  Course course;
  course.rank.resize(n);
  course.last.resize(n);
  for (std::size_t k = 0; k < n; ++k)
    course.rank[static_cast<std::size_t>(order[k])] = static_cast<int>(k);
  for (std::size_t i = 0; i < n; ++i) {
    int last = course.rank[i];
    graph.for_neighbours(static_cast<int>(i), [&](int j) {
      last = std::max(last, course.rank[static_cast<std::size_t>(j)]);
    });
    course.last[i] = last;
  }
  return course;
}

/// Cuts a course into `slices`, each cut where the fewest coordinates reach across it, not far from
/// equal parts.
void cut(int slices, Course& course) {
  const int n = static_cast<int>(course.rank.size());
  std::vector<int> across(static_cast<std::size_t>(n) + 2, 0);
  for (std::size_t i = 0; i < course.rank.size(); ++i) {
    ++across[static_cast<std::size_t>(course.rank[i]) + 1];
    --across[static_cast<std::size_t>(course.last[i]) + 1];
  }
  std::partial_sum(across.begin(), across.end(), across.begin());
  course.cuts.clear();
  const int reach = n / (6 * slices);
  for (int k = 1; k < slices; ++k) {
    const int middle = static_cast<int>(static_cast<long long>(n) * k / slices);
    int best = middle;
    for (int d = 1; d <= reach; ++d)
      for (const int at : {middle - d, middle + d})
        if (across[static_cast<std::size_t>(at)] < across[static_cast<std::size_t>(best)])
          best = at;
    course.cuts.push_back(best);
  }
  course.between = 0;
  for (int i = 0; i < n; ++i) course.between += course.couples(i);
}

/// Returns the place of each coordinate: the mean of the nodes that it moves.
std::vector<space::Position> find_places(const space::SolidConstants& solid,
                                         const Eigen::SparseMatrix<double>& Xi) {
  std::vector<space::Position> places;
  for (int c = 0; c < Xi.outerSize(); ++c) {
    space::Position sum = space::Position::Zero();
    int count = 0;
    for (Eigen::SparseMatrix<double>::InnerIterator e(Xi, c); e; ++e, ++count)
      sum += solid.nodes[static_cast<std::size_t>(e.row() / 3)];
    places.push_back(sum / std::max(1, count));
  }
  return places;
}

/// Returns the number of steps to each coordinate from the one farthest from the first.
std::vector<double> find_distances(const CoordinateGraph& graph) {
  std::vector<double> distance;
  int start = 0;
  for (int pass = 0; pass < 2; ++pass) {
    distance.assign(static_cast<std::size_t>(graph.size()), -1.0);
    std::vector<int> queue{start};
    distance[static_cast<std::size_t>(start)] = 0.0;
    for (std::size_t k = 0; k < queue.size(); ++k)
      graph.for_neighbours(queue[k], [&](int j) {
        double& d = distance[static_cast<std::size_t>(j)];
        if (d >= 0.0) return;
        d = distance[static_cast<std::size_t>(queue[k])] + 1.0;
        queue.push_back(j);
      });
    start = queue.back();
  }
  return distance;
}

/// Returns the course that the fewest coordinates couple across its cuts: along an axis of the mesh
/// or from one end of the body to the other.
Course find_course(const space::SolidConstants& solid, const CoordinateGraph& graph, int most) {
  const int n = graph.size();
  std::vector<std::vector<double>> keys{find_distances(graph)};
  const std::vector<space::Position> places = find_places(solid, solid.nodal()->Xi);
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double>& key = keys.emplace_back();
    for (const space::Position& place : places) key.push_back(place[axis]);
  }
  std::vector<Course> courses;
  for (const std::vector<double>& key : keys) courses.push_back(make_course(graph, key));
  for (int slices = most; slices > 1; slices /= 2) {
    for (Course& course : courses) cut(slices, course);
    const auto best =
        std::min_element(courses.begin(), courses.end(),
                         [](const Course& a, const Course& b) { return a.between < b.between; });
    // What is between slices is solved by one node: it must stay the smaller part.
    if (4 * best->between <= n) return *best;
  }
  courses.front().cuts.clear();
  return courses.front();
}

using Order = std::vector<int>;

/// Orders coordinates by minimum degree of the graph among them.
void order_slice(const CoordinateGraph& graph, Order& slice) {
  std::vector<int> place(static_cast<std::size_t>(graph.size()), -1);
  for (std::size_t k = 0; k < slice.size(); ++k)
    place[static_cast<std::size_t>(slice[k])] = static_cast<int>(k);
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t k = 0; k < slice.size(); ++k)
    graph.for_neighbours(slice[k], [&](int j) {
      const int to = place[static_cast<std::size_t>(j)];
      if (to >= 0) entries.emplace_back(to, static_cast<int>(k), 1.0);
    });
  const auto n = static_cast<Eigen::Index>(slice.size());
  Eigen::SparseMatrix<double> own(n, n);
  own.setFromTriplets(entries.begin(), entries.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation;
  Eigen::AMDOrdering<int>()(own, permutation);
  Order ordered;
  for (Eigen::Index k = 0; k < n; ++k)
    ordered.push_back(slice[static_cast<std::size_t>(permutation.indices()[k])]);
  slice = std::move(ordered);
}

/// Returns the coordinates in their order; `slices`: see NodalSolid.
Order find_order(const CoordinateGraph& graph, const Course& course, std::vector<int>& slices) {
  std::vector<Order> parts(course.cuts.size() + 1);
  Order between;
  Order by_rank(course.rank.size());
  for (std::size_t i = 0; i < course.rank.size(); ++i)
    by_rank[static_cast<std::size_t>(course.rank[i])] = static_cast<int>(i);
  const auto slice_of = [&course](int rank) {
    return static_cast<std::size_t>(course.slice(rank));
  };
  for (const int i : by_rank) {
    const std::size_t slice = slice_of(course.rank[static_cast<std::size_t>(i)]);
    (course.couples(i) ? between : parts[slice]).push_back(i);
  }
  // These are a chain from cut to cut; those that reach across several come last.
  std::stable_partition(between.begin(), between.end(), [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    return slice_of(course.last[at]) == slice_of(course.rank[at]) + 1;
  });
  Order order;
  slices.clear();
  for (Order& part : parts) {
    slices.push_back(static_cast<int>(order.size()));
    order_slice(graph, part);
    order.insert(order.end(), part.begin(), part.end());
  }
  slices.push_back(static_cast<int>(order.size()));
  order.insert(order.end(), between.begin(), between.end());
  return order;
}

void permute(const Order& order, space::SolidConstants& solid) {
  auto& nodal = std::get<space::NodalSolid>(solid.matrices);
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> place(
      static_cast<Eigen::Index>(order.size()));  // by old coordinate
  for (std::size_t k = 0; k < order.size(); ++k) place.indices()[order[k]] = static_cast<int>(k);
  Eigen::SparseMatrix<double> K;
  K = nodal.K.twistedBy(place);
  nodal.K = K.transpose();  // its rows are in order
  nodal.Xi = Eigen::SparseMatrix<double>(nodal.Xi * place.transpose());
  for (space::SolidPlace& of : solid.places) {
    std::vector<std::pair<int, space::Twist>> columns;
    for (std::size_t k = 0; k < of.at.size(); ++k)
      columns.emplace_back(place.indices()[of.at[k]], of.columns[k]);
    std::sort(columns.begin(), columns.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t k = 0; k < columns.size(); ++k) std::tie(of.at[k], of.columns[k]) = columns[k];
  }
}

}  // namespace

void order_coordinates(space::SolidConstants& solid, int most) {
  assert(solid.nodal() && most >= 1);
  const CoordinateGraph graph(*solid.nodal());
  const Course course = find_course(solid, graph, most);
  auto& nodal = std::get<space::NodalSolid>(solid.matrices);
  permute(find_order(graph, course, nodal.slices), solid);
}

void order_coordinates(space::SolidConstants& solid) {
  // Slices of so many coordinates take some tenths of a millisecond: much more than a node's start.
  constexpr int kLeast = 2500, kMost = 16;
  int slices = 1;
  while (slices < kMost && solid.coordinates > kLeast * slices) slices *= 2;
  order_coordinates(solid, slices);
}

}  // namespace spoke::solid
