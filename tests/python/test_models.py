"""Every shipped scenario: the bits of the program, from its file, from the functions of spoke.model
and from its own JSON."""

import json
import keyword
import os
import runpy
import subprocess
import tomllib

import numpy as np
import pytest
from conftest import MODELS, SOURCE

import spoke
from spoke import model

NAMES = sorted(file.stem for file in MODELS.glob("*.toml"))
STEPS = 8


@pytest.fixture(scope="module")
def schema():
    return json.loads(subprocess.run([os.environ["SPOKE_PROGRAM"], "schema", "--json"],
                                     capture_output=True, check=True, text=True).stdout)


@pytest.fixture(scope="module")
def functions():
    """The functions of spoke.model, by the tables that they make."""
    written = runpy.run_path(str(SOURCE / "python/write_model.py"))["FUNCTIONS"]
    return {table: getattr(model, name) for name, (tables, _) in written.items()
            for table in tables}


def tables_of(part):
    """The tables that a part of the schema may refer to."""
    if isinstance(part, list):
        return [name for item in part for name in tables_of(item)]
    if not isinstance(part, dict):
        return []
    if "$ref" in part:
        return [part["$ref"].rsplit("/", 1)[1]]
    return [name for key in ("allOf", "anyOf", "oneOf", "items")
            for name in tables_of(part.get(key, []))]


def argument(key):
    return key + "_" if keyword.iskeyword(key) else key


def build(value, tables, schema, functions):
    """A value of a file whose tables are made by the functions for one of `tables`; those without a
    function stay dictionaries."""
    if isinstance(value, list):
        return [build(item, tables, schema, functions) for item in value]
    if not isinstance(value, dict):
        return value
    parts = [schema["definitions"][table] if table else schema for table in tables]
    built = {}
    for key, own in value.items():
        inner = [name for part in parts
                 for name in tables_of(part.get("properties", {}).get(key, {}))]
        built[argument(key)] = build(own, inner, schema, functions)
    made_by = next((functions[table] for table in tables if table in functions), None)
    if made_by:
        return made_by(**built)
    return {key.rstrip("_"): own for key, own in built.items()}


def hash_of(scenario):
    simulation = spoke.Simulation(scenario, executor="serial")
    simulation.run(until=STEPS * simulation.step_size)
    return simulation.state_hash


@pytest.mark.parametrize("name", NAMES)
def test_a_model_has_the_bits_of_the_program(program, name):
    file = MODELS / f"{name}.toml"
    step = json.loads(spoke.read_scenario(file).to_json())["integration"]["step"]
    values = {"integration.duration": STEPS * step, "output.interval": 0}
    folder = program("run", file, "--quiet", "--executor", "serial",
                     *(word for key, value in values.items()
                       for word in ("--set", f"{key}={value}")))
    rows = np.genfromtxt(folder / "sensors.csv", delimiter=",", names=True, deletechars="")
    simulation = spoke.Simulation(file, set=values, executor="serial")
    result = simulation.run()
    assert len(rows) == STEPS + 1
    assert rows.dtype.names[1:] == tuple(result)
    for column in result:
        assert np.array_equal(rows[column], result[column]), column
    assert f"{simulation.state_hash:016x}" in (folder / "summary.json").read_text()


@pytest.mark.parametrize("name", NAMES)
def test_functions_and_json_make_the_model_of_the_file(monkeypatch, schema, functions, name):
    monkeypatch.chdir(MODELS)  # from which texts name their files
    tables = tomllib.loads((MODELS / f"{name}.toml").read_text(encoding="utf-8"))
    expected = spoke.read_scenario(f"{name}.toml")
    by_functions = build(tables, [""], schema, functions)
    # JSON of the plane has lists of what there is none of, for which files have no word.
    by_json = {key: value for key, value in json.loads(expected.to_json()).items() if value != []}
    for scenario in (by_functions, by_json):
        assert spoke.read_scenario(scenario).to_json() == expected.to_json()
        assert hash_of(scenario) == hash_of(MODELS / f"{name}.toml")
