"""Rotors in air: performance, equilibria, statistics, winds of the program's own."""

import sys

import numpy as np
import pytest
from conftest import MODELS, ROTOR

import spoke

TURBINE = str(MODELS / "nrel_5mw_in_wind.toml")
CALM = {"wind": {"velocity": [12.0, 0.0, 0.0]}}
SHORT = {**CALM, "integration.step": 0.01, "integration.duration": 0.2, "output.interval": 0.02}


def test_performance_over_wind_is_that_of_the_program(program):
    folder = program("performance", TURBINE, "--wind", "8:10:2", "--rigid")
    rows = np.genfromtxt(folder / "performance.csv", delimiter=",", names=True, dtype=None,
                         encoding="utf-8")
    found = spoke.performance(TURBINE, wind=[8.0, 10.0], rigid=True)
    assert np.array_equal(found.power, rows["power_W"])
    assert np.array_equal(found.thrust, rows["thrust_N"])
    assert found.wind.tolist() == [8.0, 10.0] and found.gaps == ["", ""]
    assert not found.is_map
    assert found.power == pytest.approx(found.torque * found.speed)
    pressure = 0.5 * found.density * np.pi * found.radius**2 * found.wind**2
    assert found.power_coefficient == pytest.approx(found.power / (pressure * found.wind))
    assert found.thrust_coefficient == pytest.approx(found.thrust / pressure)
    assert repr(found) == "<spoke.Performance 2 points by wind>"
    assert found.page().startswith("<!")


def test_a_map_of_performance_is_by_tip_speed_ratio_and_pitch():
    found = spoke.performance(TURBINE, wind=8.0, tip_speed_ratio=[6.0, 7.5, 9.0],
                              pitch=[0.0, -0.05], rigid=True)
    assert found.is_map
    for values in (found.wind, found.speed, found.pitch, found.power_coefficient):
        assert values.shape == (3, 2)
    assert found.tip_speed_ratio[:, 0] == pytest.approx([6.0, 7.5, 9.0])
    assert np.array_equal(found.pitch[0], [0.0, -0.05])
    assert (found.power_coefficient < 16.0 / 27.0).all()
    assert np.abs(found.tip_displacement).max() == pytest.approx(0.0, abs=1e-9)
    with pytest.raises(spoke.InputError, match="no wind speeds"):
        spoke.performance(TURBINE)
    with pytest.raises(spoke.InputError, match="air"):
        spoke.performance(ROTOR, wind=8.0)


def test_equilibria_have_the_air():
    found = spoke.equilibrium(TURBINE, set=CALM, speed=1.2)
    assert found.air.wind == pytest.approx(12.0, rel=0.02)
    assert found.air.thrust > 0.0 and found.air.torque > 0.0
    assert repr(found.air).startswith("<spoke.RotorAir wind ")
    air = found.blades[0].air
    assert set(air) == {"station", "attack", "relative_speed", "axial_induction",
                        "tangential_induction", "lift", "drag", "moment", "axial_force",
                        "tangential_force", "pitching_moment"}
    assert {values.shape for values in air.values()} == {air["station"].shape}
    assert (np.diff(air["station"]) > 0.0).all()
    # The loads by length of three blades make the thrust.
    thrust = 3.0 * np.trapz(air["axial_force"], air["station"])
    assert thrust == pytest.approx(found.air.thrust, rel=0.05)
    still = spoke.equilibrium(ROTOR, speed=3.0)
    assert still.air is None and still.blades[0].air is None


def test_a_summary_has_the_statistics_of_the_rows():
    result = spoke.Simulation(TURBINE, set=SHORT, executor="serial").run(
        report=False, statistics_from=0.05)
    statistics = result.summary()["statistics"]
    counted = result.t > 0.05
    assert statistics["rows"] == counted.sum()
    sensors = statistics["sensors"]
    moments = {f"blade{k}.root.moment.{c}" for k in (1, 2, 3) for c in "xyz"}
    assert moments | {"air.power", "air.thrust", "hub.speed", "control.pitch.angle"} <= set(sensors)
    for name, values in sensors.items():
        rows = result[name][counted]
        assert values["mean"] == pytest.approx(rows.mean())
        assert values["standard_deviation"] == pytest.approx(rows.std(), abs=1e-12 * abs(rows).max())
        assert (values["min"], values["max"]) == (rows.min(), rows.max())
        assert ("damage_equivalent_range" in values) == (".root.moment." in name)


def test_a_wind_of_the_programs_own_blows_as_one_of_the_scenario():
    short = {**SHORT, "integration.duration": 0.1}
    steady = spoke.Simulation(TURBINE, set=short, executor="serial").run(report=False)
    own = spoke.Simulation(TURBINE, set=short, threads=2, wind=lambda place, t: (12.0, 0.0, 0.0))
    assert np.array_equal(own.run(report=False).numbers, steady.numbers)

    def gust(place, t):
        return np.array([12.0 + 20.0 * t, 0.0, 0.0])

    blown = spoke.Simulation(TURBINE, set=short, executor="serial", wind=gust).run(report=False)
    assert blown["air.thrust"][-1] > steady["air.thrust"][-1]
    with pytest.raises(spoke.InputError, match="no air"):
        spoke.Simulation(ROTOR, wind=gust)


@pytest.mark.parametrize("fault, shown", [(lambda: 1.0 / 0.0, "ZeroDivisionError"),
                                          (lambda: "calm", "TypeError")])
def test_a_wind_that_fails_ends_the_step(monkeypatch, fault, shown):
    seen = []
    monkeypatch.setattr(sys, "unraisablehook", lambda told: seen.append(told.exc_type.__name__))
    sim = spoke.Simulation(TURBINE, set=SHORT, executor="serial",
                           wind=lambda place, t: fault() if t > 0.05 else (12.0, 0.0, 0.0))
    with pytest.raises(spoke.DivergenceError):
        sim.run(report=False)
    assert set(seen) == {shown}


def test_a_program_pitches_blades_and_sets_the_torque_by_what_the_air_does():
    own = spoke.Simulation(TURBINE, set={
        **SHORT, "control": {}, "blade.joint.1.motion": {"by": "program"},
        "hub.drive": {"kind": "torque", "torque": -4e6, "initial_speed": 1.2671},
        "initial": {"state": "undeformed"}})
    pitch = own.joint_index(0, "pitch")
    before = own.sensor("blade1.outer.angle_of_attack")
    assert own.sensor("air.wind") == pytest.approx(12.0, rel=1e-2)
    start = own.save()
    for blade in range(3):
        own.set_joint_motion(blade, pitch, 0, spoke.CoordinateMotion(acceleration=-4.0))
    own.set_drive(spoke.TorqueDrive(-5e6))
    own.run(until=0.1, report=False)
    motion = own.joint_motion(1, pitch)
    assert motion.value == pytest.approx(-4.0 * 0.1**2 / 2.0)
    assert motion.velocity == pytest.approx(-0.4)
    assert own.sensor("blade2.pitch") == motion.value
    assert own.sensor("hub.torque") == -5e6
    assert own.sensor("blade1.outer.angle_of_attack") < before - 0.01
    with pytest.raises(spoke.InputError, match="go on"):
        own.set_joint_motion(0, pitch, 0, spoke.CoordinateMotion())
    with pytest.raises(spoke.InputError, match='did you mean "pitch"'):
        own.joint_index(0, "pich")
    other = spoke.Simulation(own.scenario)
    other.restore(start)
    course = spoke.Curve([0.0, 0.1, 0.2], [0.0, 0.0, -0.05])
    other.set_joint_course(2, pitch, 0, course)
    other.run(until=0.15, report=False)
    assert other.sensor("blade3.pitch") == course(0.15)
