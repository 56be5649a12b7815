"""Tables of a scenario as functions with named arguments.

    from spoke import model

    scenario = model.scenario(
        hub=model.hub(drive=spoke.SpinUp(speed=4.0, ramp=15.0)),
        blade=model.blade(count=3, length=8.0, density=2766.67, area=7.299e-5,
                          second_moment=8.214e-9, youngs_modulus=6.895e10),
        integration=model.integration(duration=20.0, step=0.005))
    sim = spoke.Simulation(scenario)

Each returns a dictionary of the keys that were given; what is left out has the default of
docs/scenario.md. Arguments are the keys of models in the plane and of those in space; where they
mean different things there, the second sentence is of space. All quantities are in SI units: m, kg,
s, N, Pa, rad. Vectors are sequences of two numbers, in space of three. Blades and joints count from
1 here, as in files.
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


def _given(arguments):
    """The table of what was given: of the arguments that are not None."""
    return {key.rstrip("_"): value for key, value in arguments.items() if value is not None}


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


# The functions below are written by write_model.py.

__all__ = [
    "aerodynamics",
    "air",
    "airfoil",
    "anchor",
    "anchor_motion",
    "axle",
    "blade",
    "blade_aerodynamics",
    "body",
    "body_drag",
    "coupled_joint",
    "coupling",
    "course",
    "damping",
    "distributed_load",
    "drag",
    "event",
    "event_pitch",
    "event_yaw",
    "friction",
    "gravity",
    "gust",
    "hub",
    "hub_load",
    "iec_wind",
    "initial",
    "integration",
    "interface",
    "joint",
    "joint_motion",
    "library_control",
    "library_record",
    "limits",
    "load",
    "loop",
    "material",
    "mount",
    "output",
    "pitch_control",
    "place",
    "point_mass",
    "polar",
    "program_control",
    "relaxation",
    "rotor",
    "scenario",
    "sections",
    "sensor",
    "statistics",
    "stop",
    "subsystem",
    "support",
    "suspension",
    "turbine_control",
    "turbulence",
    "wind",
]


def scenario(*, integration, title=None, world=None, hub=None, anchor=None, blade=None, blades=None,
             subsystem=None, support=None, rotor=None, gravity=None, damping=None, load=None,
             distributed_load=None, drag=None, hub_load=None, control=None, event=None,
             initial=None, limits=None, output=None, sensor=None, air=None, wind=None,
             aerodynamics=None, airfoil=None, statistics=None):
    """A whole scenario, for spoke.Simulation and spoke.read_scenario().

    title: text printed and written to the results
    world: "plane", or "space": a model in space
    hub: the hub in the middle
    anchor: places that move, for loops to close on
    blade: blades, all alike
    blades: blades one by one
    subsystem: in space: trees of bodies
    support: in space: what carries the axle
    rotor: in space: several rotors on a support
    gravity: gravity
    damping: damping of all bodies
    load: forces and moments at a point
    distributed_load: forces and moments per length
    drag: in the plane: drag
    hub_load: forces and torques on the hub
    control: in space: control of pitch, a library, or a controller of the program's
    event: in space: what happens once
    initial: where the simulation starts
    integration: how the motion is integrated, and for how long
    limits: limits of the results
    output: how often results are written
    sensor: what is measured besides
    air: in space: air
    wind: in space: wind
    aerodynamics: in space: induction, inflow, stall
    airfoil: in space: polars
    statistics: exponents of damage
    """
    return _given(locals())


def hub(*, support=None, radius=None, inertia=None, mass=None, drive=None, axis=None, center=None,
        mount=None, suspension=None, velocity=None, angular_velocity=None):
    """The hub.

    support: "axle": rotates about a fixed point; "free": moves in the plane; or: "axle": turns
        about its axis, its origin at rest, moved by the mount, or carried by a support; "free":
        moves in space
    radius: distance of the blade roots from the hub's axis [m]; or: from the hub's origin to the
        blades' roots, along the blades [m]
    inertia: moment of inertia about the hub's axis, without blades [kg m^2]; or: about the centre
        of mass: [xx, yy, zz], or [xx, yy, zz, xy, xz, yz], the entries of the tensor (xy = −∫ρ x y
        dV); or one number, about every axis [kg m^2]
    mass: mass of the hub, without blades; matters only if the hub is free [kg]; or: mass of the hub
        [kg]
    drive: what turns the hub, next table; or: what turns the hub about its axis, as in the plane
    axis: [x, y, z], of any length: of the drive, and the one that the blades stand around
    center: [x, y, z], centre of mass in the hub's frame [m]
    mount: motion of what holds the axle
    suspension: springs under the axle
    velocity: of a free hub at t = 0 [m/s]
    angular_velocity: of a free hub at t = 0 [rad/s]
    """
    if type(drive) in _DRIVES:
        drive = _DRIVES[type(drive)](drive)
    return _given(locals())


def mount(*, translation=None, rotation=None):
    """The motion of what holds the hub's axle, in space.

    translation: a table, see below [m, inertial frame]
    rotation: likewise, of the rotation vector [rad, inertial frame]
    """
    return _given(locals())


def suspension(*, stiffness, mass, inertia, damping=None, center=None):
    """Springs and dampers under the hub's axle, in space.

    stiffness: array of six numbers: along x, y, z, about x, y, z [N/m, N m/rad]
    damping: likewise [N s/m, N m s/rad]
    mass: of what stands on the springs beside the rotor: the bearing, the pylon [kg]
    center: its centre of mass, from the hub's origin [m]
    inertia: about this centre, as of the hub [kg m^2]
    """
    return _given(locals())


def course(*, time=None, x=None, y=None, z=None, value=None, constant=None, rate=None,
           amplitude=None, frequency=None, phase=None):
    """A motion over time, of a mount or an anchor.

    time: array of times, each greater than the one before [s]
    x: array of values along x, one for each of time
    y: array of values along y, one for each of time
    z: array of values along z, one for each of time
    value: in the plane: array of angles, one for each of time
    constant: a vector; of a rotation in the plane a number
    rate: likewise, per second
    amplitude: likewise, of a harmonic motion
    frequency: of the harmonic motion [rad/s]
    phase: of the harmonic motion [rad]
    """
    return _given(locals())


def blade(*, length=None, bodies=None, elements=None, density=None, area=None, second_moment=None,
          youngs_modulus=None, geometric_stiffening=None, reference_frame=None, strain=None,
          azimuth=None, sections=None, point_mass=None, loop=None, count=None, precone=None,
          joint=None, coupling=None, aerodynamics=None):
    """All blades alike, or one of several.

    length: from root to tip [m]
    bodies: flexible bodies along the blade
    elements: finite elements per body
    density: mass density [kg/m^3]
    area: area of the cross section [m^2]
    second_moment: second moment of area for bending in the plane [m^4]
    youngs_modulus: Young's modulus [Pa]
    geometric_stiffening: whether bending within a body is stiffened by tension, of rotation,
        gravity, loads and the motion of the hub, and made softer by compression; without it only
        the joints between bodies feel that tension
    reference_frame: where a body's floating frame sits: "clamped" tangent to its inboard end,
        "chord" through both ends
    strain: how strains follow from displacements. "nonlinear": to second order, so that a body
        feels tension and moments on its deformed shape, whatever makes them (formulation.md); one
        body of eight elements does what four of four did. "linear": tension is that of the
        undeformed blade, by rotation, gravity, loads and the motion of the hub
        (geometric_stiffening), in less time. "automatic": "nonlinear" with closed loops, whose
        tension linear strains do not know, otherwise "linear"; or: how strains follow from
        displacements. "nonlinear": to second order, so that the beam feels tension, bending moments
        and torque on its deformed shape, whatever makes them (formulation.md); one body of eight
        elements does what four of four did. "linear": tension is that of the undeformed tree, by
        rotation of the hub, gravity and loads (geometric_stiffening): for blades on a hub that
        turns them: a step of the same bodies then takes a third of the time or less, beside one
        body of eight elements two thirds to a third. "automatic": "linear" where the drive turns
        the hub, nothing in the subsystem moves by a joint or is held by a loop, and the centres of
        its sections lie at its axis; otherwise "nonlinear". spoke check says which. Where "linear"
        is given and misses tension, there is a warning
    azimuth: direction of the first blade in the hub's frame, from its x axis counterclockwise [rad]
    sections: properties that change along the blade, below; or: what the blade is made of, next
        table
    point_mass: masses that the blade carries, below
    loop: closed loops, below; or: closed loops of the blade, below
    count: number of blades, spaced evenly around the hub
    precone: angle by which the blade leaves the plane of rotation, its tip towards the axis'
        direction [rad]
    joint: joints of the blade, below
    coupling: couplings of its joints
    aerodynamics: chords and aerofoils, on which air acts
    """
    return _given(locals())


def sections(*, mass_per_length, axial_stiffness, station=None, bending_stiffness=None,
             flap_stiffness=None, lag_stiffness=None, torsion_stiffness=None,
             flap_shear_stiffness=None, lag_shear_stiffness=None, flap_inertia=None,
             lag_inertia=None, mass_center=None, tension_center=None, shear_center=None,
             stiffness_6x6=None, mass_6x6=None, matrix_convention=None, twist=None, sweep=None,
             prebend=None, chord=None, thickness=None):
    """Properties along a blade or a beam: sequences of equal length, linear in between.

    station: distances from the root, each greater than the one before; the first 0, the last length
        [m]; or: each greater than the one before; the first 0, the last length [m]
    mass_per_length: ρA [kg/m]; or: per length of the axis, as all that follows [kg/m]
    axial_stiffness: EA [N]
    bending_stiffness: EI, for bending in the plane [N m^2]
    flap_stiffness: ∫ E z² dA about the tension centre [N m^2]
    lag_stiffness: ∫ E y² dA about the tension centre [N m^2]
    torsion_stiffness: GJ [N m^2]
    flap_shear_stiffness: GA along z, with the factor of the section's shape [N]
    lag_shear_stiffness: likewise, along y [N]
    flap_inertia: ∫ ρ z² dA about the mass centre [kg m]
    lag_inertia: ∫ ρ y² dA about the mass centre [kg m]
    mass_center: arrays [y, z] [m]
    tension_center: where an axial force bends nothing: arrays [y, z] [m]
    shear_center: where a shear force twists nothing: arrays [y, z] [m]
    stiffness_6x6: in place of all stiffnesses, tension_center and shear_center: for each station an
        array of 36 numbers, row by row, or of the 21 of the upper triangle [N, N m, N m²]
    mass_6x6: in place of mass_per_length, mass_center and the inertias: likewise [kg/m, kg, kg m]
    matrix_convention: "spoke" or "beamdyn": the axes of both matrices
    twist: rotation of the section about +x [rad]
    sweep: y coordinate of the axis [m]
    prebend: z coordinate of the axis [m]
    chord: size of the section along its y, to be shown [m]
    thickness: size of the section along its z, to be shown [m]
    """
    return _given(locals())


def point_mass(*, position, mass, inertia=None, offset=None):
    """A mass on a blade or a beam.

    position: distance from the root [m]; or: station [m]
    mass: its mass [kg]
    inertia: its moment of inertia about its centre, for rotation in the plane; with
        geometric_stiffening = false it feels, wrongly, a moment of ω² inertia times the angle that
        the section turns [kg m^2]; or: about its centre, in the beam's axes, as of the hub [kg m^2]
    offset: [x, y, z] of its centre from the axis, in the beam's frame [m]
    """
    return _given(locals())


def joint(*, kind, name=None, axis=None, axes=None, offset=None, orientation=None, stiffness=None,
          damping=None, free=None, rest=None, relaxation=None, stop=None, friction=None,
          initial=None, initial_speed=None, hold=None, torque=None, force=None, motion=None,
          station=None, parent=None, child=None, node=None, interface=None):
    """A joint of a blade, at a station, or of a subsystem, from parent to child.

    name: of the joint
    kind: next table
    axis: [x, y, z], of any length, in the joint's frame
    axes: two of these, of a universal joint
    offset: of the joint's frame in the parent's [m]
    orientation: rotation vector of the joint's frame in the parent's [rad]
    stiffness: of a spring [N m/rad, N/m]
    damping: of a damper [N m s/rad, N s/m]
    free: of a bushing: directions that move without a spring and a damper, of "x", "y", "z", "about
        x", "about y" and "about z"
    rest: coordinate at which the spring is at rest [rad, m]
    relaxation: a spring and a damper in series: a table, below
    stop: a table, below
    friction: a table, below
    initial: coordinate at t = 0 [rad, m]
    initial_speed: its rate at t = 0 [rad/s, m/s]
    hold: whether both stay as they are given where loops are closed at the start
    torque: that acts on the child, and against the parent: a number, or a table with time and value
        [N m]
    force: likewise, along a prismatic or cylindrical joint's axis [N]
    motion: a table, below: the coordinate is prescribed, and none of the keys from stiffness to
        friction may be given for it
    station: where it is [m]; or: on a parent that is a beam [m]
    parent: name of a body, or "hub", which may have several children
    child: name of a body: a beam is joined at its root, a rigid body at the origin of its frame, a
        solid at its first interface
    node: in place of station: number of a node, from 0 at the root to bodies · elements at the tip,
        of equal elements
    interface: in place of station, on a parent that is a solid: name of one of its interfaces
    """
    return _given(locals())


def relaxation(*, stiffness=None, time=None):
    """A spring and a damper in series on a joint.

    stiffness: of the spring [N m/rad, N/m]
    time: in which the force of a spring that is held falls to 1/e: the damper's constant by
        stiffness [s]
    """
    return _given(locals())


def stop(*, lower=None, upper=None, stiffness=None, damping=None, width=None):
    """A stop of a joint.

    lower: bound below which it sets in [rad, m]
    upper: bound above which it sets in [rad, m]
    stiffness: beyond width; both bounds have it [N m/rad, N/m]
    damping: of a damper that sets in by the same law [N m s/rad, N s/m]
    width: distance over which it sets in [rad, m]
    """
    return _given(locals())


def joint_motion(*, constant=None, time=None, value=None, mean=None, cosine=None, sine=None,
                 by=None, initial=None):
    """The prescribed motion of a joint.

    constant: this value [rad, m]
    time: array of times, each greater than the one before [s]
    value: array of values, one for each of time [rad, m]
    mean: of a pitch by the azimuth: mean [rad, m]
    cosine: likewise: factor of the cosine of the azimuth [rad, m]
    sine: likewise: factor of its sine [rad, m]
    by: "program": the embedding program says what it is
    initial: value until the program says one [rad, m]
    """
    return _given(locals())


def loop(*, name, kind, from_, to, axis=None, length=None, stiffness=None, damping=None, speed=None,
         axes=None):
    """A closed loop: a cut joint between two places.

    name: unlike that of any other loop of the blade
    kind: the motion of from against to that is left, see below
    from_: a place on a body, see below
    to: another place
    axis: of a prismatic closure, in the frame of to: [x, y], of any length; or: [x, y, z], of any
        length, in the frame of to
    length: of a distance [m]
    stiffness: of springs in place of a rigid closure: a number for all directions that are locked,
        or an array with one number for each; 0: rigid [N/m, N m/rad]; or: of springs in place of a
        rigid closure: a number for all directions that are locked, or an array with one number for
        each; 0: rigid. Of a bearing also a matrix, [[kxx, kxy], [kyx, kyy]], see below [N/m, N
        m/rad]
    damping: of dampers beside these springs, likewise; a number is for the directions that have
        springs [N s/m, N m s/rad]; or: of dampers beside these springs, likewise; a number is for
        the directions that have springs. Of a bearing also a matrix, with or without one of
        stiffness [N s/m, N m s/rad]
    speed: of a bearing whose matrices depend on it, of from against to about axis: then stiffness
        and damping are arrays of matrices, one for each speed [rad/s]
    axes: two of these, of a universal closure, as they are at the start
    """
    return _given(locals())


def coupling(*, name, joints, stiffness=None, damping=None):
    """A linear relation of coordinates of joints: a gear, a rack, a belt.

    name: unlike that of any other coupling of the blade or subsystem
    joints: the coordinates that it couples: two tables or more, below
    stiffness: of a spring in place of the rigid relation: force by the sum of ratio times
        coordinate [N m/rad, N/m]
    damping: of a damper beside the spring [N m s/rad, N s/m]
    """
    return _given(locals())


def coupled_joint(*, joint, ratio, subsystem=None, blade=None, coordinate=None):
    """A coordinate of a joint in a coupling.

    joint: name of a joint of the blade or subsystem, free or prescribed; of a support also "axle",
        and "tail.axle" of a further rotor by the name "tail"
    subsystem: name of the subsystem whose joint it is, "support" among them, if not of that of the
        coupling; of one coordinate at least it is
    blade: in its place number of a blade, from 1, or "next": the next one of the rotor
    coordinate: number of its coordinate
    ratio: its factor in the sum; in all tables of a coupling of the same unit times coordinate [1,
        1/rad, 1/m]
    """
    return _given(locals())


def friction(*, force=None, speed=None, static=None, stribeck=None):
    """Friction on a joint's coordinate.

    force: of sliding [N m, N]
    speed: over which it sets in: force · tanh(v/speed) at the speed v [rad/s, m/s]
    static: at the start of sliding [N m, N]
    stribeck: speed over which the force falls from static to force [rad/s, m/s]
    """
    return _given(locals())


def place(*, body=None, anchor=None, station=None, point=None, orientation=None, blade=None,
          subsystem=None, interface=None):
    """A place of a closed loop.

    body: "hub" or "mount"; without it, the place is on the blade; or: name of a body of the
        subsystem; "hub" or "mount"
    anchor: name of an anchor, in place of body
    station: distance from the root, where a body ends [m]; or: on a beam, anywhere: it makes a node
        there. Where a joint of a blade is, the place is on the part outboard [m]
    point: [x, y] in the frame of the hub, the mount or the anchor; on a blade from its axis at the
        station, x along the blade, and turning with the section. Without station its x is the
        station [m]; or: in the frame of a rigid body, the hub, the mount or the anchor. On a beam
        from its axis at the station, in the beam's axes, which turn with the section; without
        station its x is the station. On a solid from the point of the interface, in the axes of the
        mesh, which turn with it [m]
    orientation: of the place's frame against what carries it [rad]; or: rotation vector, in these
        axes [rad]
    blade: of to: the place is on another blade, by its number from 1; "next": on the one that
        follows on this rotor, behind the last the first
    subsystem: of to: the place is on a body of another subsystem, by its name, or of the "support";
        "next": of the next one of a count
    interface: of a solid, in place of station: name of one of its interfaces
    """
    return _given(locals())


def anchor(*, name, frame=None, subsystem=None, station=None, interface=None, turns_with_hub=None,
           rotor=None, motion=None):
    """A frame whose motion is prescribed, for loops to close on.

    name: unlike that of any other anchor
    frame: in which it moves: "mount", in which the hub turns, or "hub"; on a support "axle", the
        hub's frame at angle 0, which moves with the body that carries the axle; in space also the
        name of a body: the frame of a rigid one, of a beam's section, or of a solid's interface
    subsystem: of a body: name of the subsystem whose it is, or "support"
    station: of a beam: where its section is; it makes a node there [m]
    interface: of a solid: name of one of its interfaces
    turns_with_hub: whether it turns with the hub besides, by the hub's angle about its own axis,
        which its motion tilts and moves: the rotating part of a swashplate
    rotor: in space, name of the rotor whose hub or axle the frame is of
    motion: a table, see below
    """
    return _given(locals())


def anchor_motion(*, by=None, translation=None, rotation=None):
    """The motion of an anchor.

    by: "program": the embedding program moves it; translation and rotation are then [x, y] and a
        number, where it is until the program says so
    translation: a table: constant + rate · t + amplitude · sin(frequency · t + phase), with
        constant, rate (per second) and amplitude as [x, y], frequency (rad/s) and phase (rad); or
        time and arrays x, y [m]
    rotation: likewise, with numbers in place of [x, y], or time and the array value [rad]
    """
    return _given(locals())


def subsystem(*, name, azimuth=None, rotor=None, count=None, body=None, joint=None, loop=None,
              coupling=None):
    """A tree of bodies on the hub, in space.

    name: its name
    azimuth: angle about the hub's axis by which its joints on the hub are turned, and what its
        loops have on the hub, the mount and anchors; added to the hub's angle in motion by the
        azimuth [rad]
    rotor: name of the rotor whose hub carries it
    count: number of copies around the hub, the first at azimuth, evenly spaced: NAME1, NAME2, ... A
        load or a sensor on the subsystem NAME is on all of them
    body: its bodies: beams, rigid bodies and solids
    joint: its joints, one for each body
    loop: its closed loops
    coupling: couplings of its joints
    """
    return _given(locals())


def body(*, name, kind, length=None, bodies=None, elements=None, sections=None,
         reference_frame=None, geometric_stiffening=None, strain=None, point_mass=None, drag=None,
         mass=None, center=None, spin=None, inertia=None, mesh=None, material=None, scale=None,
         coordinates=None, modes=None, up_to=None, damping=None, interface=None, format=None,
         stiffness=None, nodes=None, geometric_stiffness=None):
    """A body of a tree: a beam, a rigid body or a solid.

    length: from root to tip [m]
    bodies: flexible bodies along the blade
    elements: finite elements per body
    sections: what the blade is made of, next table
    reference_frame: where a body's floating frame sits: "clamped" tangent to its inboard end,
        "chord" through both ends; or: "clamped": the frame is that of the first interface;
        "mean_axis": deformation has neither momentum nor moment of momentum, for a body that flies
        by itself
    geometric_stiffening: whether bending within a body is stiffened by tension, of rotation,
        gravity, loads and the motion of the hub, and made softer by compression; without it only
        the joints between bodies feel that tension; or: whether tension stiffens it
    strain: how strains follow from displacements. "nonlinear": to second order, so that the beam
        feels tension, bending moments and torque on its deformed shape, whatever makes them
        (formulation.md); one body of eight elements does what four of four did. "linear": tension
        is that of the undeformed tree, by rotation of the hub, gravity and loads
        (geometric_stiffening): for blades on a hub that turns them: a step of the same bodies then
        takes a third of the time or less, beside one body of eight elements two thirds to a third.
        "automatic": "linear" where the drive turns the hub, nothing in the subsystem moves by a
        joint or is held by a loop, and the centres of its sections lie at its axis; otherwise
        "nonlinear". spoke check says which. Where "linear" is given and misses tension, there is a
        warning
    point_mass: masses that the blade carries, below
    name: unlike that of any other of the subsystem, and not "hub"
    kind: "beam", "rigid" or "solid", below
    drag: drag in the wind, of a beam or a rigid body
    mass: of a rigid body [kg]; or: file of the mass matrix
    center: of a rigid body: centre of mass in the body's frame [m]
    spin: of a rigid body: angular momentum of what spins inside it (a wheel, a propeller), relative
        to the body, which a motor keeps; mass and inertia are those of all [kg m^2/s]
    inertia: of a rigid body: about its centre of mass, as of the hub [kg m^2]
    mesh: file, relative to the scenario's folder: gmsh .msh 2.2 or 4.1, Abaqus or CalculiX .inp; of
        tetrahedra with 10 nodes or hexahedra with 20 (those with 4 and 8 are too stiff, and warned
        of)
    material: a table with youngs_modulus, poissons_ratio and density [Pa, -, kg/m³]
    scale: { length = 1e-3 }: metres by the unit of length in the mesh, here mm. material, and all
        places in the scenario, are in SI always
    coordinates: "reduced": modes of vibration and of the interfaces; "nodal": the displacements of
        all nodes, for small meshes and as a check
    modes: number of vibration modes, with the interfaces held
    up_to: in place of modes: all below this frequency [Hz]
    damping: damping ratio of every mode, or an array with one for each mode. [damping] adds to it
    interface: interfaces, one or more
    format: of matrices in place of a mesh: the program that wrote them
    stiffness: file of the stiffness matrix
    nodes: file of the nodes' places
    geometric_stiffness: files of its geometric stiffness
    """
    return _given(locals())


def material(*, youngs_modulus, poissons_ratio, density):
    """The material of a solid.

    youngs_modulus: Young's modulus [Pa]
    poissons_ratio: Poisson's ratio
    density: mass density [kg/m^3]
    """
    return _given(locals())


def interface(*, name, nodes, kind=None, point=None):
    """An interface of a solid.

    name: unlike that of any other interface of the body
    nodes: its nodes, see below
    kind: "rigid": they move as a rigid body; "average": the interface follows their mean and does
        not stiffen them
    point: where joints and loads act, in the axes of the mesh: [x, y, z] [m]
    """
    return _given(locals())


def support(*, from_=None, mass=None, center=None, inertia=None, position=None, attitude=None,
            velocity=None, angular_velocity=None, body=None, joint=None, loop=None, coupling=None,
            axle=None):
    """What carries the hub's axle, in space.

    from_: "ground": the tree stands on the inertial frame, or on the mount that moves in it;
        "free": on a fuselage, a rigid body that is free in space
    mass: of the fuselage; this and the keys below belong to from = "free" [kg]
    center: its centre of mass, in its frame [m]
    inertia: about its centre of mass, as of the hub [kg m^2]
    position: of its origin at t = 0, inertial frame [m]
    attitude: rotation vector of its frame at t = 0 [rad]
    velocity: of its origin at t = 0, inertial frame [m/s]
    angular_velocity: at t = 0, in its frame [rad/s]
    body: its bodies: beams, rigid bodies and solids
    joint: its joints, one for each body
    loop: its closed loops
    coupling: couplings of its joints
    axle: where the tree carries the hub: [support.axle]
    """
    return _given(locals())


def rotor(*, name, hub, axle=None, blade=None, blades=None):
    """One of several rotors on a support: a hub on its own axle, and blades.

    name: its name, unlike that of any other rotor
    hub: its hub and drive, as [hub]
    axle: what carries it, as [support.axle]; with subsystem, a body of another rotor's
    blade: its blades, as [blade]
    blades: its blades one by one, as [[blades]]
    """
    return _given(locals())


def axle(*, subsystem=None, blade=None, body=None, station=None, node=None, interface=None,
         offset=None, orientation=None, stiffness=None, damping=None, gear_ratio=None,
         generator_inertia=None):
    """Where a support carries the hub.

    subsystem: of a rotor that is not the first: name of the subsystem whose body carries the axle,
        one on the hub of a rotor before this
    blade: in place of subsystem and body: number, among those of all rotors, of the blade that
        carries the axle, one of a rotor before this
    body: name of the body that carries the axle; a fuselage is named "fuselage"
    station: the place on a beam; it may be anywhere, and makes a node there [m]
    node: in place of station: number of a node, as of a joint's parent
    interface: the place on a solid: name of one of its interfaces
    offset: of the hub's frame in that of the carrier at this place [m]
    orientation: rotation vector of the hub's frame, at a hub angle of 0, in the same frame [rad]
    stiffness: of the shaft between hub and gearbox, on the hub's side; this and the keys below
        belong to a drive train [N m/rad]
    damping: of the shaft, likewise [N m s/rad]
    gear_ratio: turns of the generator for one of the hub, less than 0 if it turns the other way
    generator_inertia: of what turns behind the gearbox, about its axis, at its own speed [kg m^2]
    """
    return _given(locals())


def gravity(*, acceleration=None, ramp=None):
    """Gravity.

    acceleration: [x, y] in the inertial frame [m/s^2]; or: [x, y, z] in the inertial frame [m/s^2]
    ramp: its rise; 0: all of it from the start [s]
    """
    return _given(locals())


def damping(*, mass_factor=None, stiffness_factor=None, flap=None, lag=None, axial=None,
            torsion=None, flap_shear=None, lag_shear=None, mu=None, ratios=None, above=None):
    """Damping of the deformation of bodies.

    mass_factor: factor of the mass matrix of the deformation coordinates [1/s]
    stiffness_factor: factor of the stiffness matrix [s]
    flap: factor of the stiffness by direction; in space: bending along the section's z [s]
    lag: likewise: bending along the section's y; in the plane lag is all of it [s]
    axial: likewise: stretch [s]
    torsion: in space: twist [s]
    flap_shear: in space: shear along z [s]
    lag_shear: in space: shear along y [s]
    mu: in space, in place of these six: BeamDyn's μ1 to μ6, which are flap_shear, lag_shear, axial,
        lag, flap, torsion [s]
    ratios: damping ratios of the lowest modes of each beam, from the lowest frequency on
    above: damping ratio of the next mode; those above it have more, in proportion to their
        frequency
    """
    return _given(locals())


def load(*, position=None, frame=None, force=None, moment=None, blade=None, name=None, ramp=None,
         time=None, factor=None, subsystem=None, body=None, point=None, interface=None, nodes=None,
         traction=None):
    """A force and a moment at a point of a body.

    position: distance from the blade's root [m]; or: on a beam: distance from the root [m]
    frame: in which the force is resolved: "inertial", "hub", or "section", which turns with the
        loaded cross section; or: "inertial", "hub", "body" (turns with the body's frame) or, on
        beams and solids, "section" (turns with the loaded section, interface or nodes): the frame
        in which forces and moments are resolved
    force: [x, y] [N]; or: [x, y, z] [N]
    moment: about z, counterclockwise [N m]; or: [x, y, z] [N m]
    blade: number of the blade, from 1, or "all"; or: number of the blade, or "all"
    name: name by which spoke critical varies the load; loads of one name go together
    ramp: the load rises from 0 at t = 0 to its full size at t = ramp; 0: all of it from the start
        [s]
    time: array of times, each greater than the one before [s]
    factor: array of factors of the load, one for each of time, interpolated as above
    subsystem: name of the subsystem that it is on, in place of blade; of a support "support"
    body: name of its body
    point: on a rigid body: [x, y, z] in its frame [m]
    interface: on a solid: name of the interface at whose point it acts
    nodes: on a solid, in place of interface: nodes over which the load is spread, by area, chosen
        as those of an interface; a moment is about their mean
    traction: on a solid, in place of force and moment: force per area of nodes, or of an interface,
        as they are at rest [Pa]
    """
    return _given(locals())


def distributed_load(*, from_=None, to=None, frame=None, force_per_length=None,
                     moment_per_length=None, blade=None, name=None, ramp=None, time=None,
                     factor=None, subsystem=None, body=None):
    """A force and a moment per length of a beam.

    from_: distance of the inner end from the blade's root [m]; or: distance of the inner end from
        the beam's root [m]
    to: distance of the outer end [m]
    frame: as of [[load]]
    force_per_length: [x, y] [N/m]; or: [x, y, z] [N/m]
    moment_per_length: about z, counterclockwise [N]; or: [x, y, z] [N]
    blade: number of the blade, from 1, or "all"; or: number of the blade, or "all"
    name: name by which spoke critical varies the load; loads of one name go together
    ramp: the load rises from 0 at t = 0 to its full size at t = ramp; 0: all of it from the start
        [s]
    time: array of times, each greater than the one before [s]
    factor: array of factors of the load, one for each of time, interpolated as above
    subsystem: name of the subsystem that it is on, in place of blade; of a support "support"
    body: name of its body
    """
    return _given(locals())


def drag(*, relative_to=None, position=None, linear=None, quadratic=None, from_=None, to=None,
         linear_per_length=None, quadratic_per_length=None, blade=None, name=None, ramp=None,
         time=None, factor=None):
    """A force against the motion of a blade, -(c1 + c2 |u|) u, in the plane.

    relative_to: of what u is the velocity: "inertial", u is the velocity in space; "hub", u is that
        less the velocity which the place would have if it were fixed to the hub, as in air that
        turns with the hub
    position: distance of the point from the blade's root; only with linear or quadratic [m]
    linear: c₁ at one point [N s/m]
    quadratic: c₂ at one point [N s^2/m^2]
    from_: distance of its inner end from the root; only with a coefficient per length [m]
    to: distance of its outer end; likewise [m]
    linear_per_length: c₁ per length [N s/m^2]
    quadratic_per_length: c₂ per length: of a strip with drag coefficient C, chord c and air of
        density ρ, ½ρcC [N s^2/m^3]
    blade: number of the blade, from 1, or "all"
    name: name by which spoke critical varies the load; loads of one name go together
    ramp: the load rises from 0 at t = 0 to its full size at t = ramp; 0: all of it from the start
        [s]
    time: array of times, each greater than the one before [s]
    factor: array of factors of the load, one for each of time, interpolated as above
    """
    return _given(locals())


def hub_load(*, name=None, position=None, frame=None, force=None, torque=None, ramp=None, time=None,
             factor=None, rotor=None):
    """A force and a torque on the hub.

    name: name by which spoke critical varies the load; loads of one name go together
    position: where the force acts: [x, y] in the hub's frame; only with force [m]; or: where the
        force acts: [x, y, z] in the hub's frame; only with force [m]
    frame: in which the force is resolved: "hub", a thruster, or "inertial"
    force: [x, y] [N]; or: [x, y, z] [N]
    torque: about z, besides that of the force [N m]; or: [x, y, z], besides that of the force [N m]
    ramp: the load rises from 0 at t = 0 to its full size at t = ramp; 0: all of it from the start
        [s]
    time: array of times, each greater than the one before [s]
    factor: array of factors of the load, one for each of time, interpolated as above
    rotor: name of the rotor on whose hub it acts
    """
    return _given(locals())


def pitch_control(*, speed, proportional, integral, minimum, maximum, joint=None, joints=None,
                  half_gain_angle=None, schedule=None, rate=None, filter=None, initial=None,
                  sign=None, period=None):
    """A controller of pitch, in space: control={"pitch": pitch_control(...)}.

    joint: name of the joint, of every blade or subsystem on the hub that has one of this name
    joints: in place of joint: an array of names
    speed: set point of the hub's speed about its axle; negative where the rotor turns so [rad/s]
    proportional: pitch angle by the error of the speed [s]
    integral: rate of the pitch angle by the error, that is pitch angle by the integral of the error
        [rad/rad]
    half_gain_angle: gains have the factor 1/(1 + θ/half_gain_angle) [rad]
    schedule: in place of it: a table with angle (rad, increasing) and factor, a smooth curve
        through them, constant beyond
    minimum: lower limit of the pitch angle θ [rad]
    maximum: its upper limit [rad]
    rate: largest rate of θ [rad/s]
    filter: corner frequency of the low-pass on the speed [rad/s]
    initial: θ at t = 0, where the integral begins, too [rad]
    sign: 1 or −1: the joint's coordinate is its own motion + sign θ
    period: time between samples, in steps to the nearest whole number from 1 on [s]
    """
    return _given(locals())


def library_control(*, file, input=None, name=None, gear_ratio=None, individual_pitch=None,
                    efficiency=None, record=None, joint=None, joints=None, initial=None, sign=None,
                    yaw_joint=None, direction=None, brake_torque=None, brake_speed=None,
                    period=None):
    """A controller of Bladed's kind: control={"library": library_control(...)}.

    file: the library, by a path from the scenario's folder
    input: accINFILE, the file that the library reads, by a path from the scenario's folder
    name: avcOUTNAME, with which the names of files begin that it writes
    gear_ratio: turns of the generator for one of the hub
    individual_pitch: whether it demands the pitch of each blade by itself
    efficiency: electrical power by that of the generator's shaft
    record: numbers of its array that sensors give
    joint: name of the pitch joint, of every blade or subsystem on the hub that has one of this name
    joints: in place of joint: an array of names
    initial: pitch angle θ at t = 0 [rad]
    sign: 1 or −1: the joint's coordinate is its own motion + sign θ
    yaw_joint: name of the joint of the support that follows the demanded rate of yaw
    direction: sense in which the rotor turns about its axis: speeds, azimuths and torques count
        along it
    brake_torque: of the shaft brake that is on, on the hub's side [N m]
    brake_speed: of the hub, from which on the brake has that torque [rad/s]
    period: time between samples, in steps to the nearest whole number from 1 on [s]
    """
    return _given(locals())


def library_record(*, number, sensor, factor=None):
    """A number of a library that a sensor gives.

    number: in avrSWAP, from 1
    sensor: name of a column of sensors.csv
    factor: number by value of the sensor
    """
    return _given(locals())


def program_control(*, joint=None, joints=None, initial=None, sign=None, yaw_joint=None,
                    direction=None, brake_torque=None, brake_speed=None, period=None):
    """What a controller of the program may move: control={"program": program_control(...)}.

    joint: name of the pitch joint, of every blade or subsystem on the hub that has one of this name
    joints: in place of joint: an array of names
    initial: pitch angle θ at t = 0 [rad]
    sign: 1 or −1: the joint's coordinate is its own motion + sign θ
    yaw_joint: name of the joint of the support that follows the demanded rate of yaw
    direction: sense in which the rotor turns about its axis: speeds, azimuths and torques count
        along it
    brake_torque: of the shaft brake that is on, on the hub's side [N m]
    brake_speed: of the hub, from which on the brake has that torque [rad/s]
    period: time between samples, in steps to the nearest whole number from 1 on [s]
    """
    return _given(locals())


def turbine_control(*, joint=None, joints=None, initial=None, sign=None, yaw_joint=None,
                    direction=None, brake_torque=None, brake_speed=None, period=None, filter=None,
                    torque=None, pitch=None, schedule=None, smoothing=None, individual=None,
                    actuator=None, yaw=None):
    """What events move without a controller: control={"turbine": turbine_control(...)}.

    joint: name of the pitch joint, of every blade or subsystem on the hub that has one of this name
    joints: in place of joint: an array of names
    initial: pitch angle θ at t = 0 [rad]
    sign: 1 or −1: the joint's coordinate is its own motion + sign θ
    yaw_joint: name of the joint of the support that follows the demanded rate of yaw
    direction: sense in which the rotor turns about its axis: speeds, azimuths and torques count
        along it
    brake_torque: of the shaft brake that is on, on the hub's side [N m]
    brake_speed: of the hub, from which on the brake has that torque [rad/s]
    period: time between samples, in steps to the nearest whole number from 1 on [s]
    filter: low-pass on the measured speed
    torque: of the generator
    pitch: collective
    schedule: least pitch by the wind
    smoothing: of both set points at rated
    individual: pitch of each blade by its moment
    actuator: what moves a blade
    yaw: of the nacelle
    """
    return _given(locals())


def event(*, name=None, at=None, when=None, delay=None, generator=None, brake=None,
          brake_speed=None, controller=None, pitch=None, yaw=None):
    """What happens once: a fault, a stop, in space.

    name: as the summary and the plots call it
    at: time at which it happens [s]
    when: in place of at: a column of sensors.csv, > or <, and a number in its unit, as "hub.speed >
        1.4"
    delay: time from then to what it does, in steps, rounded up [s]
    generator: "off": the drive has no torque from then on
    brake: torque of a shaft brake, on the hub's side of a gearbox [N m]
    brake_speed: from which on the brake has that torque [rad/s]
    controller: "off": no controller moves anything from then on
    pitch: turns blades, a table of the keys below
    yaw: turns the yaw joint of a controller, likewise
    """
    return _given(locals())


def event_pitch(*, to=None, rate=None, blades=None):
    """How an event turns blades.

    to: angle to which the demand goes [rad]
    rate: at which it goes there [rad/s]
    blades: numbers of blades, from 1, subsystems on hubs behind blades
    """
    return _given(locals())


def event_yaw(*, to=None, rate=None):
    """How an event turns the yaw joint.

    to: angle to which the demand goes [rad]
    rate: at which it goes there [rad/s]
    """
    return _given(locals())


def air(*, density=None, viscosity=None, sound_speed=None):
    """Air around the blades, in space.

    density: of the air [kg/m^3]
    viscosity: kinematic, for the Reynolds numbers by which polars are chosen [m^2/s]
    sound_speed: for the Mach numbers by which polars are chosen [m/s]
    """
    return _given(locals())


def wind(*, velocity=None, time=None, speed=None, file=None, shear_exponent=None,
         vertical_shear=None, horizontal_shear=None, reference_height=None, up=None, ground=None,
         gust=None, turbulence=None, iec=None, by=None):
    """Wind before a rotor disturbs it, in space.

    velocity: mean velocity at the reference height, in the inertial frame. Where speed or file
        gives the speed, only its direction counts, +x if it is zero [m/s]
    time: array of times of speed, each greater than the one before [s]
    speed: the speed over time along that direction, by monotone cubics; constant before and after
        [m/s]
    file: a file of TurbSim (.bts) or a table, relative to the scenario; in place of speed and
        turbulence
    shear_exponent: exponent of the power law, 0 to 1
    vertical_shear: linear shear: share of the speed at the reference height by which it grows on a
        metre upwards [1/m]
    horizontal_shear: likewise across the wind, to the left for who looks along it, from the origin
        on [1/m]
    reference_height: height over the ground at which velocity is; shear and turbulence need it [m]
    up: direction away from the ground
    ground: coordinate of the ground along up [m]
    gust: table, or several: see gusts
    turbulence: table, see turbulence
    iec: table, see conditions of IEC 61400-1
    by: "program": the embedding program gives the wind, and no other key is there
    """
    return _given(locals())


def gust(*, amplitude, start=None, duration=None, shape=None, of=None):
    """A gust of the wind.

    amplitude: A of the shape, in the unit of what it changes; may be negative
    start: [s]
    duration: T of the shape [s]
    shape: "one_minus_cosine", "operating" or "rise"
    of: what it changes: "speed" (m/s), "direction" (rad), "vertical_shear" or "horizontal_shear"
        (1/m)
    """
    return _given(locals())


def iec_wind(*, class_, case, speed=None, start=None, sign=None, direction=None, period=None,
             turbulent=None, seed=None, rotor_diameter=None):
    """A wind condition of IEC 61400-1.

    class_: of the turbine, by reference speed and turbulence
    case: the wind condition
    speed: mean speed at the hub; of "EWM" the class has it [m/s]
    start: when "EOG", "EDC", "ECD" or "EWS" begins [s]
    sign: 1 or −1: of "EDC", "ECD" and "EWS"
    direction: of "EWS"
    period: years in which "EWM" recurs once, 1 or 50
    turbulent: "EWM" by its turbulent model, not the steady one
    seed: of turbulence
    rotor_diameter: of gusts, shear and the box of turbulence [m]
    """
    return _given(locals())


def turbulence(*, intensity=None, seed=None, spectrum=None, length_scale=None, deviation_ratio=None,
               scale=None, coherence=None, coherence_decay=None, width=None, height=None,
               points=None, time_step=None, duration=None):
    """Turbulence of the wind.

    intensity: standard deviation along the wind at the reference height, over the speed there
    seed: a whole number; equal seeds give equal turbulence
    spectrum: the only one
    length_scale: Lambda_1, see below [m]
    deviation_ratio: standard deviations along the wind, across it and upwards over the first
    scale: of the velocities: to the standard deviations asked for at the "centre" of the box;
        "none": as the spectrum has them
    coherence: components that are coherent: that along the wind, or "all"
    coherence_decay: in the exponent of coherence, 1 to 100
    width: of the box across the wind; wider than the rotor [m]
    height: of the box; its middle is at the reference height, and it must not reach below the
        ground [m]
    points: of the grid along each side, or [across, upwards]; 2 to 100
    time_step: [s]
    duration: after which it repeats, at least [s]
    """
    return _given(locals())


def aerodynamics(*, induction=None, high_thrust=None, mass_flow=None, inflow=None,
                 inflow_factor=None, attached_flow=None, stall=None):
    """How induction, inflow and stall are modelled, in space.

    induction: velocity that the rotor itself induces: "momentum", blade-element momentum theory by
        annuli, with losses at tip and root, high thrust, hover and descent, and skewed wakes;
        "none"
    high_thrust: thrust of a rotor that induces more than momentum theory holds for: "buhl";
        "glauert", his empirical curve; "hawc2", the polynomial of that program (aerodynamics.md)
    mass_flow: what carries air through a disc in yaw, tilt or forward flight: "glauert", all of its
        velocity; "normal", the part normal to the disc (aerodynamics.md)
    inflow: how induced velocity follows the load: "dynamic", with two time constants after Oye;
        "quasi_steady", at once
    inflow_factor: induced velocity by that of momentum theory. Hovering rotors induce more, since
        their wake contracts and its tip vortices pass near the blades: 1.1 to 1.2 are usual
        (aerodynamics.md). Of turbines it is 1
    attached_flow: how lift follows the angle of attack where flow is attached: "steady", at once;
        "unsteady", with the delay by the wake that the section sheds, by states (Wagner,
        Theodorsen), in runs
    stall: how separation follows the angle of attack: "dynamic", with a lag after Oye; "static", at
        once, lift is that of the polar
    """
    return _given(locals())


def blade_aerodynamics(*, station, chord, airfoil, twist=None, center=None, leading_edge=None):
    """Chords and aerofoils of a blade.

    station: distances from the root, ascending; 10 to 20 serve well. Beyond the first and the last
        there is no load, and the last is the tip of tip loss [m]
    chord: [m]
    twist: of the chord against the section's y axis, which has the twist of the sections already
        [rad]
    center: of the aerodynamic centre (of most polars the quarter of the chord): its distance from
        the blade's axis along the chord, positive towards the leading edge [m]
    airfoil: names of aerofoils, or files of polars, relative to the scenario
    leading_edge: "+y": the leading edge looks along the section's y axis, as on a rotor that turns
        about its axis in the positive sense; "-y": about it in the negative sense
    """
    return _given(locals())


def body_drag(*, station=None, diameter=None, coefficient=None, area=None, point=None,
              potential=None, shadow=None):
    """Drag of a beam or a rigid body in the wind.

    station: of a beam: distances from its root, ascending [m]
    diameter: of a beam: its width across the flow [m]
    coefficient: of a beam: of drag, by diameter
    area: of a rigid body: coefficient of drag times area, for flow along each axis of its frame
        [m^2]
    point: of a rigid body: where drag acts, in its frame [m]
    potential: of a beam of a support: the flow around it that blades meet, "none", "cylinder" or
        "bak"
    shadow: likewise, the deficit behind it, "none" or "powles"
    """
    return _given(locals())


def airfoil(*, name, file=None, polar=None, reynolds=None, mach=None, angle=None, lift=None,
            drag=None, moment=None):
    """An aerofoil.

    name: unlike that of any other
    file: relative to the scenario's folder: a plain table, a file of AeroDyn 15, or C81 (formats);
        **its angles are in degrees**
    polar: polars by Reynolds or Mach number, [[airfoil.polar]], with the keys below
    reynolds: Reynolds number of the polar, ascending from one to the next
    mach: in place of it: Mach number of the polar, ascending from one to the next
    angle: angles of attack, ascending; the first is −π, the last π [rad]
    lift: coefficient of lift, equal at both ends
    drag: of drag, likewise
    moment: about the aerodynamic centre, nose up
    """
    return _given(locals())


def polar(*, reynolds=None, mach=None, angle=None, lift=None, drag=None, moment=None):
    """Coefficients of an aerofoil at one Reynolds number.

    reynolds: Reynolds number of the polar, ascending from one to the next
    mach: in place of it: Mach number of the polar, ascending from one to the next
    angle: angles of attack, ascending; the first is −π, the last π [rad]
    lift: coefficient of lift, equal at both ends
    drag: of drag, likewise
    moment: about the aerodynamic centre, nose up
    """
    return _given(locals())


def initial(*, state=None, speed=None):
    """Where the simulation starts.

    state: "undeformed": joints at their initial, the hub with the speed of its drive at t = 0;
        "equilibrium": of steady rotation, as spoke static finds it
    speed: of the equilibrium: where the drive prescribes the rotation, its speed at its start, or
        after its ramp up; else any. Without it, the speed after the ramp up, initial_speed of a
        drive, or the part of angular_velocity of a free hub along its axis [rad/s]
    """
    return _given(locals())


def integration(*, duration, method=None, step=None, spectral_radius=None, tolerance=None,
                iterate_to=None, iterations=None, max_iterations=None, loop_redundancy=None):
    """How the motion is integrated.

    method: "generalized_alpha": implicit, for steps that suit the motion; "rk4": explicit, for
        steps below the stability limit, which spoke check prints
    step: time step; shortened if needed, so that it divides the duration [s]
    duration: simulated time [s]
    spectral_radius: spectral radius of generalized_alpha at infinite frequency: 1 damps no mode, 0
        damps the fast ones most
    tolerance: tolerance of the iteration within a step of generalized_alpha: largest change of a
        coordinate in the last iteration; with iterate_to = "error" the most that is left of a
        change, if it is not the default [m, rad]
    iterate_to: "error": the iteration goes on until what is left, by the contraction seen, is a
        small share of the step's own error, so that smaller steps have smaller errors down to
        round-off (formulation.md); "tolerance": until its last change is below tolerance
    iterations: number of iterations per step; 0: as many as the tolerance needs
    max_iterations: if a step needs more iterations than this, the simulation has diverged
    loop_redundancy: a row of rigid closed loops is redundant, and dropped, where its pivot at the
        start is below this share of the largest one
    """
    return _given(locals())


def limits(*, deflection=None, energy_growth=None, on_energy_growth=None, step_error=None,
           momentum=None):
    """Limits beyond which results are doubted.

    deflection: deflection of a body in its floating frame, as a share of the body's length, beyond
        which linear elasticity no longer holds well and a warning is given; with strain =
        "nonlinear" deflection of an element, as a share of its length; 0: no limit
    energy_growth: growth of the energy beyond the work done, as a share of the largest energy so
        far; 0: no limit
    on_energy_growth: "warn", or "stop": the simulation has diverged (exit status 3)
    step_error: estimated error of a step of generalized_alpha, of an angle in rad, of a
        displacement by a length of the model; 0: no limit
    momentum: change of the momentum of a free model on which nothing acts, by the largest so far;
        0: no limit
    """
    return _given(locals())


def output(*, interval=None):
    """Rows of a result.

    interval: time between the rows of sensors.csv, and between the files of --vtk; 0: every step
        [s]
    """
    return _given(locals())


def statistics(*, exponents=None):
    """How statistics of results are made.

    exponents: exponents by name: blades of all blades that have none of their own, blade1 and so on
        of one, support, or the name of a subsystem
    """
    return _given(locals())


def sensor(*, quantity, name=None, blade=None, position=None, joint=None, loop=None, frame=None,
           subsystem=None, body=None, coupling=None, interface=None, node=None):
    """What is measured besides the sensors that every simulation has.

    name: in the names of the columns, such as blade1.NAME.x
    quantity: what is measured, see below
    blade: number of the blade, from 1, or "all"
    position: distance from the blade's root [m]; or: distance from the root of the blade or the
        beam [m]
    joint: number of the joint, from 1 at the root
    loop: name of a closed loop, which each blade that the sensor is on must have; or: name of a
        closed loop, which each blade, or the subsystem, that the sensor is on must have
    frame: in which a motion is observed and vectors are resolved: "hub", "blade" (as the hub's, x
        along the undeformed blade), "inertial", "section" (turns with the cross section), "loop"
        (turns with the place to of the loop; of a distance, x is along the rod: its force, positive
        in tension, or its elongation, and only x is not 0)
    subsystem: name of a subsystem, in place of blade
    body: name of its body, for a motion, a section force or the reaction of a joint
    coupling: name of a coupling of the subsystem
    interface: of a solid: name of the interface
    node: of a solid, in place of interface: number of a node in the mesh's file
    """
    return _given(locals())
