"""Flexible multibody dynamics in which every integration step is a task graph.

    import spoke

    sim = spoke.Simulation("models/wu_haug_rotor.toml", set={"blade.bodies": 8})
    result = sim.run()
    print(result["blade1.tip.y"].min())

All quantities are in SI units. Blades, bodies, joints and loads count from 0, as in C++; the names
of sensors, messages, and keys of scenarios count from 1, as scenario files do.
"""

from . import model
from ._reduce import reduce
from ._result import Result
from ._simulation import Simulation, read_scenario
from ._spoke import (
    AnchorMotion,
    BladeEquilibrium,
    BladeShape,
    BodyState,
    Campbell,
    ConstantSpeed,
    ControlCommands,
    ControlledBlade,
    ControlRecord,
    CoordinateMotion,
    Courses,
    Critical,
    Curve,
    DivergenceError,
    Equilibrium,
    Error,
    FixedDrive,
    FreeDrive,
    HubMotion,
    InputError,
    InternalError,
    JointPosition,
    Load,
    LoadError,
    LoopLoad,
    Marker,
    MarkerMotion,
    MarkerMotions,
    MarkerState,
    Mode,
    Modes,
    Performance,
    RotorAir,
    RotorEquilibrium,
    SavedState,
    Scenario,
    SectionLoad,
    SolidReduction,
    SpeedTable,
    SpinUp,
    SpinUpHoldSpinDown,
    StateError,
    TorqueBySpeed,
    TorqueDrive,
    Trace,
    Wrench,
    __version__,
    courses,
    markers_at,
)
from ._steady import campbell, critical, equilibrium, modes, performance

__all__ = [
    "AnchorMotion", "BladeEquilibrium", "BladeShape", "BodyState", "Campbell", "ConstantSpeed",
    "ControlCommands", "ControlRecord", "ControlledBlade", "CoordinateMotion",
    "Courses", "Critical", "Curve", "DivergenceError", "Equilibrium", "Error", "FixedDrive", "FreeDrive", "HubMotion",
    "InputError", "InternalError", "JointPosition", "Load", "LoadError", "LoopLoad", "Marker",
    "MarkerMotion",
    "MarkerMotions", "MarkerState", "Mode", "Modes", "Performance", "Result", "RotorAir",
    "RotorEquilibrium", "SavedState", "Scenario",
    "SectionLoad", "Simulation", "SolidReduction", "SpeedTable", "SpinUp", "SpinUpHoldSpinDown", "StateError",
    "TorqueBySpeed", "TorqueDrive", "Trace", "Wrench", "__version__", "campbell", "courses", "critical",
    "equilibrium",
    "markers_at", "model", "modes", "performance", "read_scenario", "reduce",
]


def _finish():
    """Everything public is called spoke.NAME, and what has a page shows it in notebooks."""
    from ._arguments import check_arguments
    from ._pages import frame

    check_arguments(__all__)
    for name in __all__:
        if isinstance(globals()[name], type):
            globals()[name].__module__ = __name__
    for shown in (Campbell, Critical, Equilibrium, Mode, Modes, Performance, Result, Scenario, Trace):
        shown._repr_html_ = frame
    Simulation._repr_html_ = lambda self: frame(self.scenario)


_finish()
