#pragma once

// Turbulence by Veers' method: a box of velocities with given spectra and coherence.

#include <array>
#include <cstddef>

#include "models/air/wind_box.h"
#include "models/wind.h"

namespace spoke::air {

/// The size of a box, and what it takes to make it. Numbers may be far beyond any memory.
struct BoxCost {
  double values = 0.0;      ///< velocities, of three components each
  double operations = 0.0;  ///< floating-point operations for the coherence
};
/// Estimates what a box takes. Precondition: its numbers are in their ranges.
BoxCost estimate_cost(const WindTurbulence& turbulence);

/// Returns the number of time steps of a box: the least even one with no prime factor beyond 5 that
/// lasts as long as is asked.
std::size_t count_steps(const WindTurbulence& turbulence);

/// Returns the longitudinal turbulence scale parameter Lambda_1 of IEC 61400-1 [m] at a height [m].
double calc_length_scale(double height);

/// The spectrum of Kaimal, one-sided, of variance 1: S(f) = 4 tau/(1 + 6 f tau)^(5/3), with the
/// time tau = length scale of the component / mean speed.
struct KaimalSpectrum {
  double tau;  ///< [s]

  double density(double frequency) const;   ///< [s], at a frequency [Hz]
  double integral(double frequency) const;  ///< from 0 to a frequency
};

/// Returns the spectra of the components along the wind, across it and upwards.
std::array<KaimalSpectrum, 3> make_spectra(const WindTurbulence& turbulence, double speed,
                                           double reference_height);

/// Returns e^(-c r), the coherence of two places at a distance r [m], at a frequency [Hz]: c [1/m].
double calc_coherence_rate(const WindTurbulence& turbulence, double speed, double reference_height,
                           double frequency);

/// Makes the velocities that turbulence adds to a mean wind of this speed [m/s] at the reference
/// height [m]. Their mean over the duration is 0 at each point; at the centre of the box the
/// standard deviations are those asked for. Throws InputError with the key "turbulence.width" if
/// points lie too close for their coherence to be factorised.
WindBox make_turbulence(const WindTurbulence& turbulence, double speed, double reference_height);

}  // namespace spoke::air
