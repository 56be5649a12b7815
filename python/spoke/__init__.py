"""Flexible multibody dynamics in which every integration step is a task graph.

    import spoke

    sim = spoke.Simulation("models/wu_haug_rotor.toml", set={"blade.bodies": 8})
    result = sim.run()
    print(result["blade1.tip.y"].min())

All quantities are in SI units. Blades, bodies and joints count from 0, as in C++; the names of
sensors, and messages, count from 1, as scenario files do.
"""

import math
import os

from ._result import Result
from ._spoke import (
    ConstantSpeed,
    Curve,
    DivergenceError,
    Error,
    FixedDrive,
    FreeDrive,
    InputError,
    InternalError,
    Load,
    LoadError,
    Marker,
    MarkerMotion,
    MarkerState,
    SavedState,
    Scenario,
    SpeedTable,
    SpinUp,
    SpinUpHoldSpinDown,
    StateError,
    TorqueBySpeed,
    TorqueDrive,
    Wrench,
    __version__,
)
from ._spoke import Simulation as _Simulation
from ._toml import make_overrides, make_toml

__all__ = [
    "ConstantSpeed", "Curve", "DivergenceError", "Error", "FixedDrive", "FreeDrive", "InputError",
    "InternalError", "Load", "LoadError", "Marker", "MarkerMotion", "MarkerState", "Result",
    "SavedState", "Scenario", "Simulation", "SpeedTable", "SpinUp", "SpinUpHoldSpinDown",
    "StateError", "TorqueBySpeed", "TorqueDrive", "Wrench", "__version__", "read_scenario",
]


def read_scenario(scenario, set=None):
    """A Scenario from a file, from the text of one, or from a dictionary.

    scenario: path of a TOML file; or its text, told by its line breaks; or a dictionary of its
        tables and keys, docs/scenario.md.
    set: values of keys that take precedence, {"blade.bodies": 8}.

    Raises InputError, which names file, line, column, key, value and what was expected.
    """
    overrides = make_overrides(set or {})
    if isinstance(scenario, dict):
        return Scenario._parse(make_toml(scenario), "scenario", overrides)
    if isinstance(scenario, str) and "\n" in scenario:
        return Scenario._parse(scenario, "scenario", overrides)
    return Scenario._read(os.fspath(scenario), overrides)


class Simulation(_Simulation):
    """Simulates one system. Different simulations may run in different Python threads."""

    def __init__(self, scenario, *, set=None, formulation="structured", executor="auto",
                 threads=None, window=0, loads=()):
        """Builds the model and its step graph, and evaluates the accelerations at t = 0.

        scenario: a Scenario, or what read_scenario() takes.
        set: values of keys that take precedence, {"blade.bodies": 8}.
        formulation: "structured", "subsystem" or "augmented"; equal results up to round-off.
        executor: "auto", "serial", "flow_graph", "openmp_scheme1", "openmp_scheme2" or
            "openmp_levels"; equal results to the last bit.
        threads: how many, or a pair (teams, threads of each); None: all that are available.
        window: most steps that one run of the executor makes; 0: as the executor chooses.
        loads: Loads that act besides those of the scenario.

        Raises InputError, LoadError if a load fails at t = 0, DivergenceError.
        """
        if isinstance(scenario, Scenario):
            if set:
                raise InputError("set: given with a Scenario, expected with a file, text or dict")
        else:
            scenario = read_scenario(scenario, set)
        super().__init__(scenario, formulation, executor, _as_pair(threads), window, list(loads))

    def run(self, until=math.inf, every=None):
        """Steps to time `until` [s], by default to the scenario's end, and returns a Result.

        every: interval of the result's rows [s]; None: the scenario's; 0: every step. The present
            state and the last step are rows, too.

        The interpreter lock is released meanwhile. Ctrl-C ends the run after a step, from which it
        can go on. Raises DivergenceError, after which a saved state has to be restored, and
        LoadError.
        """
        if every is None:
            every = self.scenario.output_interval
        return Result(self._run(until, every))

    def __repr__(self):
        return (f"<spoke.Simulation {self.scenario.title or self.scenario.name!r}, "
                f"{self.coordinates} coordinates, step {self.steps} of {self.planned_steps}, "
                f"t = {self.time:g} s>")


def _as_pair(threads):
    if threads is None:
        return (0, 1)
    return tuple(threads) if isinstance(threads, (tuple, list)) else (threads, 1)
