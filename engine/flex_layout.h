#pragma once

namespace spoke {

/// Where the axial and bending parts of a body's flex vector stand in its storage. Four zeros stand
/// before and behind each part, so that banded products need no special rows at the ends.
struct FlexLayout {
  int axial = 0;
  int bending = 0;

  static constexpr int kPad = 4;
  int u() const { return kPad; }
  int v() const { return 2 * kPad + rounded(axial); }
  int size() const { return 3 * kPad + rounded(axial) + rounded(bending); }
  /// Place of coordinate `index` of the order "axial, then bending"; of -1, a place that is zero.
  int place(int index) const {
    if (index < 0) return 0;
    return index < axial ? u() + index : v() + (index - axial);
  }

 private:
  static int rounded(int n) { return (n + kPad - 1) / kPad * kPad; }
};

}  // namespace spoke
