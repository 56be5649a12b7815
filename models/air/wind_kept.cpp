// Reads files of wind, makes winds.

#include "models/air/wind_kept.h"

#include <cassert>
#include <utility>

#include "models/air/bts_reader.h"
#include "models/air/turbulence.h"
#include "models/air/wind_table.h"
#include "models/support/hash_bytes.h"
#include "models/text_file.h"

namespace spoke {
namespace air {
namespace {

void require(const WindFault& fault) {
  if (fault) throw InputError(fault.text, {.key = fault.key});
}

/// A wind of a function.
class FunctionWind final : public WindField {
 public:
  using Function = std::function<Eigen::Vector3d(const Eigen::Vector3d&, double)>;
  explicit FunctionWind(Function velocity) : velocity_(std::move(velocity)) {}

  Eigen::Vector3d velocity(const Eigen::Vector3d& place, double t) const override {
    return velocity_(place, t);
  }

 private:
  Function velocity_;
};

}  // namespace

KeptWind::KeptWind(const Wind& wind) : of_(wind), content_(hash_bytes(nullptr, 0)) {
  require(find_wind_fault(wind));
  of_.kept = nullptr;
  if (of_.file.empty()) return;
  const bool is_binary = is_bts(of_.file);
  const std::string bytes =
      is_binary ? read_text(of_.file, "a full-field file of TurbSim (.bts)", kLargestBts)
                : read_text(of_.file, "a table of wind as text, or a file of TurbSim (.bts)");
  content_ = hash_bytes(bytes.data(), bytes.size());
  if (is_binary) {
    data_.box = std::make_shared<WindBox>(parse_bts(bytes, of_.file));
    return;
  }
  data_.table = parse_wind_table(bytes, of_.file);
  if (data_.table->shear_exponent && of_.shear_exponent != 0.0)
    require({"shear_exponent", "given along with a table that has its own, expected one of them"});
  if (data_.table->shear_exponent && !of_.reference_height)
    require({"reference_height",
             "is missing, expected the height of the table's speed (m), for its shear_exponent"});
}

void KeptWind::make() const {
  std::call_once(is_made_, [this] {
    if (of_.turbulence)
      data_.box = std::make_shared<WindBox>(
          make_turbulence(*of_.turbulence, of_.velocity.norm(), *of_.reference_height));
    field_ = compose_wind(of_, data_);
  });
}

std::shared_ptr<const WindField> KeptWind::field() const {
  make();
  return field_;
}

std::shared_ptr<const WindBox> KeptWind::box() const {
  make();
  return data_.box;
}

bool is_of_wind_file(const InputError& error) { return !error.place().file.empty(); }

std::shared_ptr<const KeptWind> find_wind(const Wind& wind) {
  if (wind.kept && wind.kept->of() == wind) return wind.kept;
  return std::make_shared<KeptWind>(wind);
}

WindBox make_whole_box(const KeptWind& kept) {
  const Wind& wind = kept.of();
  assert(wind.turbulence);
  const WindAxes axes(wind);
  const std::shared_ptr<const WindField> field = kept.field();
  WindBox box = *kept.box();
  for (std::size_t z = 0; z < box.n_z; ++z)
    for (std::size_t y = 0; y < box.n_y; ++y) {
      const Eigen::Vector3d mean =
          field->mean(axes.place(static_cast<double>(y) * box.dy - box.half_width(),
                                 box.bottom + static_cast<double>(z) * box.dz));
      const Eigen::Vector3f added = axes.components(mean).cast<float>();
      for (std::size_t t = 0; t < box.n_t; ++t)
        Eigen::Map<Eigen::Vector3f>(&box.values[box.index(t, z, y)]) += added;
    }
  return box;
}

WindFault find_end_fault(const Wind& wind, double duration) {
  // Turbulence, which takes a while to make, repeats.
  const bool may_end = wind.field || !wind.file.empty();
  const double end = may_end ? make_wind(wind)->end() : duration;
  if (duration <= end) return {};
  return {wind.field ? "by" : "file", "gives wind up to " + describe(end) +
                                          " s, expected some up to " + describe(duration) +
                                          " s, the end of the run"};
}

void keep_wind(Wind& wind) {
  if (wind.by_program || wind.field)
    require(find_wind_fault(wind));
  else
    wind.kept = find_wind(wind);
}

}  // namespace air

std::shared_ptr<const WindField> make_wind(const Wind& wind) {
  try {
    air::require(air::find_wind_fault(wind));
    if (wind.field) return wind.field;
    if (wind.by_program)
      air::require({"by", "is \"program\", but the program gives no wind, expected Wind::field"});
    return air::find_wind(wind)->field();
  } catch (const InputError& error) {
    if (air::is_of_wind_file(error)) throw;
    const std::string key = "wind." + error.place().key;
    throw InputError(key + ": " + error.what(), {.key = key});
  }
}

std::shared_ptr<const WindField> make_wind_field(
    std::function<Eigen::Vector3d(const Eigen::Vector3d& place, double t)> velocity) {
  if (!velocity) throw InputError("there is no function of the wind, expected one");
  return std::make_shared<air::FunctionWind>(std::move(velocity));
}

}  // namespace spoke
