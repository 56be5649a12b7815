"""Reads the files of spoke run --vtk by VTK and compares them with sensors.csv.

usage: read_vtk_series.py SPOKE SCENARIO FOLDER
"""

import csv
import math
import os
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

from vtk import vtkXMLPolyDataReader

kArrays = {"displacement": 3, "velocity": 3}
kCellArrays = ["blade", "body", "element", "axial_force"]


def read(file):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(file)
    reader.Update()
    assert reader.GetErrorCode() == 0, f"{file}: error {reader.GetErrorCode()}"
    return reader.GetOutput()


def check_near(found, expected, what):
    assert math.isclose(found, expected, rel_tol=1e-9, abs_tol=1e-9), f"{what}: {found}, not {expected}"


def check_arrays(mesh, blades):
    points, cells = mesh.GetPointData(), mesh.GetCellData()
    for name, components in kArrays.items():
        array = points.GetArray(name)
        assert array and array.GetNumberOfComponents() == components, name
        assert array.GetNumberOfTuples() == mesh.GetNumberOfPoints(), name
    for name in kCellArrays:
        array = cells.GetArray(name)
        assert array and array.GetNumberOfTuples() == mesh.GetNumberOfCells(), name
    numbers = {int(cells.GetArray("blade").GetValue(c)) for c in range(mesh.GetNumberOfCells())}
    assert numbers == set(range(1, blades + 1)), numbers
    assert mesh.GetNumberOfPoints() == mesh.GetNumberOfCells() + blades
    fields = mesh.GetFieldData()
    assert fields.GetAbstractArray("spoke_version").GetValue(0)
    assert "velocity m/s" in fields.GetAbstractArray("units").GetValue(0)
    assert fields.GetAbstractArray("scenario").GetValue(0).startswith("Wu & Haug")


def check_geometry(mesh, row, blades, length, azimuths):
    """Points stand where the tip's sensors and the hub's angle have them."""
    fields = mesh.GetFieldData()
    angle = fields.GetArray("hub_angle").GetValue(0)
    check_near(angle, float(row["hub.angle"]), "hub_angle")
    nodes = mesh.GetNumberOfPoints() // blades
    for blade in range(blades):
        tip_x, tip_y = (float(row[f"blade{blade + 1}.tip.{c}"]) for c in "xy")
        x = length * math.cos(azimuths[blade]) + tip_x
        y = length * math.sin(azimuths[blade]) + tip_y
        cosine, sine = math.cos(angle), math.sin(angle)
        last = (blade + 1) * nodes - 1
        tip = mesh.GetPoint(last)
        check_near(tip[0], cosine * x - sine * y, "tip x")
        check_near(tip[1], sine * x + cosine * y, "tip y")
        moved = mesh.GetPointData().GetArray("displacement").GetTuple(last)
        check_near(moved[0], cosine * tip_x - sine * tip_y, "displacement x")
        check_near(moved[1], sine * tip_x + cosine * tip_y, "displacement y")
        line = mesh.GetCell(blade * (nodes - 1)).GetPointIds()
        assert [line.GetId(0), line.GetId(1)] == [blade * nodes, blade * nodes + 1]


def check_velocities(before, mesh, after, seconds):
    """The rate of the points, from the files before and after."""
    array = mesh.GetPointData().GetArray("velocity")
    for k in range(mesh.GetNumberOfPoints()):
        for c in range(3):
            rate = (after.GetPoint(k)[c] - before.GetPoint(k)[c]) / seconds
            assert abs(rate - array.GetTuple(k)[c]) < 2e-3, (k, c)


def main(spoke, scenario, folder):
    subprocess.run(
        [spoke, "run", scenario, "--vtk", "--no-report", "--quiet", "--out", folder]
        + ["--set", "integration.duration=3", "--set", "output.interval=0.01"],
        check=True,
    )
    with open(os.path.join(folder, "sensors.csv"), encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    index = ElementTree.parse(os.path.join(folder, "vtk", "blades.pvd")).getroot()
    entries = index.findall("./Collection/DataSet")
    assert len(entries) == len(rows) == 301, (len(entries), len(rows))
    meshes = []
    for entry, row in zip(entries, rows):
        mesh = read(os.path.join(folder, "vtk", entry.get("file")))
        check_near(float(entry.get("timestep")), float(row["t"]), "timestep")
        check_near(mesh.GetFieldData().GetArray("TimeValue").GetValue(0), float(row["t"]), "TimeValue")
        check_arrays(mesh, 3)
        check_geometry(mesh, row, 3, 8.0, [2.0 * math.pi * i / 3 for i in range(3)])
        meshes.append(mesh)
    check_velocities(meshes[-3], meshes[-2], meshes[-1], 0.02)
    print(f"{len(meshes)} times read")


main(*sys.argv[1:])
