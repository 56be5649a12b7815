"""Bodies from finite-element meshes, reduced to modes."""

import numpy as np
import pytest
from conftest import MODELS

import spoke

BAR = """
world = "space"
[hub.drive]
kind = "fixed"
[[subsystem]]
name = "holder"
[[subsystem.body]]
name = "bar"
kind = "solid"
mesh = "bar.inp"
material = { youngs_modulus = 1e8, poissons_ratio = 0.0, density = 1000.0 }
modes = 8
damping = 0.02
[[subsystem.body.interface]]
name = "root"
nodes = "ROOT"
[[subsystem.joint]]
parent = "hub"
child = "bar"
kind = "fixed"
[integration]
step = 1e-3
duration = 0.01
"""


def bar_mesh():
    """A bar of 1 x 0.1 x 0.1 m: 10 linear hexahedra."""
    corners = [(0.0, 0.0), (0.1, 0.0), (0.1, 0.1), (0.0, 0.1)]
    lines = ["*NODE"]
    lines += [f"{4 * i + c + 1}, {0.1 * i}, {y}, {z}" for i in range(11)
              for c, (y, z) in enumerate(corners)]
    lines.append("*ELEMENT, TYPE=C3D8, ELSET=ALL")
    lines += [", ".join(map(str, [e + 1, *range(4 * e + 1, 4 * e + 9)])) for e in range(10)]
    lines += ["*NSET, NSET=ROOT", "1, 2, 3, 4"]
    return "\n".join(lines) + "\n"


@pytest.fixture
def bar(tmp_path, monkeypatch):
    """The scenario's file beside its mesh, with a cache of its own."""
    monkeypatch.setenv("SPOKE_CACHE", str(tmp_path / "cache"))
    (tmp_path / "bar.inp").write_text(bar_mesh())
    (tmp_path / "bar.toml").write_text(BAR)
    return tmp_path / "bar.toml"


def test_a_bar_has_modes_with_shapes(bar):
    solid, = spoke.reduce(bar)
    assert (solid.subsystem, solid.body, solid.kind) == ("holder", "bar", "reduced")
    assert solid.mass == pytest.approx(10.0)
    assert solid.elements == 10 and solid.has_locking_elements
    assert solid.nodes.shape == (44, 3) and solid.shapes.shape == (8, 44, 3)
    assert solid.labels.tolist() == list(range(1, 45))
    assert (np.diff(solid.frequencies) >= -1e-9).all()
    assert solid.damping_ratios == pytest.approx(0.02 * np.ones(8))
    assert solid.interfaces[0]["name"] == "root" and solid.interfaces[0]["nodes"] == 4
    # With one interface, which is held, the modes are those of vibration.
    assert solid.frequencies == pytest.approx(solid.vibration_frequencies)
    # One of them stretches it, with nu = 0 as a rod: c / (4 L), to the order of linear elements.
    rod = np.sqrt(1e8 / 1000.0) / 4.0
    stretch = np.argmax(np.abs(solid.shapes[:, -4:, 0]).mean(axis=1))
    assert solid.frequencies[stretch] == pytest.approx(rod, rel=2e-3)
    # It has unit mass: its tip moves by sqrt(2 / m).
    assert np.abs(solid.shapes[stretch, -1, 0]) == pytest.approx(np.sqrt(2.0 / 10.0), rel=0.01)
    assert solid.shapes[:, :4] == pytest.approx(0.0, abs=1e-12)
    assert "holder / bar, 44 nodes, 8 modes" in repr(solid)


def test_the_cache_and_the_scenario_keep_what_was_reduced(bar, tmp_path):
    made, = spoke.reduce(bar)
    read, = spoke.reduce(bar)
    forced, = spoke.reduce(bar, force=True)
    assert (made.was_cached, read.was_cached, forced.was_cached) == (False, True, False)
    assert made.cache_file == read.cache_file and made.cache_file.startswith(str(tmp_path))
    assert (made.shapes == read.shapes).all() and (made.shapes == forced.shapes).all()
    scenario = spoke.read_scenario(bar)
    first, again = spoke.reduce(scenario)[0], spoke.reduce(scenario)[0]
    assert first.seconds == again.seconds
    assert spoke.Simulation(scenario, executor="serial").coordinates == 8


def test_a_text_names_meshes_from_the_working_folder(bar, monkeypatch):
    monkeypatch.chdir(bar.parent)
    assert spoke.reduce(BAR, set={"subsystem.1.body.1.modes": 3})[0].shapes.shape[0] == 3


def test_errors_and_models_without_solids(bar):
    with pytest.raises(spoke.InputError, match="expected at most") as caught:
        spoke.reduce(bar, set={"subsystem.1.body.1.modes": 9999})
    assert caught.value.key == "subsystem.1.body.1.modes"
    assert spoke.reduce(MODELS / "heavy_top.toml") == []
