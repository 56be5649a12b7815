#pragma once

// The wind that a description makes: a mean wind by height and time, a gust, a box of turbulence.

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "models/air/wind_box.h"
#include "models/air/wind_table.h"
#include "models/wind.h"

namespace spoke::air {

/// What makes a wind besides the numbers of its description; those that are missing are not there.
struct WindData {
  std::optional<WindTable> table{};
  std::shared_ptr<const WindBox> box{};
};

/// The axes of a wind, unit vectors, and heights over the ground.
class WindAxes {
 public:
  explicit WindAxes(const Wind& wind);

  const Eigen::Vector3d& along() const { return along_; }
  const Eigen::Vector3d& across() const { return across_; }  ///< 0 if the wind is along up
  const Eigen::Vector3d& up() const { return up_; }          ///< away from the ground
  double height(const Eigen::Vector3d& place) const { return place.dot(up_) - ground_; }
  /// Returns the place across the origin's wind and at a height [m].
  Eigen::Vector3d place(double across, double height) const {
    return across * across_ + (height + ground_) * up_;
  }
  /// Returns the components of a velocity along the wind, across it, and across both.
  Eigen::Vector3d components(const Eigen::Vector3d& velocity) const {
    return {velocity.dot(along_), velocity.dot(across_), velocity.dot(upward_)};
  }
  /// Returns the velocity of such components.
  Eigen::Vector3d velocity(const Eigen::Vector3d& components) const {
    return components.x() * along_ + components.y() * across_ + components.z() * upward_;
  }

 private:
  Eigen::Vector3d along_, up_;
  Eigen::Vector3d across_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d upward_;
  double ground_;
};

/// Returns the factor of the power law, (height/reference_height)^exponent [m]; the air below the
/// ground is that on it.
double calc_shear(double height, double reference_height, double exponent) noexcept;

/// Returns what linear shear adds to that factor at a place so far over the reference height and
/// across from where nothing is added [m]. vertical, horizontal: shear [1/m]. The air below the
/// ground is that on it.
double calc_linear_shear(double upwards, double across, double reference_height, double vertical,
                         double horizontal) noexcept;

/// Returns the wind of a description without fault, and of what is in its file or was generated.
std::shared_ptr<const WindField> compose_wind(const Wind& wind, WindData data);

}  // namespace spoke::air
