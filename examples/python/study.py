"""A small study in threads: how does the lag of the tips depend on stiffness and length?

Each simulation runs on one thread, and as many at once as there are processors: the interpreter's
lock is released while steps are made. Thousands of runs, designs, Sobol indices and many machines
are the business of `spoke study`.
"""

import itertools
import os
from concurrent.futures import ThreadPoolExecutor

import numpy as np

import spoke
from spoke import model

rotor = model.scenario(
    hub=model.hub(drive=spoke.SpinUp(speed=4.0, ramp=15.0)),
    blade=model.blade(count=1, length=8.0, bodies=2, elements=4, density=2766.67, area=7.299e-5,
                      second_moment=8.214e-9, youngs_modulus=6.895e10),
    integration=model.integration(duration=16.0, step=0.01))

MODULI = np.linspace(6e10, 8e10, 5)    # Young's modulus [Pa]
LENGTHS = np.linspace(7.0, 8.0, 5)     # [m]


def largest_lag(values):
    """[m] of a rotor with this Young's modulus and length."""
    modulus, length = values
    sim = spoke.Simulation(rotor, set={"blade.youngs_modulus": modulus, "blade.length": length},
                           executor="serial")
    return -sim.run(every=0, report=False)["blade1.tip.y"].min()


runs = list(itertools.product(MODULI, LENGTHS))
with ThreadPoolExecutor(os.cpu_count()) as pool:
    lags = np.array(list(pool.map(largest_lag, runs))).reshape(len(MODULI), len(LENGTHS))

# In proportion to powers of both: the slopes of a plane through logarithms.
terms = np.column_stack([np.ones(len(runs)), np.log(runs)])
(_, by_modulus, by_length), *_ = np.linalg.lstsq(terms, np.log(lags.ravel()), rcond=None)
print(f"largest lag {lags.min():.3f} to {lags.max():.3f} m, about as "
      f"modulus^{by_modulus:.2f} length^{by_length:.2f}")

# A beam under its own inertia bends as length^5 / modulus; rotation makes it stiffer, the more so
# the softer and longer it is.
assert -1.0 < by_modulus < -0.8 and 4.0 < by_length < 5.0
