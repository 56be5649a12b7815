"""A controller in Python that the simulation calls every 20 ms: pitch holds the speed of a rotor.

Plates at the ends of three arms are blown by a constant force; what turns the hub is its share
across the arms, which the pitch sets.
"""

import struct

import spoke

TARGET = 2.0            # [rad/s]

ROTOR = """
world = "space"
[hub]
inertia = [8.0, 8.0, 10.0]
drive = { kind = "torque", torque = -2.0, initial_speed = 1.5 }
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
initial = -0.4
period = 0.02
[integration]
step = 0.005
duration = 20.0
"""


class Governor:
    """A proportional and integral part; the generator keeps its power."""

    def __init__(self):
        self.demand = -0.4

    def control(self, record, commands):
        error = record.speed - TARGET
        self.demand = min(max(self.demand + 0.4 * record.period * error, -0.5), 0.5)
        angle = min(max(self.demand + 0.8 * error, -0.5), 0.5)
        commands.pitch = [angle] * len(record.blades)
        commands.torque = -4.0 / max(record.speed, 1.0)

    def save(self):
        return struct.pack("<d", self.demand)

    def restore(self, saved):
        self.demand, = struct.unpack("<d", saved)


sim = spoke.Simulation(ROTOR, controller=Governor())
sim.run(until=8.0)
state = sim.save()
result = sim.run()
print(f"{sim.sensor('hub.speed'):.4f} rad/s, pitch {sim.sensor('vane1.pitch'):+.4f} rad")

# Another simulation goes on from 8 s to the same bits.
again = spoke.Simulation(ROTOR, controller=Governor())
again.restore(state)
again.run()
assert again.state_hash == sim.state_hash
assert abs(sim.sensor("hub.speed") - TARGET) < 0.02 * TARGET
