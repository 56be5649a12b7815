"""A controller in Python holds the speed of a rotor against a gust.

It looks at the rotor every 20 ms and sets the motor's torque, by a proportional and an integral
part. Between two looks the simulation runs at its own speed.
"""

import spoke
from spoke import model

WANTED = 4.0            # [rad/s]
PERIOD = 0.02           # between two looks [s]
PROPORTIONAL = 400.0    # [N m s/rad]
INTEGRAL = 200.0        # [N m/rad]

rotor = model.scenario(
    hub=model.hub(inertia=50.0, drive=spoke.TorqueDrive(0.0, initial_speed=WANTED)),
    blade=model.blade(count=3, length=8.0, bodies=4, elements=2, density=2766.67, area=7.299e-5,
                      second_moment=8.214e-9, youngs_modulus=6.895e10),
    # A gust brakes the hub from 1 s on.
    hub_load=[model.hub_load(torque=-30.0, time=[0.0, 1.0, 1.5, 10.0],
                             factor=[0.0, 0.0, 1.0, 1.0])],
    integration=model.integration(duration=10.0, step=0.005))


def hold_speed(sim):
    """Runs to the end; returns the speed at all looks [rad/s]."""
    error_sum, speeds = 0.0, []
    while not sim.done:
        speed = sim.sensor("hub.speed")
        speeds.append(speed)
        error = WANTED - speed
        error_sum += error * PERIOD
        sim.set_drive(spoke.TorqueDrive(PROPORTIONAL * error + INTEGRAL * error_sum))
        sim.run(until=sim.time + PERIOD)
    return speeds


speeds = hold_speed(spoke.Simulation(rotor))
print(f"lowest speed {min(speeds):.4f} rad/s, at the end {speeds[-1]:.4f} rad/s")

free = spoke.Simulation(rotor)
free.run()
print(f"without the controller {free.sensor('hub.speed'):.4f} rad/s")

assert min(speeds) > 0.9 * WANTED and abs(speeds[-1] - WANTED) < 0.02 * WANTED
assert free.sensor("hub.speed") < min(speeds)
