"""Controllers in Python: called in samples, saved with states, and what they raise."""

import struct

import pytest

import spoke

VANES = """
world = "space"
[integration]
step = 0.005
duration = 2.0
[hub]
inertia = [8.0, 8.0, 10.0]
[hub.drive]
kind = "torque"
torque = 0.0
initial_speed = 2.0
[[subsystem]]
name = "vane"
count = 3
[[subsystem.body]]
name = "plate"
kind = "rigid"
mass = 0.5
inertia = 0.5
[[subsystem.joint]]
name = "pitch"
parent = "hub"
child = "plate"
kind = "revolute"
offset = [2.0, 0.0, 0.0]
axis = [1.0, 0.0, 0.0]
motion = { constant = 0.0 }
[[load]]
subsystem = "vane"
body = "plate"
frame = "body"
force = [0.0, 0.0, 3.0]
[control.program]
joint = "pitch"
brake_torque = 2.0
period = 0.02
"""


class Governor:
    def __init__(self):
        self.demand = 0.0
        self.names = None
        self.times = []

    def begin(self, sensors):
        self.names = sensors

    def control(self, record, commands):
        assert record.sensors[self.names.index("hub.speed")] == record.speed
        assert record.is_first == (record.time == 0.0)
        assert len(record.blades) == 3 and 0.0 <= record.azimuth < 6.2832
        self.times.append(record.time)
        self.demand += 0.3 * record.period * (record.speed - 1.9)
        commands.pitch = [self.demand, 0.5 * self.demand, -self.demand]
        commands.torque = -0.1 * record.drive_speed
        commands.brake = 0.5 if record.time > 1.0 else 0.0


class SavedGovernor(Governor):
    def save(self):
        return struct.pack("<d", self.demand)

    def restore(self, saved):
        self.demand, = struct.unpack("<d", saved)


def simulation(controller, **arguments):
    return spoke.Simulation(VANES, controller=controller, **arguments)


def test_a_controller_is_called_in_samples():
    governor = Governor()
    sim = simulation(governor)
    result = sim.run(until=0.1, every=0)
    assert governor.times == pytest.approx([0.0, 0.02, 0.04, 0.06, 0.08])
    assert abs(result["vane2.pitch"][-1]) == pytest.approx(0.5 * abs(result["vane1.pitch"][-1]))
    assert result.summary()["status"]  # though the state could not be kept


def test_executors_and_saved_states_have_equal_bits():
    known = simulation(SavedGovernor(), executor="serial")
    known.run(until=1.0)
    state = known.save()
    known.run()
    other = simulation(SavedGovernor(), executor="flow_graph", threads=2)
    other.restore(state)
    copy = other.clone()
    other.run()
    copy.run()
    assert known.state_hash == other.state_hash == copy.state_hash


def test_a_controller_without_a_memory_is_not_saved():
    sim = simulation(lambda record, commands: None)
    sim.run(until=0.1)
    with pytest.raises(spoke.InputError, match="control.program keeps data of its own"):
        sim.save()
    with pytest.raises(spoke.InputError, match="gives no copy"):
        sim.clone()


def test_what_a_controller_raises_leaves_the_run():
    def stop(record, commands):
        if record.time > 0.1:
            raise ZeroDivisionError("enough")

    sim = simulation(stop)
    with pytest.raises(ZeroDivisionError, match="enough"):
        sim.run()
    assert sim.time == pytest.approx(0.12)
    with pytest.raises(ZeroDivisionError):
        sim.step()


def test_demands_that_cannot_be_are_refused():
    def strange(record, commands):
        commands.torque = float("nan")

    with pytest.raises(spoke.DivergenceError, match="torque that is not finite"):
        simulation(strange).run()
    with pytest.raises(TypeError, match="controller is 3, expected an object with the method control"):
        simulation(3)
    with pytest.raises(spoke.InputError, match="the program gives no controller"):
        simulation(None)
