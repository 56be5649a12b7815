#pragma once

// The choice of the blades that a load or sensor is on.

#include <cstddef>

namespace spoke {

/// The blades that a load or a sensor is on: all, or one by its number. Numbers count from 1, as in
/// files and in the names of sensors. Whole numbers do not convert: an index, from 0, is no number.
class BladeChoice {
 public:
  /// Returns the choice of every blade of the rotor.
  static constexpr BladeChoice all() { return BladeChoice(true, 0); }
  /// Returns the choice of blade `number`, from 1: rotor.blades[number - 1].
  static constexpr BladeChoice number(int number) { return BladeChoice(false, number); }

  constexpr bool is_all() const { return is_all_; }  ///< whether it is every blade
  /// Returns the number from 1; 0 if it is every blade.
  constexpr int number() const { return number_; }
  /// Returns whether rotor.blades[index] is one of them.
  constexpr bool holds(std::size_t index) const {
    return is_all_ || static_cast<std::size_t>(number_) == index + 1;
  }

 private:
  constexpr BladeChoice(bool is_all, int number) : is_all_(is_all), number_(number) {}

  bool is_all_;
  int number_;
};

}  // namespace spoke
