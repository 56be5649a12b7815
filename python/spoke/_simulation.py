"""Scenarios from Python, and their simulation."""

import math
import os

from ._result import Result
from ._spoke import DivergenceError, InputError, LoadError, Recording, SavedState, Scenario, Trace
from ._spoke import Simulation as _Simulation
from ._toml import make_overrides, make_toml


def read_scenario(scenario, set=None):
    """A Scenario from a file, from the text of one, or from a dictionary.

    scenario: path of a TOML file; or its text, told by its line breaks; or a dictionary of its
        tables and keys, docs/scenario.md, see also spoke.model; or a Scenario, as it is.
    set: values of keys that take precedence, {"blade.bodies": 8}.

    Raises InputError with file, line, column and key.
    """
    if isinstance(scenario, Scenario):
        if set:
            raise InputError("set: given with a Scenario, expected with a file, text or dictionary")
        return scenario
    overrides = make_overrides(set or {})
    if isinstance(scenario, dict):
        return Scenario._parse(make_toml(scenario), "scenario", overrides)
    if isinstance(scenario, str) and "\n" in scenario:
        return Scenario._parse(scenario, "scenario", overrides)
    return Scenario._read(os.fspath(scenario), overrides)


class Simulation(_Simulation):
    """Simulates one system. Different simulations may run in different Python threads."""

    def __init__(self, scenario, *, set=None, formulation="structured", executor="auto",
                 threads=None, window=0, loads=(), wind=None, controller=None):
        """Builds the model and its step graph, and evaluates the accelerations at t = 0.

        scenario: what read_scenario() takes.
        set: values of keys that take precedence, {"blade.bodies": 8}.
        formulation: "structured", "subsystem" or "augmented"; equal results up to round-off.
        executor: "auto", "serial", "flow_graph", "openmp_scheme1", "openmp_scheme2",
            "openmp_levels" or "openmp_tasks"; equal results to the last bit.
        threads: how many, or a pair (teams, threads of each); None: all that are available.
        window: most steps that one run of the executor makes; 0: as the executor chooses.
        loads: Loads that act besides those of the scenario.
        wind: of a model in air, a function of place (3,) [m] and time [s] that returns the velocity
            of the air there (3,) [m/s], all in the inertial frame, in place of the scenario's wind;
            it must depend on its arguments alone. What it raises is shown as Python shows what
            cannot be raised (sys.unraisablehook), and the step ends with DivergenceError.
        controller: of a scenario with [control.program], for this simulation alone: an object with
            the method control(record, commands), called at each sample with a ControlRecord and the
            ControlCommands, whose attributes it sets; or a function of these. It may have
            begin(sensors), called with the names of the sensors; and save(), which returns bytes of
            all that it keeps, with restore(saved): else the simulation is neither saved nor cloned.
            clone() copies it by copy.deepcopy. What it raises leaves the function that steps.

        Raises InputError, LoadError if a load fails at t = 0, DivergenceError.
        """
        if controller is not None and not (hasattr(controller, "control") or callable(controller)):
            raise TypeError(f"spoke.Simulation(): controller is {controller!r}, expected an object "
                            "with the method control(record, commands), or a function")
        super().__init__(read_scenario(scenario, set), formulation, executor, _as_pair(threads),
                         window, list(loads), wind, controller)

    def clone(self):
        """A simulation at the same state, which goes on by itself to the bits that this one would.

        The drive, motions, factors and wind are those in force. Takes the copying of the state: the
        scenario is not read again, and all that is constant is shared. Both may be stepped at once,
        in two threads; loads and a wind in Python are shared, and called by both. Raises StateError
        after a step that failed, or while the simulation is in use.
        """
        clone = type(self).__new__(type(self))
        _Simulation.__init__(clone, self)
        return clone

    def run(self, until=math.inf, every=None, report=True, statistics_from=None):
        """Steps to time `until` [s], by default to the scenario's end, and returns a Result.

        every: interval of the result's rows [s]; None: the scenario's; 0: every step. The present
            state and the last step are rows, too.
        report: whether to record the curves and pictures of Result.page(), which takes some 10 % of
            the run of a small rotor.
        statistics_from: time [s] of the first row that counts in Result.summary()["statistics"];
            None: all rows of a model in air, and no statistics of others.

        The interpreter lock is released meanwhile. Ctrl-C ends the run after a step, from which it
        can go on. Raises DivergenceError, after which a saved state has to be restored, and
        LoadError; their attribute `result` is the Result of the steps before.
        """
        every = self.scenario.output_interval if every is None else every
        recording = Recording(self, every, report, statistics_from)
        try:
            recording.run(until)
        except (DivergenceError, LoadError) as error:
            error.result = Result(recording)
            raise
        return Result(recording)

    def trace(self, steps=20, buffer_bytes=256e6):
        """Makes steps as run() does, to the same bits, and records which thread ran what when.

        steps: how many, at most those that are left.
        buffer_bytes: at most so much memory for the recording.

        Returns a Trace.
        """
        return Trace(self, steps, buffer_bytes)

    def save_to(self, file):
        """Writes the state as a checkpoint: the old file or the new one as a whole."""
        self.save()._to_file(os.fspath(file))

    def restore_from(self, file):
        """Restores the state of a checkpoint, also of one that `spoke run` wrote."""
        self.restore(SavedState._from_file(os.fspath(file)))

    def __repr__(self):
        return (f"<spoke.Simulation {self.scenario.title or self.scenario.name!r}, "
                f"{self.coordinates} coordinates, step {self.steps} of {self.planned_steps}, "
                f"t = {self.time:g} s>")


def _as_pair(threads):
    if threads is None:
        return (0, 1)
    return tuple(threads) if isinstance(threads, (tuple, list)) else (threads, 1)
