"""The interpreter lock while steps are made: others run, and Ctrl-C ends a run cleanly."""

import os
import signal
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import pytest
from conftest import ROTOR, SHORT

import spoke

LONG = {"integration.duration": 1e4, "output.interval": 1e3}


def test_simulations_in_threads_have_the_bits_of_one_alone(rotor):
    rotor.run()

    def run(_):
        sim = spoke.Simulation(ROTOR, set=SHORT, executor="serial")
        return sim.run(every=0), sim.state_hash

    with ThreadPoolExecutor(2) as pool:
        assert {state for _, state in pool.map(run, range(6))} == {rotor.state_hash}


def test_python_goes_on_while_steps_are_made():
    sim = spoke.Simulation(ROTOR, set={"integration.duration": 50.0}, executor="serial")
    thread = threading.Thread(target=sim.run)
    count = 0
    thread.start()
    while thread.is_alive():
        count += 1
        time.sleep(1e-4)
    thread.join()
    assert sim.done and count > 5  # with the lock held it were 1 or 2


def test_one_simulation_is_not_for_two_threads_at_once():
    entered, left = threading.Event(), threading.Event()
    left.set()

    def wait(t, motions):
        entered.set()
        left.wait()
        return [((0, 0, 0), (0, 0, 0))]

    marker, = spoke.markers_at(spoke.read_scenario(ROTOR), 0, [8.0])
    sim = spoke.Simulation(ROTOR, set=SHORT, executor="serial",
                           loads=[spoke.Load("waits", [marker], wait)])
    entered.clear()
    left.clear()
    thread = threading.Thread(target=sim.run)
    thread.start()
    entered.wait()
    for use in (sim.step, sim.run, sim.save, lambda: sim.time):
        with pytest.raises(spoke.StateError, match="in use"):
            use()
    left.set()
    thread.join()
    assert sim.done


@pytest.mark.parametrize("executor", ["serial", "auto"])
def test_an_interrupt_ends_a_run_after_a_step_from_which_it_goes_on(executor):
    sim = spoke.Simulation(ROTOR, set=LONG, executor=executor)
    timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        sim.run()
    assert 0 < sim.steps < sim.planned_steps
    reached = sim.time + 10 * sim.step_size
    sim.run(until=reached)
    other = spoke.Simulation(ROTOR, set=LONG, executor="serial")
    other.run(until=reached)
    assert other.steps == sim.steps and other.state_hash == sim.state_hash


def test_an_interrupt_within_a_load_is_one():
    marker, = spoke.markers_at(spoke.read_scenario(ROTOR), 0, [8.0])

    def load(t, motions):
        if t > 0.1:
            raise KeyboardInterrupt
        return [((0, 0, 0), (0, 0, 0))]

    sim = spoke.Simulation(ROTOR, set=SHORT, loads=[spoke.Load("load", [marker], load)],
                           executor="serial")
    with pytest.raises(KeyboardInterrupt):
        sim.run()
    assert sim.time == pytest.approx(0.1)
