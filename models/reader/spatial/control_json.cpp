// Writes the keys that control_reader.cpp reads.

#include "models/reader/spatial/control_json.h"

#include "models/reader/keys/control_keys.h"
#include "models/reader/row_reader.h"
#include "models/reader/spatial/spatial_fields.h"

namespace spoke::spatial {

Json control_to_json(const PitchControl& control) {
  Json json;
  for (const std::string& name : control.joints) json.append("joints", name);
  keys::write_numbers(keys::kPitchControlRows, &control, json);
  keys::visit_options(
      keys::kPitchControlRows, control,
      [&](std::string_view key, const std::optional<double>& value, const Quantity&) {
        if (value) json.set(key, *value);
      });
  if (control.schedule)
    json.set("schedule",
             {{"angle", control.schedule->times()}, {"factor", control.schedule->values()}});
  json.set("initial", control.initial);
  json.set("sign", static_cast<int>(control.sign));
  return json;
}

}  // namespace spoke::spatial
