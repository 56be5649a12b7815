"""What a run leaves behind."""

import difflib
import json
from collections.abc import Mapping

import numpy as np

from ._spoke import InputError, StateError


class UnknownSensor(InputError, KeyError):
    """A result has no sensor of that name: an error as of Simulation.sensor(), and as of a mapping."""

    __str__ = BaseException.__str__  # that of a KeyError is the repr of its argument


def _describe_unknown(name, names):
    nearest = difflib.get_close_matches(str(name), names, n=3)
    meant = f"did you mean {' or '.join(nearest)}? " if nearest else ""
    some = ", ".join(names[:30]) + (f" and {len(names) - 30} more" if len(names) > 30 else "")
    return f"no sensor of the result is named {name!r}, {meant}expected one of {some}"


class _Kept:
    """What a Result needs of its run, in a process that did not make it."""

    def __init__(self, recording):
        self.names = recording.names
        self.units = recording.units
        self.wall_time = recording.wall_time
        self.numbers = np.array(recording.numbers)
        self._texts = {}
        if recording.is_at_hand:
            self._texts["summary"] = recording.make_summary()
            if recording.has_page:
                self._texts["page"] = recording.make_page()

    def _text(self, name):
        if name in self._texts:
            return self._texts[name]
        raise StateError(f"no {name}: when the result was pickled, the run had none")

    def make_summary(self):
        return self._text("summary")

    def make_page(self):
        return self._text("page")


class Result(Mapping):
    """The sensors of a run over time: a mapping from names to NumPy arrays.

        result = sim.run(every=0.01)
        result["hub.torque"]            # (rows,) [N m], a view of the run's own numbers
        result.t                        # (rows,) [s]

    A name that it does not have is an InputError, with the nearest names, and a KeyError.

    It can be pickled and copied, with its summary and page; run(report=False) leaves the page out.

    Attributes:
        t: times of the rows, (rows,) [s].
        numbers: (rows, 1 + sensors), time and sensors by row, read-only. Arrays are views of it.
        units: {"hub.torque": "N m", ...}.
        wall_time: what the steps took [s].
    """

    def __init__(self, recording):
        self._recording = recording
        self.numbers = recording.numbers
        self.numbers.flags.writeable = False
        self.t = self.numbers[:, 0]
        self.units = dict(zip(recording.names, recording.units))
        self.wall_time = recording.wall_time
        self._columns = {name: k + 1 for k, name in enumerate(recording.names)}

    def __reduce__(self):
        kept = isinstance(self._recording, _Kept)
        return Result, (self._recording if kept else _Kept(self._recording),)

    def __copy__(self):
        return Result(self._recording)

    def __getitem__(self, name):
        if name not in self._columns:
            raise UnknownSensor(_describe_unknown(name, list(self._columns)))
        return self.numbers[:, self._columns[name]]

    def __iter__(self):
        return iter(self._columns)

    def __len__(self):
        return len(self._columns)

    def to_pandas(self):
        """A pandas.DataFrame with the sensors as columns, indexed by time [s]; a copy."""
        import pandas

        return pandas.DataFrame(
            self.numbers[:, 1:].copy(), columns=list(self), index=pandas.Index(self.t, name="t"))

    def summary(self):
        """summary.json of the run as a dictionary: values in force, counts, extremes of sensors.

        Raises StateError if the run diverged and the simulation was restored since.
        """
        return json.loads(self._recording.make_summary())

    def page(self):
        """report.html of the run: plots and the moving rotor, one page without network.

        Raises StateError if the run was made with report=False, or if it diverged and the
        simulation was restored since.
        """
        return self._recording.make_page()

    def __repr__(self):
        return (f"<spoke.Result {len(self)} sensors, {len(self.t)} rows, "
                f"t = {self.t[0]:g} to {self.t[-1]:g} s>")
