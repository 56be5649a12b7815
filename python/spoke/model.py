"""Tables of a scenario as functions with named arguments.

    from spoke import model

    scenario = model.scenario(
        hub=model.hub(drive=spoke.SpinUp(speed=4.0, ramp=15.0)),
        blade=model.blade(count=3, length=8.0, density=2766.67, area=7.299e-5,
                          second_moment=8.214e-9, youngs_modulus=6.895e10),
        integration=model.integration(duration=20.0, step=0.005))
    sim = spoke.Simulation(scenario)

Each returns a dictionary of the keys that were given; what is left out has the default of
docs/scenario.md, which also says what each key may be. `more` are keys that only models in space
have. All quantities are in SI units: m, kg, s, N, Pa, rad. Vectors are sequences of two numbers, in
space of three. Blades and joints count from 1 here, as in files.
"""

from ._spoke import (
    ConstantSpeed,
    FixedDrive,
    FreeDrive,
    SpeedTable,
    SpinUp,
    SpinUpHoldSpinDown,
    TorqueBySpeed,
    TorqueDrive,
)

__all__ = [
    "anchor", "blade", "damping", "distributed_load", "drag", "gravity", "hub", "hub_load", "integration",
    "limits", "load", "loop", "output", "point_mass", "scenario", "sections", "sensor",
]


def _given(arguments):
    """The table of what was given: of the arguments that are not None."""
    more = arguments.pop("more", {})
    table = {key.rstrip("_"): value for key, value in arguments.items() if value is not None}
    return {**table, **more}


def _points(curve, argument, value):
    """A curve as the two arrays of a table."""
    if len(curve.times) < 2:
        return {value: curve.values[0]}
    return {argument: curve.times, value: curve.values}


_DRIVES = {
    SpinUp: lambda d: {"kind": "spin_up", "speed": d.speed, "ramp": d.ramp},
    SpinUpHoldSpinDown: lambda d: {
        "kind": "spin_up_hold_spin_down", "speed": d.speed, "ramp": d.ramp, "hold": d.hold,
        "ramp_down": d.ramp_down},
    SpeedTable: lambda d: {"kind": "table", "time": d.speed.times, "speed": d.speed.values},
    FixedDrive: lambda d: {"kind": "fixed"},
    ConstantSpeed: lambda d: {"kind": "constant", "speed": d.speed},
    TorqueDrive: lambda d: {
        "kind": "torque", "initial_speed": d.initial_speed, **_points(d.torque, "time", "torque")},
    TorqueBySpeed: lambda d: {
        "kind": "torque_by_speed", "initial_speed": d.initial_speed, "ramp": d.ramp,
        "speed": d.torque.times, "torque": d.torque.values},
    FreeDrive: lambda d: {"kind": "free", "initial_speed": d.initial_speed},
}


def scenario(*, hub, integration, blade=None, blades=None, title=None, world=None, anchor=None,
             gravity=None, damping=None, load=None, distributed_load=None, drag=None, hub_load=None,
             limits=None, output=None, sensor=None, **more):
    """A whole scenario, for spoke.Simulation and spoke.read_scenario().

    hub, integration, blade, gravity, damping, limits, output: tables.
    anchor, blades, load, distributed_load, drag, hub_load, sensor: lists of tables.
    title: for people.
    world: "plane" or "space".
    """
    return _given(locals())


def hub(*, support=None, radius=None, inertia=None, mass=None, drive=None, **more):
    """The hub.

    support: "axle" or "free".
    radius: distance of the blades' roots from the axis [m].
    inertia: about the axis, without blades [kg m^2].
    mass: without blades; needed if it is free [kg].
    drive: a drive such as spoke.SpinUp, or its table.
    """
    if type(drive) in _DRIVES:
        drive = _DRIVES[type(drive)](drive)
    return _given(locals())


def blade(*, count=None, length=None, bodies=None, elements=None, density=None, area=None,
          second_moment=None, youngs_modulus=None, sections=None, point_mass=None, loop=None,
          geometric_stiffening=None, strain=None, reference_frame=None, azimuth=None,
          **more):
    """All blades alike, or one of several.

    count: number of blades, evenly around the hub.
    length: from root to tip [m].
    bodies: flexible bodies along the blade.
    elements: finite elements of each body.
    density: mass density [kg/m^3].
    area: of the cross section [m^2].
    second_moment: of area, for bending in the plane [m^4].
    youngs_modulus: [Pa].
    sections: properties that change along the blade, in place of these four: sections().
    point_mass: a list of point_mass().
    loop: a list of loop().
    geometric_stiffening: whether the tension of rotation stiffens bending within a body.
    strain: "automatic", "linear" or "nonlinear".
    reference_frame: "clamped" or "chord".
    azimuth: direction of the first blade in the hub's frame [rad].
    """
    return _given(locals())


def sections(*, station=None, mass_per_length=None, axial_stiffness=None, bending_stiffness=None,
             **more):
    """Properties along a blade: sequences of equal length, linear in between.

    station: distances from the root, from 0 to the length [m].
    mass_per_length: [kg/m].
    axial_stiffness: EA [N].
    bending_stiffness: EI, for bending in the plane [N m^2].
    """
    return _given(locals())


def point_mass(*, position, mass, inertia=None, **more):
    """A mass on a blade.

    position: distance from the root [m].
    mass: [kg].
    inertia: about its centre, for rotation in the plane [kg m^2].
    """
    return _given(locals())


def loop(*, name, kind, from_, to, axis=None, length=None, stiffness=None, damping=None, **more):
    """A closed loop of a blade: a cut joint between two places.

    name: unlike that of the blade's other loops.
    kind: "fixed", "revolute", "prismatic" or "distance".
    from_: a place on a body, a table with station or point, and orientation.
    to: another place: "hub", "mount", or a table, also with anchor or body.
    axis: of a prismatic closure, in the frame of to.
    length: of a distance; None: that at the start [m].
    stiffness: of springs in place of a rigid closure, one number, or one for each direction that is
        locked [N/m, N m/rad].
    damping: of dampers beside these, likewise [N s/m, N m s/rad].
    """
    return _given(locals())


def anchor(*, name, frame=None, turns_with_hub=None, motion=None):
    """A frame whose motion is prescribed, for loops to close on.

    name: unlike that of any other anchor.
    frame: in which it moves, "mount" or "hub".
    turns_with_hub: whether it turns with the hub besides.
    motion: a table with translation and rotation, or with by="program".
    """
    return _given(locals())


def gravity(*, acceleration, ramp=None):
    """Gravity.

    acceleration: in the inertial frame [m/s^2].
    ramp: its rise [s].
    """
    return _given(locals())


def damping(*, mass_factor=None, stiffness_factor=None, flap=None, lag=None, axial=None, torsion=None,
            flap_shear=None, lag_shear=None, mu=None, ratios=None, above=None):
    """Damping of the deformation: Rayleigh's of every body, and of beams by direction and by mode.

    mass_factor: of the mass matrix [1/s].
    stiffness_factor: of the stiffness matrix [s].
    flap, lag, axial, torsion, flap_shear, lag_shear: factors of the stiffness by direction [s]; in the plane
        lag and axial.
    mu: in place of these six, in BeamDyn's order [s]: shear in flap and lag, axial, lag, flap, torsion.
    ratios: damping ratios of the lowest modes of each beam at rest, held at its root.
    above: damping ratio of the mode above these; higher ones have more by their frequency.
    """
    return _given(locals())


def load(*, force=None, moment=None, blade=None, position=None, frame=None, name=None, ramp=None,
         time=None, factor=None, **more):
    """A force and a moment at a point of a blade.

    force: [N].
    moment: [N m].
    blade: number from 1, or "all".
    position: distance from the root [m]; None: the tip.
    frame: "inertial", "hub" or "section".
    name: by which critical() varies it.
    ramp: its rise [s].
    time, factor: sequences, factors of the load over time [s].
    """
    return _given(locals())


def distributed_load(*, force_per_length=None, moment_per_length=None, blade=None, from_=None,
                     to=None, frame=None, name=None, ramp=None, time=None, factor=None, **more):
    """A force and a moment per length of a blade.

    force_per_length: [N/m].
    moment_per_length: [N].
    from_, to: distances of its ends from the root [m].
    blade, frame, name, ramp, time, factor: as of load().
    """
    return _given(locals())


def drag(*, relative_to=None, linear=None, quadratic=None, position=None, linear_per_length=None,
         quadratic_per_length=None, from_=None, to=None, blade=None, name=None, ramp=None,
         time=None, factor=None):
    """A force against the motion of a blade, -(c1 + c2 |u|) u.

    relative_to: of what u is the velocity, "inertial" or "hub".
    linear: c1 at a point [N s/m].
    quadratic: c2 at a point [N s^2/m^2].
    position: of the point, distance from the root [m]; None: the tip.
    linear_per_length: c1 per length [N s/m^2].
    quadratic_per_length: c2 per length [N s^2/m^3].
    from_, to: distances of its ends from the root [m].
    blade, name, ramp, time, factor: as of load().
    """
    return _given(locals())


def hub_load(*, force=None, position=None, frame=None, torque=None, name=None, ramp=None,
             time=None, factor=None, **more):
    """A force and a torque on the hub.

    force: [N].
    position: where it acts, in the hub's frame [m].
    frame: in which the force is resolved, "hub" or "inertial".
    torque: about the axis, besides that of the force [N m].
    name, ramp, time, factor: as of load().
    """
    return _given(locals())


def integration(*, duration, step=None, method=None, spectral_radius=None, tolerance=None,
                iterate_to=None, iterations=None, max_iterations=None, loop_redundancy=None):
    """How the motion is integrated.

    duration: simulated time [s].
    step: [s].
    method: "generalized_alpha" or "rk4".
    spectral_radius: of generalized_alpha at infinite frequency, 0 to 1.
    tolerance: last change of a coordinate in a step's iteration, at most [m, rad].
    iterate_to: "error", a share of the step's own error, or "tolerance", which is the default
        where a tolerance is given.
    iterations: of each step; 0: as many as the tolerance needs.
    max_iterations: of a step, beyond which the simulation has diverged.
    loop_redundancy: share of the largest pivot, below which a row of rigid closed loops is dropped.
    """
    return _given(locals())


def limits(*, deflection=None, energy_growth=None, on_energy_growth=None, step_error=None,
           momentum=None):
    """Beyond which results are doubted.

    deflection: of a body in its frame, by its length; 0: none.
    energy_growth: by the largest energy so far; 0: none.
    on_energy_growth: "warn" or "stop".
    step_error: estimated error of a step, by a radian or the length of a body; 0: none.
    momentum: residual of a free model, by its largest momentum; 0: none.
    """
    return _given(locals())


def output(*, interval):
    """Rows of a result.

    interval: between them [s]; 0: every step.
    """
    return _given(locals())


def sensor(*, quantity, name=None, blade=None, position=None, joint=None, loop=None,
           frame=None, **more):
    """What is measured besides the sensors that every simulation has. In space: subsystem and body
    by name; on a solid interface, by name, or node, by its number in the mesh's file.

    quantity: "displacement", "velocity", "acceleration", "section_force", "joint_reaction",
        "hub_reaction", "momentum", "blade_momentum", "kinetic_energy", "loop_reaction",
        "loop_opening", or of a solid "interface_force" or "von_mises".
    name: in the names of the result's arrays.
    blade: number from 1, or "all".
    position: distance from the root [m]; None: the tip.
    joint: number from 1 at the root.
    loop: name of a closed loop.
    frame: "hub", "blade", "inertial", "section" or "loop".
    """
    return _given(locals())
