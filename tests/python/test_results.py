"""Results: those of the program to the last bit, in memory of the run's own."""

import concurrent.futures
import copy
import gc
import json
import multiprocessing
import pickle

import numpy as np
import pytest
from conftest import MODELS, ROTOR, SHORT

import spoke


def as_set(values):
    return [word for key, value in values.items() for word in ("--set", f"{key}={value}")]


@pytest.mark.parametrize("model", ["wu_haug_rotor", "spatial_wu_haug"])
@pytest.mark.parametrize("executor", ["serial", "auto", "flow_graph"])
def test_a_run_has_the_bits_of_the_program(program, model, executor):
    file = MODELS / f"{model}.toml"
    values = {"integration.duration": 0.2, "output.interval": 0.03}
    folder = program("run", file, "--quiet", "--executor", executor, *as_set(values))
    rows = np.genfromtxt(folder / "sensors.csv", delimiter=",", names=True, deletechars="")
    summary = json.loads((folder / "summary.json").read_text())

    sim = spoke.Simulation(file, set=values, executor=executor)
    result = sim.run()

    assert rows.dtype.names[1:] == tuple(result)
    assert np.array_equal(rows["t"], result.t)
    for name in result:
        assert np.array_equal(rows[name], result[name]), name
    assert f"{sim.state_hash:016x}" in json.dumps(summary)
    own = result.summary()
    assert own["sensors"] == summary["sensors"]
    assert own.keys() == summary.keys()


def test_arrays_share_the_memory_of_the_run(rotor):
    result = rotor.run(every=0)
    assert result.numbers.shape == (101, 1 + len(result))
    assert not result.numbers.flags.owndata
    for name in result:
        assert np.shares_memory(result[name], result.numbers)
        assert result[name].shape == result.t.shape
    with pytest.raises(ValueError):
        result["hub.angle"][0] = 1.0


def test_an_array_outlives_its_result_and_simulation():
    sim = spoke.Simulation(ROTOR, set=SHORT, executor="serial")
    angle = sim.run()["hub.angle"]
    copy = angle.copy()
    del sim
    gc.collect()
    assert np.array_equal(angle, copy)


def test_rows_are_those_asked_for(rotor):
    result = rotor.run(until=0.1, every=0.02)
    assert result.t == pytest.approx([0.0, 0.02, 0.04, 0.06, 0.08, 0.1])
    result = rotor.run(until=0.112, every=1.0)  # the present state and the last step
    assert result.t == pytest.approx([0.1, 0.11])
    result = rotor.run()
    assert result.t[[0, -1]] == pytest.approx([0.11, 0.5])
    assert rotor.done
    assert len(rotor.run().t) == 1


def test_a_run_in_parts_has_the_bits_of_one(rotor):
    whole = rotor.run(every=0)
    parts = spoke.Simulation(ROTOR, set=SHORT, executor="serial")
    first = parts.run(until=0.2, every=0)
    for _ in range(5):
        parts.step()
    rest = parts.run(every=0)
    assert parts.state_hash == rotor.state_hash
    k = len(first.t)
    assert np.array_equal(first.numbers, whole.numbers[:k])
    assert np.array_equal(rest.numbers[1:], whole.numbers[k + 5:])


def test_a_result_is_a_mapping_with_units(rotor):
    result = rotor.run(until=0.1)
    assert list(result) == rotor.sensor_names
    assert result.units["hub.torque"] == "N m"
    assert "blade1.tip.y" in result
    assert result["blade1.tip.y"][-1] == rotor.sensor("blade1.tip.y")
    assert rotor.sensors[rotor.sensor_names.index("blade1.tip.y")] == result["blade1.tip.y"][-1]
    with pytest.raises(KeyError):
        result["no such sensor"]
    assert result.wall_time > 0


def test_pages_are_of_the_end_of_the_run_even_later(rotor):
    first = rotor.run(until=0.2)
    page, summary = first.page(), first.summary()
    assert page.startswith("<!DOCTYPE html>")
    rotor.run()
    state = rotor.state_hash
    assert first.summary() == summary
    assert first.page() == page
    assert rotor.state_hash == state


def test_a_run_without_a_report_has_the_same_bits(rotor):
    expected = rotor.run(every=0)
    other = spoke.Simulation(ROTOR, set=SHORT, executor="auto")
    result = other.run(every=0, report=False)
    assert np.array_equal(result.numbers, expected.numbers)
    assert result.summary()["sensors"] == expected.summary()["sensors"]
    with pytest.raises(spoke.StateError):
        result.page()
    assert "Result" in result._repr_html_()


def test_notebooks_show_pages_in_frames(rotor):
    result = rotor.run(until=0.1)
    for shown in (rotor, result, rotor.trace(3), rotor.scenario):
        html = shown._repr_html_()
        assert html.startswith('<iframe srcdoc="&lt;!')
        assert html.count('"') == 4


def test_pandas(rotor):
    pandas = pytest.importorskip("pandas")
    result = rotor.run(until=0.1)
    frame = result.to_pandas()
    assert isinstance(frame, pandas.DataFrame)
    assert list(frame.columns) == list(result)
    assert np.array_equal(frame.index, result.t)
    assert np.array_equal(frame["hub.angle"], result["hub.angle"])


def assert_equal_results(found, expected):
    assert np.array_equal(found.numbers, expected.numbers)
    assert np.array_equal(found.t, expected.t)
    assert list(found) == list(expected)
    assert found.units == expected.units
    assert found.wall_time == expected.wall_time
    assert found.summary() == expected.summary()
    assert repr(found) == repr(expected)
    with pytest.raises(ValueError):
        found["hub.angle"][0] = 1.0


def test_a_result_pickles_and_copies(rotor):
    result = rotor.run(until=0.3)
    state = rotor.state_hash
    again = pickle.loads(pickle.dumps(result))
    assert rotor.state_hash == state
    rotor.run()
    for found in (again, pickle.loads(pickle.dumps(again)), copy.deepcopy(result)):
        assert_equal_results(found, result)
        assert found.page() == result.page()
    assert_equal_results(copy.copy(result), result)
    del rotor, result
    gc.collect()
    assert again["blade1.tip.y"].shape == again.t.shape


def test_a_result_without_a_page_pickles_without_one(rotor):
    result = rotor.run(until=0.1, report=False)
    again = pickle.loads(pickle.dumps(result))
    assert_equal_results(again, result)
    with pytest.raises(spoke.StateError):
        again.page()
    assert "Result" in again._repr_html_()


def run_for(until):
    return spoke.Simulation(ROTOR, set=SHORT, executor="serial").run(until=until, report=False)


def test_a_pool_of_processes_hands_results_back():
    until = [0.1, 0.2]
    with concurrent.futures.ProcessPoolExecutor(
            2, mp_context=multiprocessing.get_context("spawn")) as pool:
        for found, time in zip(pool.map(run_for, until), until):
            assert np.array_equal(found.numbers, run_for(time).numbers)


def test_a_result_of_a_run_that_diverged_pickles():
    sim = spoke.Simulation(ROTOR, set={"blade.bodies": 1, "blade.geometric_stiffening": False,
                                       "output.interval": 0.0}, executor="serial")
    start = sim.save()
    with pytest.raises(spoke.DivergenceError) as caught:
        sim.run()
    result = caught.value.result
    assert_equal_results(pickle.loads(pickle.dumps(result)), result)
    sim.restore(start)
    again = pickle.loads(pickle.dumps(result))
    assert np.array_equal(again.numbers, result.numbers)
    with pytest.raises(spoke.StateError):
        again.summary()


def test_a_name_that_a_result_does_not_have_is_told_with_the_nearest_and_all(rotor):
    result = rotor.run(until=0.01)
    with pytest.raises(KeyError) as caught:
        result["hub.sped"]
    text = str(caught.value)
    assert isinstance(caught.value, spoke.InputError)
    assert text.startswith("no sensor of the result is named 'hub.sped', did you mean hub.speed? ")
    assert all(name in text for name in rotor.sensor_names)
    assert str(pickle.loads(pickle.dumps(caught.value))) == text
    with pytest.raises(spoke.InputError, match="expected one of blade1.tip.x, blade1.tip.y, "):
        result["nothing like it"]
    assert "hub.sped" not in result and 3 not in result and result.get("hub.sped") is None
