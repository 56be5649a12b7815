"""Scenarios from everywhere, states, and what a simulation is asked for between steps."""

import inspect
import json
import os
import pickle
import runpy
import subprocess

import numpy as np
import pytest
from conftest import MODELS, ROTOR, SHORT, SOURCE

import spoke
from spoke import model


def hash_of(scenario, **arguments):
    sim = spoke.Simulation(scenario, executor="serial", **arguments)
    sim.run(until=0.1)
    return sim.state_hash


def test_scenarios_from_file_string_dict_and_code_are_one():
    tables = {
        "hub": {"support": "axle", "drive": {"kind": "spin_up", "speed": 4.0, "ramp": 15}},
        "blade": {"count": 3, "length": 8, "bodies": 2, "density": 2766.67, "area": 7.299e-5,
                  "second_moment": np.float64(8.214e-9), "youngs_modulus": 6.895e10},
        "integration": {"step": 0.005, "duration": 20.0},
        "sensor": [{"quantity": "velocity", "name": "outer"}],
    }
    text = """
        sensor = [{quantity = "velocity", name = "outer"}]
        [hub]
        support = "axle"
        drive = {kind = "spin_up", speed = 4.0, ramp = 15.0}
        [blade]
        count = 3
        length = 8.0
        bodies = 2
        density = 2766.67
        area = 7.299e-5
        second_moment = 8.214e-9
        youngs_modulus = 6.895e10
        [integration]
        step = 0.005
        duration = 20.0
        """
    code = model.scenario(
        hub=model.hub(support="axle", drive=spoke.SpinUp(speed=4.0, ramp=15.0)),
        blade=model.blade(count=3, length=8.0, bodies=2, density=2766.67, area=7.299e-5,
                          second_moment=8.214e-9, youngs_modulus=6.895e10),
        integration=model.integration(step=0.005, duration=20.0),
        sensor=[model.sensor(quantity="velocity", name="outer")])
    jsons = {spoke.read_scenario(scenario).to_json() for scenario in (tables, text, code)}
    assert len(jsons) == 1
    assert len({hash_of(scenario) for scenario in (tables, text, code)}) == 1


def crane(**motion):
    """A boom of 20 kg and 2 m on a hinge, its tip on an upright rope of 1 m from a winch."""
    return spoke.Simulation({
        "world": "space",
        "hub": {"drive": {"kind": "fixed"}},
        "gravity": {"acceleration": [0.0, 0.0, -9.81]},
        "anchor": [model.anchor(name="winch", motion=motion)],
        "subsystem": [{
            "name": "crane",
            "body": [{"name": "boom", "kind": "rigid", "mass": 20.0, "center": [1.0, 0.0, 0.0],
                      "inertia": [0.1, 7.0, 7.0]}],
            "joint": [{"name": "hinge", "parent": "hub", "child": "boom", "kind": "revolute",
                       "axis": [0.0, -1.0, 0.0]}],
            "loop": [model.loop(name="rope", kind="distance",
                                from_={"body": "boom", "point": [2.0, 0.0, 0.0]},
                                to={"anchor": "winch", "point": [2.0, 0.0, 1.0]})],
        }],
        "sensor": [model.sensor(quantity="loop_reaction", name="rope", subsystem="crane",
                                loop="rope")],
        "integration": {"duration": 1.0, "step": 0.01}}, executor="serial")


def test_a_program_moves_an_anchor_and_a_loop_carries_the_weight():
    sim = crane(by="program")
    assert sim.sensor("crane.rope.force.x") == pytest.approx(20.0 * 9.81 / 2.0)
    assert sim.loop_reaction(0, "rope").force == pytest.approx([0.0, 0.0, 98.1])
    for _ in range(20):
        winch = sim.anchor_motion("winch")
        winch.acceleration = (0.0, 0.0, 0.5)
        sim.set_anchor_motion("winch", winch)
        sim.step()
    rise = sim.anchor_motion("winch").translation[2]
    assert rise == pytest.approx(0.5 * 0.5 * 0.2**2)
    hinge = sim.sensor("crane.hinge")
    reach, height = 2.0 * np.cos(hinge), 2.0 * np.sin(hinge)
    assert np.hypot(2.0 - reach, 1.0 + rise - height) == pytest.approx(1.0, abs=1e-9)


def test_a_bearing_takes_matrices_by_speed_from_nested_lists():
    sim = spoke.Simulation({
        "world": "space",
        "hub": {"drive": {"kind": "fixed"}},
        "subsystem": [{
            "name": "shaft",
            "body": [{"name": "disc", "kind": "rigid", "mass": 2.0, "inertia": 0.1}],
            "joint": [{"name": "spin", "parent": "hub", "child": "disc", "kind": "cylindrical",
                       "axis": [0.0, 0.0, 1.0], "offset": [1e-3, 0.0, 0.0],
                       "initial_speed": [5.0, 0.0]}],
            "loop": [model.loop(name="journal", kind="bearing", from_={"body": "disc"}, to="hub",
                                axis=[0.0, 0.0, 1.0], speed=[0.0, 10.0],
                                stiffness=[[[1e3, 0.0], [200.0, 1e3]],
                                           [[3e3, 0.0], [400.0, 1e3]]])],
        }],
        "sensor": [model.sensor(quantity="loop_reaction", name="force", subsystem="shaft",
                                loop="journal")],
        "integration": {"duration": 1.0, "step": 0.01}}, executor="serial")
    assert sim.sensor("shaft.force.force.x") == pytest.approx(-2.0)
    assert sim.sensor("shaft.force.force.y") == pytest.approx(-0.3)


def test_a_program_moves_an_anchor_by_functions_of_time():
    lift = spoke.Curve([0.0, 0.1, 0.5], [0.0, 0.0, 0.02])
    sim = crane(by="program")
    sim.run(until=0.05)
    sim.set_anchor_course("winch", (0.0, 0.0, lift), (0.0, 0.0, 0.0))
    sim.run(until=0.3)
    assert sim.anchor_motion("winch").translation[2] == lift(0.3)
    with pytest.raises(spoke.InputError, match="does not go on from where it is"):
        sim.set_anchor_motion("winch", spoke.AnchorMotion())
    with pytest.raises(spoke.InputError, match='did you mean "winch"'):
        sim.anchor_motion("winsh")
    with pytest.raises(spoke.InputError, match='no loop of crane is named "rod"'):
        sim.loop_reaction(0, "rod")


def test_with_the_courses_in_force_a_simulation_goes_back_to_the_same_bits():
    sim = crane(by="program")
    start, at_start = sim.save(), spoke.courses(sim)
    assert at_start.drive.__class__ is spoke.FixedDrive and at_start.joints == []
    anchor, = at_start.anchors
    assert anchor["anchor"] == "winch" and not anchor["follows_curves"]

    def lift(acceleration):
        winch = sim.anchor_motion("winch")
        winch.acceleration = (0.0, 0.0, acceleration)
        sim.set_anchor_motion("winch", winch)

    lift(0.5)
    sim.run(until=0.1)
    state, lifting = sim.save(), spoke.courses(sim)
    result = sim.run(until=0.2)
    expected = sim.state_hash
    lift(-0.5)
    sim.run(until=0.3)
    moved = sim.state_hash
    assert result.summary()["state_hash"] != f"{moved:016x}"  # that of the run's end
    assert sim.state_hash == moved
    assert spoke.courses(sim).anchors[0]["motion"].acceleration[2] == -0.5
    sim.restore(state)
    sim.run(until=0.2)
    assert sim.state_hash != expected  # with the motion in force
    sim.restore(state, lifting)
    sim.run(until=0.2)
    assert sim.state_hash == expected
    sim.restore(start, at_start)
    assert sim.anchor_motion("winch").acceleration[2] == 0.0


def test_a_program_multiplies_loads_of_the_scenario():
    tables = {"integration": {"duration": 1.0, "step": 0.005, "method": "rk4"},
              "hub": model.hub(drive=spoke.TorqueDrive(5.0), inertia=5.0),
              "hub_load": [model.hub_load(name="brake", torque=-2.0)]}
    sim = spoke.Simulation(tables, executor="serial")
    sim.set_load_factor("brake", 2.0)
    assert spoke.courses(sim).loads == {"brake": 2.0}
    sim.run(report=False)
    assert sim.sensor("hub.speed") == pytest.approx((5.0 - 2.0 * 2.0) / 5.0 * 1.0, rel=1e-9)
    with pytest.raises(spoke.InputError, match='did you mean "brake"'):
        sim.set_load_factor("brakes", 1.0)


def test_a_program_is_the_motor_of_a_joint():
    """A torque from the program lifts an arm as the one of the scenario does."""
    def arm(**joint):
        return spoke.Simulation({
            "world": "space", "hub": {"drive": {"kind": "fixed"}},
            "gravity": {"acceleration": [0.0, 0.0, -9.81]},
            "subsystem": [{"name": "arm", "body": [{
                "name": "upper", "kind": "rigid", "mass": 2.0, "center": [0.5, 0.0, 0.0], "inertia": 0.2}],
                "joint": [{"name": "shoulder", "parent": "hub", "child": "upper", "kind": "revolute",
                           "axis": [0.0, 1.0, 0.0], **joint}]}],
            "integration": {"step": 0.005, "duration": 0.5}})
    given, own = arm(torque=-12.0), arm()
    own.set_joint_torque(0, own.joint_index(0, "shoulder"), -12.0)
    given.run()
    own.run()
    assert own.sensor("arm.shoulder") == given.sensor("arm.shoulder")
    assert own.joint_motion(0, 0).value == own.sensor("arm.shoulder")


def test_values_set_take_precedence():
    four, eight = (spoke.Simulation(ROTOR, set={"blade.bodies": n}).coordinates for n in (4, 8))
    assert eight == 2 * four
    scenario = spoke.read_scenario(ROTOR, {"hub.drive": {"kind": "free", "initial_speed": 4}})
    assert '"free"' in scenario.to_json()


@pytest.mark.parametrize("drive", [
    spoke.SpinUp(4.0, 15.0),
    spoke.SpinUpHoldSpinDown(4.0, 1.0, 2.0, 3.0),
    spoke.SpeedTable(spoke.Curve([0.0, 1.0], [0.0, 2.0])),
    spoke.FixedDrive(),
    spoke.ConstantSpeed(1.0),
    spoke.TorqueDrive(5.0),
    spoke.TorqueDrive(spoke.Curve([0.0, 1.0], [0.0, 2.0]), 1.0),
    spoke.TorqueBySpeed(spoke.Curve([0.0, 1.0], [2.0, 0.0]), ramp=1.0),
    spoke.FreeDrive(2.0),
])
def test_drives_of_named_arguments_are_what_a_simulation_has(drive):
    tables = {"integration": {"duration": 1.0}, "hub": model.hub(drive=drive),
              "blade": {"count": 1, "length": 8.0, "density": 2766.67, "area": 7.299e-5,
                        "second_moment": 8.214e-9, "youngs_modulus": 6.895e10}}
    found = spoke.Simulation(tables).drive
    assert type(found) is type(drive)
    assert model.hub(drive=found) == model.hub(drive=drive)


def test_the_functions_of_the_model_are_those_of_the_keys():
    schema = json.loads(subprocess.run([os.environ["SPOKE_PROGRAM"], "schema", "--json"],
                                       capture_output=True, check=True, text=True).stdout)
    written = runpy.run_path(str(SOURCE / "python/write_model.py"))
    text = (SOURCE / "python/spoke/model.py").read_text(encoding="utf-8")
    assert text.split(written["MARK"])[1] == written["make_functions"](schema), (
        "spoke schema --json | python/write_model.py writes them")
    for name, (tables, _) in written["FUNCTIONS"].items():
        arguments = inspect.signature(getattr(model, name)).parameters
        for table in tables:
            keys = (schema["definitions"][table] if table else schema)["properties"]
            assert set(keys) <= {argument.rstrip("_") for argument in arguments}, name


def test_a_key_that_there_is_not_is_refused_at_once():
    with pytest.raises(TypeError):
        model.hub(raduis=1.0)
    assert model.loop(name="a", kind="distance", from_={}, to="hub")["from"] == {}


def test_a_saved_state_goes_on_with_the_bits_of_the_run(rotor, tmp_path):
    rotor.run(until=0.2)
    state, file = rotor.save(), tmp_path / "state.spoke"
    rotor.save_to(file)
    rotor.run()
    end = rotor.state_hash
    rotor.restore(state)
    assert (rotor.time, rotor.steps) == (pytest.approx(0.2), state.steps)
    for restore in (lambda sim: sim.restore(state), lambda sim: sim.restore_from(file),
                    lambda sim: sim.restore(pickle.loads(pickle.dumps(state)))):
        other = spoke.Simulation(ROTOR, set=SHORT)
        restore(other)
        other.run()
        assert other.state_hash == end


def test_a_clone_goes_on_with_the_bits_of_the_run(rotor):
    rotor.run(until=0.2)
    fork, other = rotor.clone(), rotor.clone().clone()
    assert type(fork) is spoke.Simulation and fork.state_hash == rotor.state_hash
    assert (fork.sensors == rotor.sensors).all()
    rows = rotor.run(every=0)
    assert (fork.run(every=0).numbers == rows.numbers).all()
    del rotor
    other.run()
    assert other.state_hash == fork.state_hash


def test_loads_in_python_act_on_clones_too():
    told = []

    def push(t, motions):
        told.append(t)
        return [((0.0, 2.0, 0.0), (0.0, 0.0, 0.0))]

    marker, = spoke.markers_at(spoke.read_scenario(ROTOR), 0, [8.0])
    sim = spoke.Simulation(ROTOR, set=SHORT, executor="serial",
                           loads=[spoke.Load("push", [marker], push)])
    sim.run(until=0.1)
    fork = sim.clone()
    count = len(told)
    fork.run()
    assert len(told) > count
    sim.run()
    assert fork.state_hash == sim.state_hash


def test_a_checkpoint_of_the_program_is_restored(program, rotor):
    folder = program("run", ROTOR, "--quiet", "--set", "integration.duration=0.3",
                     "--checkpoint-every", 1000)
    rotor.restore_from(folder / "checkpoint.spoke")
    assert rotor.time == pytest.approx(0.3)
    rotor.run()
    other = spoke.Simulation(ROTOR, set=SHORT)
    other.run()
    assert rotor.state_hash == other.state_hash


def test_markers_know_what_sensors_show(rotor):
    rotor.run()
    tip, = spoke.markers_at(rotor.scenario, 0, [8.0])
    assert tip == spoke.Marker(blade=0, body=3, station=1.0)
    state = rotor.marker(tip)
    shown = [rotor.sensor("blade1.tip.x"), rotor.sensor("blade1.tip.y")]
    assert state.position.shape == (3,) and state.rotation.shape == (3, 3)
    assert state.deflection[1] == pytest.approx(shown[1], abs=1e-12)
    assert state.rotation @ state.rotation.T == pytest.approx(np.eye(3), abs=1e-12)
    shape = rotor.shape(0)
    assert shape.displacements[-1] == pytest.approx(shown, abs=1e-12)
    assert shape.places.shape == (17, 2) and shape.angles.shape == (17,)
    assert shape.axial_forces.shape == (16,)
    assert rotor.body(0, 3).coordinates.shape == (12,)


def test_reactions_balance(rotor):
    rotor.run()
    moment = rotor.hub_reaction().moment[2]
    assert moment == pytest.approx(rotor.sensor("hub.torque"), rel=1e-9)
    root = spoke.Marker(0, 0, 0.0)
    # What the joint does to the blade is what the hub feels of it, and the root section bears it.
    joint = rotor.joint_reaction(0, 0)
    inboard = rotor.section_force(root)
    rotation = rotor.marker(root).rotation
    assert (rotation.T @ joint.force)[0] == pytest.approx(-inboard.force[0], rel=0.05)
    assert rotor.hub.velocity[2] == pytest.approx(rotor.sensor("hub.speed"))


def test_places_in_space():
    sim = spoke.Simulation(MODELS / "spatial_wu_haug.toml")
    places = sim.places(0)
    assert places.shape[1] == 3
    assert np.linalg.norm(places[-1]) == pytest.approx(8.0)


def test_a_drive_is_replaced_between_steps():
    sim = spoke.Simulation(ROTOR, set={"hub.drive": {"kind": "torque", "torque": 0.0},
                                       "integration.duration": 1.0})
    sim.run(until=0.5)
    assert sim.sensor("hub.speed") == 0.0
    sim.set_drive(spoke.TorqueDrive(50.0))
    sim.run()
    assert sim.sensor("energy.kinetic") > 1.0
    assert isinstance(sim.drive, spoke.TorqueDrive)
    with pytest.raises(spoke.InputError):
        sim.set_drive(spoke.ConstantSpeed(100.0))


def test_drives_of_rotors_are_replaced_by_their_names():
    disc = {"mass": 1.0, "inertia": 0.1}
    sim = spoke.Simulation({
        "world": "space", "integration": {"step": 1e-3, "duration": 1.0},
        "support": {"from": "ground", "joint": [{"child": "frame", "kind": "fixed"}],
                    "body": [{"name": "frame", "kind": "rigid", "mass": 20.0, "inertia": 5.0}]},
        "rotor": [
            {"name": "main", "hub": {**disc, "drive": {"kind": "constant", "speed": 10.0}},
             "axle": {"body": "frame"}},
            {"name": "tail", "hub": {**disc, "drive": {"kind": "free", "initial_speed": 20.0}},
             "axle": {"body": "frame", "offset": [-3.0, 0.0, 0.0]}}]})
    start, in_force = sim.save(), spoke.courses(sim)
    sim.set_drive(spoke.TorqueDrive(-0.5), rotor="tail")
    sim.run(until=0.1)
    assert sim.sensor("tail.hub.speed") == pytest.approx(20.0 - 0.1 * 0.5 / 0.1)
    assert isinstance(sim.drive_of("tail"), spoke.TorqueDrive)
    assert isinstance(sim.drive_of("main"), spoke.ConstantSpeed)
    assert isinstance(spoke.courses(sim).rotors["tail"], spoke.TorqueDrive)
    sim.restore(start, in_force)
    assert isinstance(sim.drive_of("tail"), spoke.FreeDrive)
    with pytest.raises(spoke.InputError, match='did you mean "tail"'):
        sim.set_drive(spoke.TorqueDrive(1.0), rotor="tial")


def test_a_trace_has_the_bits_of_a_run_and_every_node_in_it(rotor):
    trace = rotor.trace(10)
    other = spoke.Simulation(ROTOR, set=SHORT, executor="serial")
    other.run(until=0.05)
    assert rotor.state_hash == other.state_hash
    assert len(trace.steps) == 10
    slices = trace.slices
    assert np.shares_memory(slices, trace.slices)
    assert set(slices["node"]) == set(range(len(trace.nodes)))
    assert (slices["end"] >= slices["begin"]).all()
    assert (trace.edges[:, 0] < trace.edges[:, 1]).all()
    assert 0.0 < trace.summary()["work"] < 1.0
    assert "traceEvents" in trace.chrome_trace()
    assert trace.page().startswith("<!")
    with pytest.raises(spoke.InputError):
        rotor.trace(10**6)
