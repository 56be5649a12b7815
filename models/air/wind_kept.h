#pragma once

// What is made of a description of wind, once for it and its copies.

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>

#include "models/air/wind_field.h"
#include "models/air/wind_rules.h"
#include "models/wind.h"
#include "spoke/error.h"

namespace spoke::air {

/// A description, what stands in its file, and the wind, which is made when first asked for: that
/// of turbulence takes a second.
class KeptWind {
 public:
  /// Reads the file of a description, if it has one. Throws InputError, see is_of_wind_file().
  explicit KeptWind(const Wind& wind);

  const Wind& of() const { return of_; }
  /// Returns the hash of the bytes of the file; that of none if there is no file.
  std::uint64_t content() const { return content_; }
  /// Returns the wind. May be called by several threads.
  std::shared_ptr<const WindField> field() const;
  /// Returns the box of a file or of turbulence; null if there is none. May be called by several
  /// threads.
  std::shared_ptr<const WindBox> box() const;
  /// Returns the exponent of the power law over time that the file gives; none if it gives none.
  std::optional<Curve> shear_course() const {
    return data_.table ? data_.table->shear_exponent : std::nullopt;
  }

 private:
  void make() const;

  Wind of_;
  std::uint64_t content_;
  mutable std::once_flag is_made_;
  mutable WindData data_;
  mutable std::shared_ptr<const WindField> field_;
};

/// Whether an error of find_wind() or keep_wind() is one of a file. Its text begins with that
/// place, and wants no key of the scenario in front. Else its place().key is within the wind, and
/// its text only says what is wrong with that.
bool is_of_wind_file(const InputError& error);

/// Returns what the description keeps, if it still belongs to it; else reads its file. Throws
/// InputError, see is_of_wind_file().
std::shared_ptr<const KeptWind> find_wind(const Wind& wind);

/// Gives a description what is made of it, unless the program gives the wind. Throws InputError,
/// see is_of_wind_file().
void keep_wind(Wind& wind);

/// Returns the box of turbulence with the mean wind in it, without a gust. Precondition: the wind
/// has turbulence.
WindBox make_whole_box(const KeptWind& kept);

/// Finds a wind without other fault that ends before a run of this duration [s].
WindFault find_end_fault(const Wind& wind, double duration);

}  // namespace spoke::air
