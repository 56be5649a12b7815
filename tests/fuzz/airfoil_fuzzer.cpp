// libFuzzer: any bytes are an aerofoil of AeroDyn, of C81 or a plain table, or refused by
// InputError with one line; what is read has coefficients everywhere.

#include <cmath>
#include <string>
#include <string_view>

#include "models/air/airfoil_check.h"
#include "models/air/airfoil_reader.h"
#include "models/air/section_polar.h"
#include "models/error.h"
#include "tests/fuzz/require.h"

using namespace spoke;
using test::require;

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const spatial::Airfoil airfoil = air::parse_airfoil(text, "fuzz.dat", "fuzz");
    air::check_airfoil(airfoil);
    const air::SectionPolar section(airfoil, airfoil, 0.5);
    for (const double reynolds : {0.0, 1e3, 1e6, 1e12})
      for (double angle = -6.0; angle < 6.0; angle += 0.1) {
        const air::PolarValues values =
            section.values(section.level(reynolds, 1e-6 * reynolds), angle);
        require(std::isfinite(values.lift) && std::isfinite(values.recovery), "lift is finite");
        require(values.drag >= 0.0 && std::isfinite(values.moment), "drag is not negative");
        require(values.separation >= 0.0 && values.separation <= 1.0, "f is a share");
      }
  } catch (const InputError& error) {
    const std::string message = error.what();
    require(!message.empty() && message.find('\n') == std::string::npos, "a message is one line");
  }
  return 0;
}
