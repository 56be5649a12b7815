#pragma once

// Keys of [wind].

#include "models/air/iec_wind.h"
#include "models/support/key_row.h"
#include "models/wind.h"

namespace spoke::air {

inline constexpr Quantity kWindSpeed = Quantity::any("m/s");
inline constexpr Quantity kWindTime = Quantity::any("s");
inline constexpr Quantity kUp = Quantity::any("");
inline constexpr Quantity kGround = Quantity::any("m");
inline constexpr Quantity kReferenceHeight = Quantity::positive("m");
inline constexpr Quantity kShearExponent = Quantity::between(0.0, 1.0);
inline constexpr Quantity kLinearShear = Quantity::any("1/m");
inline constexpr Quantity kTurbulenceScale = Quantity::positive("m");
inline constexpr Quantity kDeviationRatio = Quantity::between(0.0, 2.0);
inline constexpr Quantity kBoxHeight = Quantity::positive("m");
inline constexpr Count kBoxPoints{2, 100};  ///< along a side of the grid

/// What a condition of IEC 61400-1 has set need not be given.
inline Presence presence_of_intensity(const WindTurbulence& turbulence) {
  return turbulence.intensity > 0.0 ? Presence::optional : Presence::required;
}
inline Presence presence_of_width(const WindTurbulence& turbulence) {
  return turbulence.width > 0.0 ? Presence::optional : Presence::required;
}

}  // namespace spoke::air

namespace spoke::keys {

inline constexpr std::array kWindRows{
    by_hand("velocity", kNumbers, air::kWindSpeed,
            "mean velocity at the reference height, in the inertial frame. Where `speed` or `file` "
            "gives the speed, only its direction counts, +x if it is zero")
        .from("`[0, 0, 0]`")
        .of(std::size_t{3}),
    by_hand("time", kNumbers, air::kWindTime,
            "array of times of `speed`, each greater than the one before")
        .from("none"),
    by_hand(
        "speed", kNumbers, air::kWindSpeed,
        "the speed over time along that direction, by monotone cubics; constant before and after")
        .from("none"),
    by_hand("file", kText,
            "a file of TurbSim (`.bts`) or a table, relative to the scenario; in place of `speed` "
            "and `turbulence`")
        .from("none"),
    by_hand("shear_exponent", kNumber, air::kShearExponent, "exponent of the power law, 0 to 1")
        .from("0"),
    by_hand("vertical_shear", kNumber, air::kLinearShear,
            "linear shear: share of the speed at the reference height by which it grows on a metre "
            "upwards")
        .from("0"),
    by_hand("horizontal_shear", kNumber, air::kLinearShear,
            "likewise across the wind, to the left for who looks along it, from the origin on")
        .from("0"),
    by_hand("reference_height", kNumber, air::kReferenceHeight,
            "height over the ground at which `velocity` is; shear and `turbulence` need it")
        .from("none"),
    by_hand("up", kNumbers, air::kUp, "direction away from the ground")
        .from("`[0, 0, 1]`")
        .of(std::size_t{3}),
    by_hand("ground", kNumber, air::kGround, "coordinate of the ground along `up`").from("0"),
    by_hand("gust", kTable | kTables, "table, or several: see [gusts](#5-gusts)").from("none"),
    by_hand("turbulence", kTable, "table, see [turbulence](#6-turbulence)").from("none"),
    by_hand("iec", kTable, "table, see [conditions of IEC 61400-1](#7-conditions-of-iec-61400-1)")
        .from("none"),
    by_hand("by", kWord,
            "`\"program\"`: the embedding program gives the wind, and no other key is there")
        .from("none")
        .among("program")};

inline constexpr std::array kGustRows{
    number<&WindGust::amplitude>("amplitude", Quantity::any(""),
                                 "A of the shape, in the unit of what it changes; may be negative")
        .required(),
    number<&WindGust::start>("start", air::kWindTime, ""),
    number<&WindGust::duration>("duration", Quantity::positive("s"), "T of the shape"),
    choice<&WindGust::shape, GustShape::one_minus_cosine, GustShape::operating, GustShape::rise>(
        "shape", "`\"one_minus_cosine\"`, `\"operating\"` or `\"rise\"`"),
    choice<&WindGust::of, GustOf::speed, GustOf::direction, GustOf::vertical_shear,
           GustOf::horizontal_shear>("of",
                                     "what it changes: `\"speed\"` (m/s), `\"direction\"` (rad), "
                                     "`\"vertical_shear\"` or `\"horizontal_shear\"` (1/m)")};

inline constexpr std::array kIecRows{
    choice<&IecWind::turbine, IecClass::i_a, IecClass::i_b, IecClass::i_c, IecClass::ii_a,
           IecClass::ii_b, IecClass::ii_c, IecClass::iii_a, IecClass::iii_b, IecClass::iii_c>(
        "class", "of the turbine, by reference speed and turbulence")
        .required(),
    choice<&IecWind::condition, IecCase::nwp, IecCase::ntm, IecCase::etm, IecCase::eog,
           IecCase::edc, IecCase::ecd, IecCase::ews, IecCase::ewm>("case", "the wind condition")
        .required(),
    option<&IecWind::speed>("speed", Quantity::positive("m/s"),
                            "mean speed at the hub; of `\"EWM\"` the class has it")
        .from("required but with `\"EWM\"`"),
    number<&IecWind::start>("start", air::kWindTime,
                            "when `\"EOG\"`, `\"EDC\"`, `\"ECD\"` or `\"EWS\"` begins"),
    count<&IecWind::sign>("sign", Count{-1, 1}, "1 or −1: of `\"EDC\"`, `\"ECD\"` and `\"EWS\"`")
        .within("−1 or 1"),
    choice<&IecWind::shear, IecShear::vertical, IecShear::horizontal>("direction", "of `\"EWS\"`"),
    count<&IecWind::period>("period", Count{1, 50}, "years in which `\"EWM\"` recurs once, 1 or 50")
        .within("1 or 50"),
    flag<&IecWind::turbulent>("turbulent", "`\"EWM\"` by its turbulent model, not the steady one"),
    count<&IecWind::seed>("seed", Count{0, 2147483647}, "of turbulence"),
    option<&IecWind::rotor_diameter>("rotor_diameter", Quantity::positive("m"),
                                     "of gusts, shear and the box of turbulence")
        .from("that of the blades of the first rotor")};

inline constexpr std::array kTurbulenceRows{
    number<&WindTurbulence::intensity>(
        "intensity", Quantity{"", 0.0, 2.0, false},
        "standard deviation along the wind at the reference height, over the speed there")
        .present(presence_by<WindTurbulence, air::presence_of_intensity>)
        .from("required but with `iec`"),
    count<&WindTurbulence::seed>("seed", Count{0, 2147483647},
                                 "a whole number; equal seeds give equal turbulence"),
    choice<&WindTurbulence::spectrum, TurbulenceSpectrum::kaimal>("spectrum", "the only one"),
    option<&WindTurbulence::length_scale>("length_scale", air::kTurbulenceScale,
                                          "Lambda_1, see below")
        .from("by height"),
    by_hand("deviation_ratio", kNumbers, air::kDeviationRatio,
            "standard deviations along the wind, across it and upwards over the first")
        .from("`[1, 0.8, 0.5]`")
        .of(std::size_t{3}),
    choice<&WindTurbulence::scale, TurbulenceScale::centre, TurbulenceScale::none>(
        "scale",
        "of the velocities: to the standard deviations asked for at the `\"centre\"` of "
        "the box; `\"none\"`: as the spectrum has them"),
    choice<&WindTurbulence::coherence, Coherence::longitudinal, Coherence::all>(
        "coherence", "components that are coherent: that along the wind, or `\"all\"`"),
    number<&WindTurbulence::coherence_decay>("coherence_decay", Quantity::between(1.0, 100.0),
                                             "in the exponent of coherence, 1 to 100"),
    number<&WindTurbulence::width>("width", Quantity::positive("m"),
                                   "of the box across the wind; wider than the rotor")
        .present(presence_by<WindTurbulence, air::presence_of_width>)
        .from("required but with `iec`"),
    option<&WindTurbulence::height>(
        "height", air::kBoxHeight,
        "of the box; its middle is at the reference height, and it must not reach below the ground")
        .from("`width`"),
    by_hand("points", kWhole | kNumbers, Quantity::any(""),
            "of the grid along each side, or `[across, upwards]`; 2 to 100")
        .from("15")
        .of(std::size_t{2})
        .of(air::kBoxPoints),
    number<&WindTurbulence::time_step>("time_step", Quantity::positive("s"), ""),
    number<&WindTurbulence::duration>("duration", Quantity::positive("s"),
                                      "after which it repeats, at least")};

}  // namespace spoke::keys
