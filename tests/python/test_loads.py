"""Loads as Python functions, on one thread and on several."""

import numpy as np
import pytest
from conftest import ROTOR, SHORT

import spoke

FORCE = [0.0, 2.0, 0.0]


def tips(scenario):
    return [spoke.markers_at(scenario, blade, [8.0])[0] for blade in range(3)]


def by_marker(t, motions):
    return [((0.0, 2.0, 0.0) - 0.1 * motion.velocity, (0.0, 0.0, 0.0)) for motion in motions]


def at_once(t, motions, force, moment):
    assert motions.position.shape == force.shape == moment.shape == (len(force), 3)
    assert motions.rotation.shape == (len(force), 3, 3)
    force += FORCE
    force -= 0.1 * motions.velocity


def run(loads=(), **arguments):
    sim = spoke.Simulation(ROTOR, set={**SHORT, **arguments.pop("values", {})}, loads=loads,
                           **arguments)
    return sim, sim.run(every=0)


def test_a_function_is_a_load_of_the_scenario():
    # Without stiffening: else the velocities of markers include foreshortening, that of drag does not.
    linear = {"blade.geometric_stiffening": False}
    markers = tips(spoke.read_scenario(ROTOR))
    _, expected = run(values={
        "load": [{"force": FORCE[:2], "frame": "inertial"}],
        "drag": [{"linear": 0.1}], **linear})
    for load in (spoke.Load("tips", markers, by_marker),
                 spoke.Load("tips", markers, at_once, vectorized=True)):
        _, found = run([load], values=dict(linear))
        assert found["blade2.tip.y"] == pytest.approx(expected["blade2.tip.y"], abs=1e-9)


@pytest.mark.parametrize("executor", ["flow_graph", "auto"])
def test_equal_bits_on_all_executors(executor):
    markers = tips(spoke.read_scenario(ROTOR))

    def loads():
        return [spoke.Load(f"tip {k}", [marker], at_once, vectorized=True)
                for k, marker in enumerate(markers)]

    serial, _ = run(loads(), executor="serial", values={"integration.duration": 0.1})
    other, _ = run(loads(), executor=executor, threads=2, values={"integration.duration": 0.1})
    assert other.state_hash == serial.state_hash


def test_a_load_is_replaced_by_one_with_the_same_markers():
    markers = tips(spoke.read_scenario(ROTOR))
    nothing = spoke.Load("none", markers, lambda t, motions, force, moment: None, vectorized=True)
    sim = spoke.Simulation(ROTOR, set=SHORT, loads=[nothing], executor="serial")
    free, _ = run(executor="serial")
    sim.run(until=0.3)
    sim.set_load(0, spoke.Load("push", markers, at_once, vectorized=True))
    sim.run()
    assert sim.sensor("blade1.tip.y") > free.sensor("blade1.tip.y") + 1e-3
    with pytest.raises(spoke.InputError):
        sim.set_load(1, nothing)
    with pytest.raises(spoke.InputError):
        sim.set_load(0, spoke.Load("other", markers[:1], by_marker))


def test_a_load_may_not_ask_the_simulation_that_it_acts_on():
    marker, = spoke.markers_at(spoke.read_scenario(ROTOR), 0, [8.0])
    sims = []

    def ask(t, motions):
        if sims:
            sims[0].sensor("hub.speed")
        return [(np.zeros(3), np.zeros(3))]

    sims.append(spoke.Simulation(ROTOR, set=SHORT, loads=[spoke.Load("asks", [marker], ask)],
                                 executor="serial"))
    with pytest.raises(spoke.LoadError, match="in use"):
        sims[0].run()
