"""Errors: one sentence, and fields that say the same."""

import gc
import os
import pickle
import subprocess
import sys
import traceback
import weakref

import pytest
from conftest import ROTOR, SHORT

import spoke


def raised(kind, call):
    with pytest.raises(kind) as caught:
        call()
    assert "\n" not in str(caught.value)
    return caught.value


def test_an_input_error_names_file_line_column_and_key(tmp_path):
    file = tmp_path / "rotor.toml"
    file.write_text("[blade]\ncount = 3\nlength = -8.0\n[integration]\nduration = 1.0\n"
                    "[hub]\ndrive = {kind = \"fixed\"}\n")
    error = raised(spoke.InputError, lambda: spoke.Simulation(file))
    assert (error.file, error.line, error.key) == (str(file), 3, "blade.length")
    assert error.column == 10
    assert str(error).startswith(f"{file}:3:10: blade.length: ")
    assert isinstance(error, ValueError) and isinstance(error, spoke.Error)


@pytest.mark.parametrize("values, key", [
    ({"blade.bodies": 0}, "blade.bodies"),
    ({"blade.body": 8}, "blade.body"),
    ({"hub.drive.kind": "spin"}, "hub.drive.kind"),
    ({"integration.step": "fast"}, "integration.step"),
])
def test_an_input_error_names_the_key_that_was_set(values, key):
    error = raised(spoke.InputError, lambda: spoke.Simulation(ROTOR, set=values))
    assert (error.file, error.line, error.column, error.key) == (None, None, None, key)


def test_what_is_no_scenario_is_refused():
    assert raised(spoke.InputError, lambda: spoke.Simulation("absent.toml")).file == "absent.toml"
    assert raised(spoke.InputError, lambda: spoke.Simulation("a = \n[")).line == 1
    error = raised(spoke.InputError, lambda: spoke.Simulation({"blade": {"length": object()}}))
    assert error.key == "blade.length"
    raised(spoke.InputError, lambda: spoke.Simulation({}))
    raised(spoke.InputError, lambda: spoke.Simulation(ROTOR, executor="fastest"))
    raised(spoke.InputError, lambda: spoke.Simulation(ROTOR, formulation="new"))
    with pytest.raises(TypeError):
        spoke.Simulation(17)


def test_questions_about_what_is_not_there_are_refused(rotor):
    raised(spoke.InputError, lambda: rotor.sensor("blade9.tip.y"))
    raised(spoke.InputError, lambda: rotor.marker(spoke.Marker(9, 0, 0.5)))
    raised(spoke.InputError, lambda: rotor.run(until=float("nan")))
    raised(spoke.InputError, lambda: rotor.run(every=-1.0))


def test_a_divergence_error_names_where_and_when_and_leaves_what_came_before():
    sim = spoke.Simulation(ROTOR, executor="serial",
                           set={"integration.method": "rk4", "integration.duration": 1.0})
    start = sim.save()
    error = raised(spoke.DivergenceError, sim.run)
    assert isinstance(error, ArithmeticError)
    assert error.step == round(error.time / sim.step_size)
    assert f"step {error.step}:" in str(error)
    assert error.node == f"{error.subsystem} / {error.body} / recovery"
    assert error.node in str(error) and error.quantity in str(error)
    assert 0 < len(error.result.t) and error.result.t[-1] < error.time
    assert "diverged" in error.result.page()
    raised(spoke.StateError, sim.save)
    sim.restore(start)
    assert sim.steps == 0
    raised(spoke.StateError, error.result.page)


def test_errors_survive_pickling():
    error = raised(spoke.InputError, lambda: spoke.Simulation(ROTOR, set={"blade.bodies": 0}))
    again = pickle.loads(pickle.dumps(error))
    assert (str(again), again.key) == (str(error), error.key)


def failing_load(function, **arguments):
    return spoke.Load("gust", [spoke.Marker(0, 3, 1.0)], function, **arguments)


def test_what_a_load_raises_is_a_load_error_and_the_run_can_go_on():
    def gust(t, motions):
        if t > 0.2 and armed:
            raise ValueError("the wind is too strong")
        return [((0, 0, 0), (0, 0, 0))]

    armed = True
    sim = spoke.Simulation(ROTOR, set=SHORT, executor="serial", loads=[failing_load(gust)])
    error = raised(spoke.LoadError, sim.run)
    assert "gust" in str(error) and "ValueError: the wind is too strong" in str(error)
    assert "test_errors.py, line" in str(error)
    assert type(error.__cause__) is ValueError
    assert str(error.__cause__) == "the wind is too strong"
    assert traceback.extract_tb(error.__cause__.__traceback__)[-1].name == "gust"
    assert error.result.t[-1] == pytest.approx(0.2)
    armed = False
    sim.run()
    assert sim.done


@pytest.mark.parametrize("returned", [None, 1.0, [], [(0, 0, 0)], [((0, 0), (0, 0, 0))],
                                      [(("x", 0, 0), (0, 0, 0))],
                                      [((float("nan"), 0, 0), (0, 0, 0))],
                                      [((0, 0, 1.0), (0, 0, 0))]])
def test_what_a_load_must_not_return(returned):
    error = raised(spoke.LoadError, lambda: spoke.Simulation(
        ROTOR, set=SHORT, loads=[failing_load(lambda t, motions: returned)]))
    assert "gust" in str(error) and error.__cause__ is None


def test_the_cause_of_a_load_error_is_the_exception_itself_in_all_threads_and_is_let_go():
    class Gust(Exception):
        pass

    storms = []

    def gust(t, motions):
        if t < 0.1:
            return [((0, 0, 0), (0, 0, 0))]
        storm = Gust(t)
        storms.append(weakref.ref(storm))
        raise storm

    for arguments in ({"executor": "serial"}, {"executor": "flow_graph", "threads": 2}):
        sim = spoke.Simulation(ROTOR, set=SHORT, loads=[failing_load(gust)], **arguments)
        error = raised(spoke.LoadError, sim.run)
        assert isinstance(error.__cause__, Gust) and error.__cause__.args[0] >= 0.1
        del error
    gc.collect()
    assert [storm() for storm in storms] == [None] * len(storms)


@pytest.mark.parametrize("value", ["junk", "", "2,junk", "99999999"])
def test_openmp_is_refused_where_its_runtime_would_end_the_process(value):
    """Another process: the runtime of this one has read its environment."""
    program = f"""
import spoke
try:
    spoke.Simulation({str(ROTOR)!r}, executor="openmp_levels", threads=1)
except spoke.InputError as error:
    print("refused:", error)
print(spoke.Simulation({str(ROTOR)!r}, executor="serial").run(until=0.01).t[-1])
"""
    ended = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True,
                           env={**os.environ, "OMP_NUM_THREADS": value, "OMP_PROC_BIND": "true"})
    assert ended.returncode == 0, ended.stderr
    refusal, time = ended.stdout.splitlines()
    assert refusal.startswith("refused: ") and ("OMP_NUM_THREADS" in refusal
                                                or "no executor" in refusal)
    assert float(time) == 0.01
