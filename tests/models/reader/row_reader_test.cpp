// Rows of keys: what is read, written, visited and told by them.

#include "models/reader/row_reader.h"

#include <doctest/doctest.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "models/reader/toml_document.h"
#include "tests/message_of.h"

using namespace spoke;
using spoke::test::message_of;

namespace {

enum class Shade { light, dark };
std::string_view name_of(Shade shade) { return shade == Shade::light ? "light" : "dark"; }

struct Lamp {
  double power = 5.0;
  std::optional<double> height;
  int bulbs = 1;
  bool is_on = false;
  Shade shade = Shade::light;
  double warmth = 0.0;  ///< of more than one bulb
};

bool has_bulbs(const Lamp& lamp) { return lamp.bulbs > 1; }

constexpr std::array kLampRows{
    keys::number<&Lamp::power>("power", Quantity::positive("W"), "of the lamp").required(),
    keys::option<&Lamp::height>("height", Quantity::not_negative("m"), "above the ground"),
    keys::count<&Lamp::bulbs>("bulbs", Count{1, 4}, "number of bulbs"),
    keys::flag<&Lamp::is_on>("on", "whether it is on"),
    keys::choice<&Lamp::shade, Shade::light, Shade::dark>("shade", "what it shines through"),
    keys::by_hand("name", keys::kText, "what it is called"),
    keys::number<&Lamp::warmth>("warmth", Quantity::any("K"), "of the light")
        .when(keys::holds<Lamp, has_bulbs>)};

Lamp read_lamp(const std::string& text) {
  const TomlDocument document(text, "f.toml");
  const TomlSection section(document, keys::keys_of(kLampRows));
  Lamp lamp;
  keys::read(section, kLampRows, &lamp);
  return lamp;
}

}  // namespace

TEST_CASE("rows read numbers, options, counts, flags and choices") {
  const Lamp lamp = read_lamp(
      "power = 3\nheight = 2.5\nbulbs = 2\non = true\nshade = \"dark\"\nname = \"a\"\nwarmth = 7");
  CHECK(lamp.power == 3.0);
  CHECK(lamp.height == 2.5);
  CHECK(lamp.bulbs == 2);
  CHECK(lamp.is_on);
  CHECK(lamp.shade == Shade::dark);
  CHECK(lamp.warmth == 7.0);
  CHECK(read_lamp("power = 1\nwarmth = 7").warmth == 0.0);
}

TEST_CASE("rows word what is wrong as readers by hand do") {
  const auto message = [](const char* text) { return message_of([=] { read_lamp(text); }); };
  CHECK(message("bulbs = 1") ==
        "f.toml:1:1: power: is missing, expected a number greater than 0 (W)");
  CHECK(message("power = -1") == "f.toml:1:9: power: is -1, expected a number greater than 0 (W)");
  CHECK(message("power = 1\nbulbs = 5") ==
        "f.toml:2:9: bulbs: is 5, expected a whole number from 1 to 4");
  CHECK(message("power = 1\non = 1") == "f.toml:2:6: on: is 1, expected true or false");
  CHECK(message("power = 1\nshade = \"red\"") ==
        "f.toml:2:9: shade: is \"red\", expected \"light\" or \"dark\"");
  CHECK(message("power = 1\nbulb = 1") == "f.toml:2:1: bulb: unknown key, did you mean \"bulbs\"?");
}

TEST_CASE("rows write what they read, in their order") {
  Lamp lamp;
  Json all = Json::object(), words = Json::object(), numbers = Json::object();
  keys::write(kLampRows, &lamp, all);
  CHECK(all.dump() == R"({"power":5.0,"bulbs":1,"on":false,"shade":"light"})");
  lamp.height = 1.0;
  lamp.bulbs = 2;
  keys::write_words(kLampRows, &lamp, words);
  CHECK(words.dump() == R"({"shade":"light"})");
  keys::write_numbers(kLampRows, &lamp, numbers);
  CHECK(numbers.dump() == R"({"power":5.0,"bulbs":2,"warmth":0.0})");
}

TEST_CASE("rows tell what is not the default and was not said") {
  Lamp lamp;
  CHECK(keys::describe_others(kLampRows, &lamp).empty());
  lamp.power = 2.5;
  lamp.height = 1.0;
  lamp.shade = Shade::dark;
  lamp.warmth = 3.0;  // of one bulb, which has none
  CHECK(keys::describe_others(kLampRows, &lamp) == ", power 2.5, height 1, shade dark");
  constexpr std::array<std::string_view, 1> kSaid{"power"};
  CHECK(keys::describe_others(kLampRows, &lamp, kSaid) == ", height 1, shade dark");
}

TEST_CASE("a table of several parts has each key once") {
  constexpr std::array kMore{keys::by_hand("name", keys::kText, ""),
                             keys::by_hand("cable", keys::kNumber, "")};
  CHECK(keys::keys_of(kLampRows, kMore) ==
        TomlSection::Keys{"power", "height", "bulbs", "on", "shade", "name", "warmth", "cable"});
}
