#!/usr/bin/env python3
"""Writes the functions of spoke.model anew, from the keys that a program knows.

    spoke schema --json | python/write_model.py

A test of the package says when they are out of date.
"""

import json
import keyword
import pathlib
import re
import sys
import textwrap

FILE = pathlib.Path(__file__).resolve().parent / "spoke/model.py"
MARK = "# The functions below are written by write_model.py.\n"
WIDTH = 100

# By function: the tables of the schema that it makes, and what it is.
FUNCTIONS = {
    "scenario": ([""], "A whole scenario, for spoke.Simulation and spoke.read_scenario()."),
    "hub": (["hub"], "The hub."),
    "mount": (["hub.mount"], "The motion of what holds the hub's axle, in space."),
    "suspension": (["hub.suspension"], "Springs and dampers under the hub's axle, in space."),
    "course": (["course"], "A motion over time, of a mount or an anchor."),
    "blade": (["blade"], "All blades alike, or one of several."),
    "sections": (["blade.sections", "beam.sections"],
                 "Properties along a blade or a beam: sequences of equal length, linear in between."),
    "point_mass": (["blade.point_mass", "beam.point_mass"], "A mass on a blade or a beam."),
    "joint": (["blade.joint", "subsystem.joint"],
              "A joint of a blade, at a station, or of a subsystem, from parent to child."),
    "relaxation": (["joint.relaxation"], "A spring and a damper in series on a joint."),
    "stop": (["joint.stop"], "A stop of a joint."),
    "joint_motion": (["joint.motion"], "The prescribed motion of a joint."),
    "loop": (["loop"], "A closed loop: a cut joint between two places."),
    "coupling": (["coupling"], "A linear relation of coordinates of joints: a gear, a rack, a belt."),
    "coupled_joint": (["coupling.joints"], "A coordinate of a joint in a coupling."),
    "friction": (["joint.friction"], "Friction on a joint's coordinate."),
    "place": (["place"], "A place of a closed loop."),
    "anchor": (["anchor"], "A frame whose motion is prescribed, for loops to close on."),
    "anchor_motion": (["anchor.motion"], "The motion of an anchor."),
    "subsystem": (["subsystem"], "A tree of bodies on the hub, in space."),
    "body": (["subsystem.body"], "A body of a tree: a beam, a rigid body or a solid."),
    "material": (["subsystem.body.material"], "The material of a solid."),
    "interface": (["subsystem.body.interface"], "An interface of a solid."),
    "support": (["support"], "What carries the hub's axle, in space."),
    "rotor": (["rotor"], "One of several rotors on a support: a hub on its own axle, and blades."),
    "axle": (["support.axle"], "Where a support carries the hub."),
    "gravity": (["gravity"], "Gravity."),
    "damping": (["damping"], "Damping of the deformation of bodies."),
    "load": (["load"], "A force and a moment at a point of a body."),
    "distributed_load": (["distributed_load"], "A force and a moment per length of a beam."),
    "drag": (["drag"], "A force against the motion of a blade, -(c1 + c2 |u|) u, in the plane."),
    "hub_load": (["hub_load"], "A force and a torque on the hub."),
    "pitch_control": (["control.pitch"],
                      "A controller of pitch, in space: control={\"pitch\": pitch_control(...)}."),
    "library_control": (["control.library"],
                        "A controller of Bladed's kind: control={\"library\": library_control(...)}."),
    "library_record": (["control.library.record"], "A number of a library that a sensor gives."),
    "program_control": (["control.program"],
                        "What a controller of the program may move: "
                        "control={\"program\": program_control(...)}."),
    "turbine_control": (["control.turbine"],
                        "What events move without a controller: "
                        "control={\"turbine\": turbine_control(...)}."),
    "event": (["event"], "What happens once: a fault, a stop, in space."),
    "event_pitch": (["event.pitch"], "How an event turns blades."),
    "event_yaw": (["event.yaw"], "How an event turns the yaw joint."),
    "air": (["air"], "Air around the blades, in space."),
    "wind": (["wind"], "Wind before a rotor disturbs it, in space."),
    "gust": (["wind.gust"], "A gust of the wind."),
    "iec_wind": (["wind.iec"], "A wind condition of IEC 61400-1."),
    "turbulence": (["wind.turbulence"], "Turbulence of the wind."),
    "aerodynamics": (["aerodynamics"], "How induction, inflow and stall are modelled, in space."),
    "blade_aerodynamics": (["blade.aerodynamics"], "Chords and aerofoils of a blade."),
    "body_drag": (["subsystem.body.drag"], "Drag of a beam or a rigid body in the wind."),
    "airfoil": (["airfoil"], "An aerofoil."),
    "polar": (["airfoil.polar"], "Coefficients of an aerofoil at one Reynolds number."),
    "initial": (["initial"], "Where the simulation starts."),
    "integration": (["integration"], "How the motion is integrated."),
    "limits": (["limits"], "Limits beyond which results are doubted."),
    "output": (["output"], "Rows of a result."),
    "statistics": (["statistics"], "How statistics of results are made."),
    "sensor": (["sensor"], "What is measured besides the sensors that every simulation has."),
}

DRIVE = """    if type(drive) in _DRIVES:
        drive = _DRIVES[type(drive)](drive)
"""


def argument(key):
    """A key as the name of an argument."""
    return key + "_" if keyword.iskeyword(key) else key


def make_signature(name, arguments):
    return textwrap.fill(f"def {name}(*, " + ", ".join(arguments) + "):", WIDTH,
                         subsequent_indent=" " * len(f"def {name}("), break_long_words=False)


def make_function(name, schema):
    tables, summary = FUNCTIONS[name]
    parts = [schema["definitions"][table] if table else schema for table in tables]
    properties, required = {}, []
    for part in parts:
        for key, value in part["properties"].items():
            properties.setdefault(key, []).append(value["description"])
    for key in properties:
        if all(key in part.get("required", []) for part in parts):
            required.append(key)
    ordered = required + [key for key in properties if key not in required]
    arguments = [argument(key) + ("" if key in required else "=None") for key in ordered]
    text = make_signature(name, arguments) + f'\n    """{summary}\n\n'
    for key in properties:
        said = "\n\n".join(dict.fromkeys(properties[key]))
        said = re.sub(r"\s*\n\n", "; or: ", said).replace("`", "")
        text += textwrap.fill(f"{argument(key)}: {said}", WIDTH, initial_indent="    ",
                              subsequent_indent="        ", break_long_words=False,
                              break_on_hyphens=False).rstrip() + "\n"
    return text + '    """\n' + (DRIVE if name == "hub" else "") + "    return _given(locals())\n"


def make_functions(schema):
    """The text of all functions, as it stands in spoke.model below the mark."""
    names = "".join(f'    "{name}",\n' for name in sorted(FUNCTIONS))
    functions = "\n\n".join(make_function(name, schema) for name in FUNCTIONS)
    return f"\n__all__ = [\n{names}]\n\n\n{functions}"


def main():
    schema = json.load(sys.stdin)
    head = FILE.read_text(encoding="utf-8").split(MARK)[0]
    FILE.write_text(head + MARK + make_functions(schema), encoding="utf-8")


if __name__ == "__main__":
    main()
