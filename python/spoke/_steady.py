"""Steady motion, and vibrations about it."""

from collections.abc import Mapping

import numpy as np

from . import _spoke
from ._simulation import read_scenario


def _speeds(speed):
    """Returns the speed of the first rotor, or None, and those of rotors by their names."""
    return (None, dict(speed)) if isinstance(speed, Mapping) else (speed, {})


def equilibrium(scenario, *, set=None, speed=None):
    """Finds the Equilibrium of a model in steady rotation, or at rest.

    scenario, set: as of read_scenario().
    speed: of the hub about its axis [rad/s], of several rotors on a support of the first, or a
        dictionary of speeds by rotor; None, and what is not in it: the one that the drive leads to.

    Raises InputError if nothing holds the hub or a joint, or if the drive is a torque and no speed
    is given; DivergenceError, with subsystem and quantity, if no equilibrium is found.
    """
    return _spoke._solve_equilibrium(read_scenario(scenario, set), *_speeds(speed))


def modes(scenario, *, set=None, speed=None, count=None, frame=None):
    """Finds the lowest Modes of a model about its equilibrium.

    scenario, set, speed: as of equilibrium().
    count: how many, of each blade where blades do not couple, else of the whole model; None: 10, or
        as many as there are.
    frame: from where vibrations are seen, "turning" with the hub; "fixed": from outside, of three
        or more equal blades, and of round shafts; "floquet": of any, whose modes then have
        harmonics. In these two count is of the whole model. None: "fixed" on a support and in
        bearings, else "turning".

    Raises like equilibrium(), but for what nothing holds: that is a mode of frequency zero; and
    InputError if the frame is not for such a model.
    """
    return _spoke._solve_modes(read_scenario(scenario, set), *_speeds(speed), count, frame)


def campbell(scenario, speeds, *, set=None, count=None, harmonics=6, threads=None, frame=None):
    """Follows modes over speeds of rotation: a Campbell diagram.

    scenario, set: as of read_scenario().
    speeds: ascending, two or more [rad/s]; of several rotors on a support of the first, while the
        others turn by the ratios of the speeds that their drives lead to.
    count: modes to follow, as of modes(); None: 6, or as many as there are.
    harmonics: excitation lines, from once per revolution on.
    threads: on which speeds are shared out; None: all that are available.
    frame: as of modes().

    Raises like modes(), and InputError unless speeds ascend.
    """
    return _spoke._solve_campbell(read_scenario(scenario, set), speeds, count, harmonics,
                                  threads or 0, frame)


def critical(scenario, of, start, end, *, set=None, speed=None, points=21, count=None,
             frame=None):
    """Finds the least value in a range at which an equilibrium is lost or a mode stops decaying.

    scenario, set: as of read_scenario().
    of: what is varied, "speed" [rad/s], or "load=NAME", a factor of the loads of this name;
        "load=gravity": of gravity.
    start, end: of the range; the equilibrium is stable at the first.
    speed: of the hub while a load is varied, as of equilibrium().
    points: values at which modes are sought, both ends included.
    count: modes to look at, as of modes().
    frame: "turning" or "fixed", as of modes(); None: "fixed" for a rotor that turns on a support.

    Returns a Critical, whose value is None if the whole range is stable. Raises like modes() at the
    start, and InputError if the equilibrium is unstable there.
    """
    return _spoke._solve_critical(read_scenario(scenario, set), of, start, end, *_speeds(speed), points,
                                  count, frame)


def performance(scenario, *, wind=None, tip_speed_ratio=None, pitch=None, joint="pitch",
                rigid=False, rotor="", set=None):
    """Finds the steady states of a rotor in uniform wind along its axis: its Performance.

    scenario, set: as of read_scenario().
    wind: speeds at the hub [m/s]; of a map one, None: the scenario's.
    tip_speed_ratio: of a map, each with each pitch; None: the rotor finds its speed itself.
    pitch: angles of the pitch joints [rad], of a map one or more; over wind speeds one, at which
        pitch is held. None: those of [control.pitch], or joints as they stand.
    joint: name of the joint that pitches a blade, where there is no [control.pitch].
    rigid: whether blades stay undeformed.
    rotor: name of one of several rotors, which is taken alone.

    One number counts as a list of one. Raises InputError if the scenario has no air, or if an
    argument does not fit; where there is no steady state the result says why (Performance.gaps).
    """
    lists = [[] if values is None else np.atleast_1d(values).astype(float)
             for values in (wind, tip_speed_ratio, pitch)]
    return _spoke._solve_performance(read_scenario(scenario, set), *lists, joint, rigid, rotor)
