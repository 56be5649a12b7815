// libFuzzer: any bytes are a file of TurbSim, or a table of wind, or refused by InputError with one
// line. What is read blows everywhere and always, and is read again as it is written.

#include <cmath>
#include <memory>
#include <string>
#include <string_view>

#include "models/air/bts_reader.h"
#include "models/air/bts_writer.h"
#include "models/air/wind_field.h"
#include "models/air/wind_table.h"
#include "models/error.h"
#include "tests/fuzz/require.h"

using namespace spoke;
using test::require;

namespace {

template <class Function>
void try_reading(const Function& read) {
  try {
    read();
  } catch (const InputError& error) {
    const std::string message = error.what();
    require(!message.empty() && message.find('\n') == std::string::npos, "a message is one line");
  }
}

void blow(const WindField& field) {
  const double end = std::isfinite(field.end()) ? field.end() : 1e9;
  for (const double t : {-1.0, 0.0, 0.37 * end, end, 1e12})
    for (const double place : {0.0, -13.7, 1e6})
      require(field.velocity({place, 0.5 * place, 2.0 * place}, t).allFinite(), "wind is finite");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  Wind wind;
  wind.reference_height = 90.0;
  try_reading([&] {
    const auto box = std::make_shared<air::WindBox>(air::parse_bts(bytes, "fuzz.bts"));
    require(box->values.size() == 3 * box->n_t * box->n_z * box->n_y, "there is all wind");
    blow(*air::compose_wind(wind, {.box = box}));
    const air::WindBox again = air::parse_bts(air::make_bts(*box, 90.0, "fuzz"), "again.bts");
    require(again.n_t == box->n_t && again.values.size() == box->values.size(),
            "a box is read as it was written");
  });
  try_reading(
      [&] { blow(*air::compose_wind(wind, {.table = air::parse_wind_table(bytes, "fuzz.txt")})); });
  return 0;
}
