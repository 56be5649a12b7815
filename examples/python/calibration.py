"""A stiffness is calibrated to a measured frequency. Needs SciPy."""

from scipy.optimize import brentq

import spoke
from spoke import model

MEASURED = 3.2  # of the first lag mode of the blade on the bench [rad/s]

blade = model.scenario(
    hub=model.hub(drive=spoke.FixedDrive()),
    blade=model.blade(count=1, length=8.0, bodies=4, elements=4, density=2766.67, area=7.299e-5,
                      second_moment=8.214e-9, youngs_modulus=6.895e10),
    integration=model.integration(duration=1.0))


def first_frequency(youngs_modulus):
    """[rad/s] of a blade of this Young's modulus [Pa]."""
    return spoke.modes(blade, set={"blade.youngs_modulus": youngs_modulus}, count=1).frequencies[0]


found = brentq(lambda modulus: first_frequency(modulus) - MEASURED, 1e10, 2e11, rtol=1e-10)
print(f"Young's modulus {found:.6g} Pa gives {first_frequency(found):.6g} rad/s")

# Frequencies of a beam grow with the root of its stiffness.
expected = 6.895e10 * (MEASURED / first_frequency(6.895e10)) ** 2
assert abs(found / expected - 1.0) < 1e-6
