"""Equilibria, modes and Campbell diagrams: those of the program."""

import json
import os
import signal
import threading

import numpy as np
import pytest
from conftest import MODELS, ROTOR

import spoke


def test_an_equilibrium_is_that_of_the_program(program):
    folder = program("static", ROTOR, "--speed", 3)
    written = json.loads((folder / "static.json").read_text())
    found = spoke.equilibrium(ROTOR, speed=3.0)
    assert found.speed == 3.0
    assert len(found.blades) == 3
    assert json.dumps(list(found.blades[0].tip_displacement)) in json.dumps(written)
    assert found.blades[0].nodes.shape == found.blades[0].undeformed.shape == (4 * 5, 3)
    # The blade pulls at its root with the centrifugal force, m w^2 r.
    mass = 2766.67 * 7.299e-5 * 8.0
    assert found.blades[0].loads[0].force[0] == pytest.approx(mass * 9.0 * 4.0, rel=1e-3)
    assert found.page().startswith("<!")


def test_an_equilibrium_has_the_forces_of_loops(program, tmp_path):
    scenario = tmp_path / "pitch_link.toml"
    scenario.write_text("""
world = "space"
[hub]
drive = { kind = "constant", speed = 0.0 }
[gravity]
acceleration = [0.0, 0.0, -9.81]
[integration]
duration = 1.0
step = 0.01
[[subsystem]]
name = "blade"
[[subsystem.body]]
name = "horn"
kind = "rigid"
mass = 2.0
center = [0.4, 0.05, 0.0]
inertia = [0.02, 0.3, 0.3]
[[subsystem.joint]]
parent = "hub"
child = "horn"
kind = "revolute"
axis = [1.0, 0.0, 0.0]
stiffness = 1.0
[[subsystem.loop]]
name = "link"
kind = "distance"
from = { body = "horn", point = [0.1, 0.1, 0.0] }
to = { body = "hub", point = [0.1, 0.1, -0.3] }
stiffness = 1e9
""")
    written = json.loads((program("static", scenario) / "static.json").read_text())
    link = spoke.equilibrium(scenario).blades[0].loops[0]
    # The weight has half the arm of the link, which is compressed.
    assert link.name == "link"
    assert link.tension == pytest.approx(-9.81, rel=1e-4)
    assert link.force[2] == pytest.approx(9.81, rel=1e-4)
    assert written["blades"][0]["loops"] == [
        {"name": "link", "force_N": list(link.force), "moment_N_m": list(link.moment),
         "tension_N": link.tension}]


def two_rotors():
    rotor = {"mass": 2.0, "inertia": 0.3, "drive": {"kind": "constant", "speed": 30.0}}
    return {
        "world": "space", "integration": {"duration": 1.0},
        "support": {"from": "ground",
                    "body": [{"name": "frame", "kind": "rigid", "mass": 20.0, "inertia": 5.0}],
                    "joint": [{"name": "foot", "child": "frame", "kind": "universal",
                               "axes": [[1, 0, 0], [0, 1, 0]], "stiffness": [900.0, 700.0]}]},
        "rotor": [{"name": name, "hub": rotor, "axle": {"body": "frame", "offset": [0, 0, height]}}
                  for name, height in (("lower", 0.5), ("upper", 1.0))]}


def test_several_rotors_have_their_own_speeds():
    found = spoke.equilibrium(two_rotors(), speed={"upper": -7.0})
    assert [(rotor.name, rotor.speed) for rotor in found.rotors] == [("lower", 30.0), ("upper", -7.0)]
    assert found.rotors[1].position == pytest.approx([0.0, 0.0, 1.0])
    assert found.rotors[1].axes == pytest.approx(np.eye(3))
    assert found.speed == 30.0 and found.rotors[0].air is None
    against = spoke.modes(two_rotors(), speed={"lower": 30.0, "upper": -30.0})
    assert against.frequencies == pytest.approx(spoke.modes(two_rotors(),
                                                            speed={"lower": 0.0, "upper": 0.0})
                                                .frequencies)
    assert against.rotors[1].speed == -30.0
    with pytest.raises(spoke.InputError, match="tail"):
        spoke.modes(two_rotors(), speed={"tail": 1.0})


def test_modes_are_those_of_the_program(program):
    folder = program("modes", ROTOR, "--speed", 3, "--count", 4)
    rows = np.genfromtxt(folder / "modes.csv", delimiter=",", names=True, dtype=None,
                         encoding="utf-8")
    found = spoke.modes(ROTOR, speed=3.0, count=4)
    assert len(found) == len(rows)
    assert np.array_equal(found.frequencies, rows["frequency_rad_per_s"])
    assert found.eigenvalues.dtype == complex
    assert found.damping_ratios.shape == found.frequencies.shape
    largest = max(np.abs(blade).max() for blade in found[0].shape if blade.size)
    assert largest == pytest.approx(1.0)
    assert [mode.name for mode in found] == [mode.name for mode in found.modes]
    assert found[-1].frequency == found.frequencies[-1]


def test_modes_are_seen_from_outside(program):
    folder = program("modes", ROTOR, "--speed", 3, "--count", 6, "--frame", "fixed")
    rows = np.genfromtxt(folder / "modes.csv", delimiter=",", names=True, dtype=None,
                         encoding="utf-8")
    found = spoke.modes(ROTOR, speed=3.0, count=6, frame="fixed")
    assert found.frame == "fixed"
    assert np.array_equal(found.frequencies, rows["frequency_rad_per_s"])
    turning = spoke.modes(ROTOR, speed=3.0, count=1)
    assert turning.frame == "turning" and turning[0].harmonics == []
    # A whirl at w in the blades' frame is seen at w + 3 rad/s and |w - 3 rad/s|.
    w = {mode.name: mode.frequency for mode in found}
    assert w["lag 1 collective"] == pytest.approx(turning.frequencies[0])
    assert w["lag 1 progressive"] == pytest.approx(turning.frequencies[0] + 3.0)
    assert w["lag 1 regressive"] == pytest.approx(abs(turning.frequencies[0] - 3.0))
    with pytest.raises(spoke.InputError, match='expected "turning", "fixed" or "floquet"'):
        spoke.modes(ROTOR, speed=3.0, frame="outside")


def test_periodic_modes_have_harmonics(program):
    falling = {"gravity": {"acceleration": [0.0, -2.0]}}
    found = spoke.modes(ROTOR, speed=3.0, count=3, frame="floquet", set=falling)
    assert found.frame == "floquet"
    for mode in found:
        assert sum(h["share"] for h in mode.harmonics) == pytest.approx(1.0, abs=1e-4)
        main = [h for h in mode.harmonics if h["multiple"] == 0]
        assert main[0]["frequency"] == pytest.approx(mode.frequency)
        assert all(h["of_hub"] == 0.0 for h in mode.harmonics)  # it is driven
    assert len(found[0].harmonics) > 1


def test_a_flexible_blade_comes_to_its_motion_under_gravity_by_its_multiplier():
    speed, per_turn, turns = 4.0, 400, 80
    period = 2.0 * np.pi / speed
    blade = {"blade.count": 1, "blade.bodies": 2, "blade.elements": 2,
             "hub.drive": {"kind": "constant", "speed": speed},
             "damping": {"stiffness_factor": 0.02}}
    falling = {**blade, "gravity": {"acceleration": [0.0, -9.81]}}
    run = spoke.Simulation(ROTOR, set={
        **falling, "initial": {"state": "equilibrium"}, "output.interval": period,
        "integration.step": period / per_turn, "integration.duration": turns * period,
        "integration.spectral_radius": 1.0}).run()
    # Turn by turn the distance from the periodic motion goes by a multiplier and its conjugate.
    left = np.diff(np.stack([run["blade1.tip.x"], run["blade1.tip.y"]], 1), axis=0)[turns // 2:]
    before = np.stack([left[1:-1].ravel(), left[:-2].ravel()], 1)
    double_real, minus_square = np.linalg.lstsq(before, left[2:].ravel(), rcond=None)[0]

    def multiplier(scenario):
        mode = spoke.modes(ROTOR, speed=speed, count=1, frame="floquet", set=scenario)[0]
        return np.exp(mode.eigenvalue * period)

    found = multiplier(falling)
    assert 2.0 * found.real == pytest.approx(double_real, abs=4e-4)
    assert abs(found) ** 2 == pytest.approx(-minus_square, abs=4e-4)
    assert abs(found - multiplier(blade)) > 0.05  # gravity counts


def test_a_campbell_diagram_is_seen_from_outside():
    speeds = [1.0, 2.0, 3.0]
    found = spoke.campbell(ROTOR, speeds, count=3, frame="fixed", set={"blade.bodies": 1})
    assert {state.frame for state in found.states} == {"fixed"}
    assert "lag 1 progressive" in {branch["name"] for branch in found.branches}
    with pytest.raises(spoke.InputError, match="expects a hub that turns"):
        spoke.campbell(ROTOR, [0.0, 1.0], frame="floquet")


def test_a_campbell_diagram_follows_modes():
    speeds = np.linspace(0.0, 4.0, 3)
    found = spoke.campbell(ROTOR, speeds, count=2, harmonics=3, set={"blade.count": 1})
    assert np.array_equal(found.speeds, speeds)
    for branch in found.branches:
        assert branch["frequencies"].shape == speeds.shape
    assert found.branches[0]["frequencies"][0] == pytest.approx(
        spoke.modes(ROTOR, speed=0.0, count=1, set={"blade.count": 1}).frequencies[0])
    for crossing in found.crossings:
        assert crossing["frequency"] == pytest.approx(crossing["harmonic"] * crossing["speed"])
    assert found._repr_html_().startswith("<iframe")
    with pytest.raises(spoke.InputError):
        spoke.campbell(ROTOR, [1.0, 0.5])


def test_a_critical_load_is_that_of_euler():
    column = {"blade.count": 1, "load": [{"name": "push", "force": [-1.0, 0.0]}]}
    found = spoke.critical(ROTOR, "load=push", 0.0, 40.0, set=column, speed=0.0, points=4, count=2)
    assert found.kind == "buckling"
    assert found.value == pytest.approx(21.8343, abs=1e-3)
    assert (found.name, found.frequency) == ("lag 1", 0.0)
    assert found.mode.grows
    assert found.value in found.values and len(found.states) == len(found.values)
    assert repr(found).startswith("<spoke.Critical buckling at a factor of the load push of 21.83")
    assert found._repr_html_().startswith("<iframe")
    stable = spoke.critical(ROTOR, "speed", 0.0, 4.0, points=3, count=2)
    assert stable.value is None and stable.mode is None
    with pytest.raises(spoke.InputError):
        spoke.critical(ROTOR, "load=push", 0.0, 1.0)


def test_an_interrupt_ends_a_campbell_diagram():
    speeds = np.linspace(0.0, 4.0, 20000)
    threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
    with pytest.raises(KeyboardInterrupt):
        spoke.campbell(ROTOR, speeds, count=2)


def test_an_equilibrium_that_is_not_found_says_where():
    with pytest.raises(spoke.InputError):
        spoke.equilibrium(MODELS / "free_hub_satellite.toml")


def test_what_is_found_says_what_it_holds():
    steady = spoke.equilibrium(ROTOR, speed=3.0)
    tip = np.linalg.norm(steady.blades[0].tip_displacement)
    assert repr(steady).startswith("<spoke.Equilibrium at 3 rad/s, 3 subsystems, largest tip ")
    assert f"{tip:.6g} m" in repr(steady)
    assert repr(steady.blades[0]).startswith("<spoke.BladeEquilibrium blade 1, tip displacement [")
    assert repr(steady.blades[0].loads[0]).startswith("<spoke.SectionLoad at 0 m, force [")
    modes = spoke.modes(ROTOR, speed=3.0, count=2)
    assert repr(modes[0]) == (f"<spoke.Mode {modes[0].name} of {modes[0].of}, "
                              f"{modes[0].frequency:.6g} rad/s>")
    assert repr(modes) == (f"<spoke.Modes 2 modes at 3 rad/s: {repr(modes[0])[12:-1]}; "
                           f"{repr(modes[1])[12:-1]}>")
    assert repr(spoke.modes(ROTOR, count=6)).endswith("; ...>")
    damped = spoke.modes(ROTOR, count=1, set={"damping.stiffness_factor": 0.02})[0]
    assert f", damping ratio {damped.damping_ratio:.6g}>" in repr(damped)
    diagram = spoke.campbell(ROTOR, [0.0, 4.0], count=2)
    assert repr(diagram).startswith("<spoke.Campbell 2 speeds from 0 to 4 rad/s, 2 modes followed")
    assert len(diagram.states[1]) == len(diagram.states[1].modes) > 0


def test_notebooks_show_what_is_found():
    modes = spoke.modes(ROTOR, speed=3.0, count=3)
    shown = (spoke.equilibrium(ROTOR, speed=3.0), modes, modes[0], modes.modes[2],
             spoke.campbell(ROTOR, [0.0, 4.0], count=2).states[0])
    for one in shown:
        assert one._repr_html_().startswith('<iframe srcdoc="&lt;!')
    assert modes[1].name in modes.page()
    assert modes[0].name in modes[0].page() and modes[1].name not in modes[0].page()


def test_a_mode_outlives_its_modes():
    modes = spoke.modes(ROTOR, speed=3.0, count=2)
    one, frequency = modes[1], modes.frequencies[1]
    del modes
    assert one.frequency == frequency
    assert one.page().startswith("<!")
