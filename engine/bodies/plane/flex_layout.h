#pragma once

// The layout of a body's deformation coordinates in memory.

#include <cassert>

namespace spoke::plane {

/// Places of the axial and bending parts of a body's flex vector in its storage. Four zeros stand
/// before and behind each part, so that banded products need no special rows at the ends.
struct FlexLayout {
  int axial = 0;
  int bending = 0;

  static constexpr int kPad = 4;
  int u() const { return kPad; }
  int v() const { return 2 * kPad + rounded(axial); }
  int size() const { return 3 * kPad + rounded(axial) + rounded(bending); }
  /// Returns the end of the axial part, with a zero more if it is odd: vectors are taken two values
  /// at a time.
  int u_end() const { return u() + axial + axial % 2; }
  /// Returns the distance from a vector to the next in storage: the zeros behind the one stand
  /// before the other, too, so that more bodies fit into the processor's cache.
  int stride() const { return size() - kPad; }
  /// Returns the place of coordinate `index`, in the order "axial, then bending"; for -1, that of a
  /// zero.
  int offset(int index) const {
    assert(index < axial + bending);
    if (index < 0) return 0;
    return index < axial ? u() + index : v() + (index - axial);
  }
  /// Returns the pairs that solving for two right-hand sides takes.
  int scratch_size() const { return axial + bending; }
  /// Calls `apply(first, n)` with the place of the first of n coordinates that stand side by side.
  template <class Apply>
  void for_parts(Apply&& apply) const {
    apply(u(), axial);
    apply(v(), bending);
  }

 private:
  static int rounded(int n) { return (n + kPad - 1) / kPad * kPad; }
};

}  // namespace spoke::plane
