"""What the tests share: the program, the shipped scenarios, and a short simulation."""

import os
import pathlib
import subprocess

import pytest

import spoke

SOURCE = pathlib.Path(__file__).parents[2]
MODELS = SOURCE / "models"
ROTOR = str(MODELS / "wu_haug_rotor.toml")
SHORT = {"integration.duration": 0.5}


@pytest.fixture
def program(tmp_path):
    """Calls the program with arguments; returns the folder of its results."""
    def call(*arguments):
        subprocess.run([os.environ["SPOKE_PROGRAM"], *map(str, arguments), "--out", tmp_path],
                       check=True, stdout=subprocess.DEVNULL)
        return tmp_path
    return call


@pytest.fixture
def rotor():
    """The shipped rotor, half a second of it, on one thread."""
    return spoke.Simulation(ROTOR, set=SHORT, executor="serial")
