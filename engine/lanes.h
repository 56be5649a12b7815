#pragma once

// Loops over flex vectors in pairs of neighbouring values, which the compiler keeps in one register.

#include <Eigen/Core>

namespace spoke {

/// Two values side by side.
using Pair = Eigen::Array2d;

/// One value, or a pair of neighbours, from memory.
template <class Lane>
[[gnu::always_inline]] inline Lane load(const double* x) {
  if constexpr (std::is_same_v<Lane, double>)
    return *x;
  else
    return Eigen::Map<const Pair>(x);
}

inline void store(double value, double* x) { *x = value; }
inline void store(const Pair& value, double* x) { Eigen::Map<Pair>{x} = value; }

inline double total(const Pair& value) { return value[0] + value[1]; }

/// Calls body.operator()<Lane>(i) for i = 0, 2, 4, ... with Lane = Pair, and for a last odd i with
/// Lane = double.
template <class Body>
inline void for_each_lane(int n, Body&& body) {
  int i = 0;
  for (; i + 1 < n; i += 2) body.template operator()<Pair>(i);
  if (i < n) body.template operator()<double>(i);
}

/// A sum over all lanes; an odd last value goes to the first place.
class LaneSum {
 public:
  void operator+=(const Pair& value) { sum_ += value; }
  void operator+=(double value) { sum_[0] += value; }
  double total() const { return spoke::total(sum_); }

 private:
  Pair sum_ = Pair::Zero();
};

}  // namespace spoke
