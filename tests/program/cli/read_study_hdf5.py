"""Reads study.h5 with h5py: PROGRAM SCENARIO FOLDER."""
import csv
import pathlib
import shutil
import subprocess
import sys

import h5py

program, scenario, folder = sys.argv[1:]
shutil.rmtree(folder, ignore_errors=True)
pathlib.Path(folder).mkdir(parents=True)
study = pathlib.Path(folder) / "study.toml"
study.write_text(f"""
scenario = "{scenario}"
design = {{ kind = "latin_hypercube", runs = 5, seed = 1 }}
[[parameter]]
key = "blade.length"
uniform = [6, 8]
[[parameter]]
key = "integration.duration"
values = [0.1, 0.2]
[[response]]
sensor = "blade1.tip.y"
kind = "min"
[[response]]
sensor = "hub.angle"
kind = "history"
""")
subprocess.run([program, "study", study, "--out", folder, "--quiet"], check=True)

rows = list(csv.DictReader(open(pathlib.Path(folder) / "runs.csv")))
with h5py.File(pathlib.Path(folder) / "study.h5") as file:
    names = file["parameters"].attrs["names"].decode().split("\n")
    assert names == ["blade.length", "integration.duration"], names
    assert file["responses"].attrs["units"].decode() == "m"
    for i, row in enumerate(rows):
        assert file["status"][i, 0] == 0
        assert [float(row[name]) for name in names] == list(file["parameters"][i])
        assert float(row["blade1.tip.y.min"]) == file["responses"][i, 0]
    history = file["histories/hub.angle.history"]
    assert history["t"].shape == history["value"].shape == (5, 5), history["t"].shape
    assert history["value"].attrs["unit"].decode() == "rad"
