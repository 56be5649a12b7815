"""Arguments of a wrong type: one TypeError, which names argument, value and what is expected."""

import ast
import fractions
import pathlib

import numpy as np
import pytest
from conftest import ROTOR, SHORT

import spoke
from spoke import _arguments

STUB = ast.parse((pathlib.Path(spoke.__file__).parent / "__init__.pyi").read_text())
CLASSES = {node.name: node for node in STUB.body if isinstance(node, ast.ClassDef)}
# What calls need besides the argument that is wrong.
GIVEN = {"scenario": ROTOR, "speeds": [0.0, 1.0], "of": "speed", "start": 0.0, "end": 1.0,
         "blade": 0, "tree": 0, "body": 0, "joint": 0, "coordinate": 0, "index": 0, "steps": 1,
         "name": "x", "load": "x", "loop": "x", "factor": 1.0, "positions": [0.0], "markers": [],
         "function": print, "value": 0.0, "values": [0.0], "times": [0.0], "speed": 1.0,
         "ramp": 1.0, "hold": 1.0, "ramp_down": 1.0, "torque": 1.0, "t": 0.0, "translation": [0] * 3,
         "rotation": [0] * 3, "file": "x", "course": 0.0, "drive": spoke.FixedDrive()}


class Odd:
    """No argument is of this type."""

    def __repr__(self):
        return "<odd>"


def functions_of(body):
    return [node for node in body if isinstance(node, ast.FunctionDef)
            and not any(getattr(each, "id", "") == "property" for each in node.decorator_list)]


def arguments_of(node):
    arguments = node.args.args + node.args.kwonlyargs
    return [(each.arg, ast.unparse(each.annotation)) for each in arguments if each.arg != "self"]


def calls():
    """(class or "", function, arguments, the one that is wrong), of all that the stub has."""
    for owner, body in [("", STUB.body), *((name, node.body) for name, node in CLASSES.items())]:
        for node in functions_of(body):
            if node.name.startswith("__") and node.name not in ("__init__", "__getitem__", "__call__"):
                continue
            if owner == "Result":  # a mapping may be asked for any key
                continue
            arguments = [name for name, kind in arguments_of(node)]
            required = arguments[:len(node.args.args) - (owner != "") - len(node.args.defaults)]
            for wrong in arguments:
                yield pytest.param(owner, node.name, required, wrong,
                                   id=f"{owner}.{node.name}({', '.join(arguments)})-{wrong}")


@pytest.fixture(scope="module")
def instances():
    sim = spoke.Simulation(ROTOR, set=SHORT, executor="serial")
    return {"Simulation": sim, "Modes": spoke.modes(ROTOR, count=1, speed=1.0),
            "Curve": spoke.Curve(1.0)}


@pytest.mark.parametrize("owner, function, required, wrong", calls())
def test_all_that_is_public_names_an_argument_that_it_cannot_take(instances, owner, function,
                                                                  required, wrong):
    called = (getattr(spoke, owner) if function == "__init__"
              else getattr(instances[owner], function) if owner else getattr(spoke, function))
    given = {name: GIVEN.get(name) for name in required} | {wrong: Odd()}
    if function == "markers_at" and wrong != "scenario":
        given["scenario"] = instances["Simulation"].scenario
    if function == "restore" and wrong != "state":
        given["state"] = instances["Simulation"].save()
    with pytest.raises(TypeError) as caught:
        called(*[given.pop(name) for name in required], **given)
    text = str(caught.value)
    assert "\n" not in text and f": {wrong} is <odd>, expected " in text
    assert (owner or function) in text and "spoke._spoke" not in text


@pytest.mark.parametrize("owner", ["AnchorMotion", "CoordinateMotion"])
def test_so_do_attributes(owner):
    motion = getattr(spoke, owner)()
    for node in CLASSES[owner].body:
        if isinstance(node, ast.AnnAssign):
            with pytest.raises(TypeError, match=f"^{owner}.{node.target.id} is <odd>, expected "):
                setattr(motion, node.target.id, Odd())


@pytest.mark.parametrize("call, text", [
    (lambda sim: sim.run(until="x"), "Simulation.run(): until is 'x', expected a number"),
    (lambda sim: spoke.campbell(ROTOR, 3.0),
     "spoke.campbell(): speeds is 3.0, expected a list of numbers or an array"),
    (lambda sim: spoke.Simulation(ROTOR, loads=[3]),
     "spoke.Simulation(): loads[0] is 3, expected a Load"),
    (lambda sim: spoke.Simulation(ROTOR, loads=[None]),
     "spoke.Simulation(): loads[0] is None, expected a Load"),
    (lambda sim: spoke.Marker(0, 0, 0.5, [1.0, 2.0]),
     "spoke.Marker(): point is [1.0, 2.0], expected 3 numbers"),
    (lambda sim: spoke.campbell(ROTOR, np.ones((2, 2))),
     "spoke.campbell(): speeds[0] is array([1., 1.]), expected a number"),
    (lambda sim: spoke.performance(ROTOR, wind="x"),
     "spoke.performance(): wind is 'x', expected a number, a list of numbers, an array or None"),
    (lambda sim: spoke.Simulation(ROTOR, threads="4"), "spoke.Simulation(): threads is '4', "
     "expected a whole number, a pair of whole numbers or None"),
    (lambda sim: spoke.SpinUp(1.0),
     "spoke.SpinUp(): missing a required argument: 'ramp', expected (speed, ramp)"),
    (lambda sim: spoke.SpinUp(1.0, 2.0, rump=3.0),
     "spoke.SpinUp(): got an unexpected keyword argument 'rump', expected (speed, ramp)"),
    (lambda sim: sim.step(1), "Simulation.step(): too many positional arguments, expected ()"),
    (lambda sim: sim.body(2**40, 0), "Simulation.body() cannot take blade = 1099511627776, body = 0"),
    (lambda sim: spoke.Trace(sim),
     "spoke.Trace is not made by a call: functions of spoke return it"),
])
def test_the_sentence(rotor, call, text):
    with pytest.raises(TypeError) as caught:
        call(rotor)
    assert str(caught.value) == text


def test_what_is_a_number_to_python_stays_one(rotor):
    for until in (np.float32(0.01), fractions.Fraction(1, 50), np.array(0.03), True):
        rotor.run(until=until, report=False)
    assert spoke.campbell(ROTOR, range(2), count=1).speeds.tolist() == [0.0, 1.0]
    assert spoke.Curve(np.arange(3), (0, 1, np.int64(2)))(1.0) == 1.0


def test_without_the_stub_the_error_is_the_one_below(monkeypatch, rotor):
    monkeypatch.setattr(_arguments, "_stub", dict)
    with pytest.raises(TypeError, match="incompatible function arguments"):
        rotor.run(until="x")
    with pytest.raises(spoke.InputError, match="not a number"):
        rotor.run(until=float("nan"))
