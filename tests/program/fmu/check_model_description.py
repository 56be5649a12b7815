"""Holds modelDescription.xml of FMUs to the rules of the schemas of FMI 3.0 and 2.0, in words of its own.

check_model_description.py SPOKE MODELS WORK: makes FMUs of shipped scenarios, checks each, and checks
that each rule finds a fault.
"""

import os
import re
import subprocess
import sys
import xml.etree.ElementTree as ET
import zipfile

ORDER = ["CoSimulation", "UnitDefinitions", "LogCategories", "DefaultExperiment", "ModelVariables",
         "ModelStructure"]
BOOLEAN = re.compile(r"(true|false|1|0)$")
NUMBER = re.compile(r"[+-]?(\d+(\.\d*)?|\.\d+)([eE][+-]?\d+)?$")
WHOLE = re.compile(r"[+-]?\d+$")
UNSIGNED = re.compile(r"\d+$")
TEXT = re.compile(r".*$", re.S)
NAME = re.compile(r"[^\t\r\n]+$")  # a normalized string
IDENTIFIER = re.compile(r"[A-Za-z_]\w*$", re.ASCII)
VERSION = re.compile(r"3\.[0-9]+(\.[0-9]+)?(-.+)?$")
VERSION_2 = re.compile(r"2\.0$")
INDEX = re.compile(r"[1-9]\d*$")
# By element: attributes that it must have, and those that it may have.
ATTRIBUTES = {
    "fmiModelDescription": (
        {"fmiVersion": VERSION, "modelName": TEXT, "instantiationToken": NAME},
        {"description": TEXT, "author": TEXT, "version": NAME, "copyright": TEXT, "license": TEXT,
         "generationTool": NAME, "generationDateAndTime": TEXT,
         "variableNamingConvention": re.compile(r"(flat|structured)$")}),
    "CoSimulation": (
        {"modelIdentifier": IDENTIFIER},
        {"needsExecutionTool": BOOLEAN, "canBeInstantiatedOnlyOncePerProcess": BOOLEAN,
         "canGetAndSetFMUState": BOOLEAN, "canSerializeFMUState": BOOLEAN,
         "providesDirectionalDerivatives": BOOLEAN, "providesAdjointDerivatives": BOOLEAN,
         "providesPerElementDependencies": BOOLEAN,
         "canHandleVariableCommunicationStepSize": BOOLEAN, "fixedInternalStepSize": NUMBER,
         "maxOutputDerivativeOrder": UNSIGNED, "recommendedIntermediateInputSmoothness": WHOLE,
         "providesIntermediateUpdate": BOOLEAN, "mightReturnEarlyFromDoStep": BOOLEAN,
         "canReturnEarlyAfterIntermediateUpdate": BOOLEAN, "hasEventMode": BOOLEAN,
         "providesEvaluateDiscreteStates": BOOLEAN}),
    "UnitDefinitions": ({}, {}),
    "Unit": ({"name": NAME}, {}),
    "BaseUnit": ({}, {**{unit: WHOLE for unit in ("kg", "m", "s", "A", "K", "mol", "cd", "rad")},
                      "factor": NUMBER, "offset": NUMBER}),
    "LogCategories": ({}, {}),
    "Category": ({"name": NAME}, {"description": TEXT}),
    "DefaultExperiment": ({}, {"startTime": NUMBER, "stopTime": NUMBER, "tolerance": NUMBER,
                               "stepSize": NUMBER}),
    "ModelVariables": ({}, {}),
    "Float64": ({"name": NAME, "valueReference": UNSIGNED},
                {"description": TEXT, "causality": TEXT, "variability": TEXT, "initial": TEXT,
                 "unit": NAME, "start": NUMBER}),
    "ModelStructure": ({}, {}),
    "Output": ({"valueReference": UNSIGNED}, {"dependencies": TEXT, "dependenciesKind": TEXT}),
    "InitialUnknown": ({"valueReference": UNSIGNED},
                       {"dependencies": TEXT, "dependenciesKind": TEXT}),
}
ATTRIBUTES_2 = {
    "fmiModelDescription": (
        {"fmiVersion": VERSION_2, "modelName": NAME, "guid": NAME},
        {"description": TEXT, "author": TEXT, "version": NAME, "copyright": TEXT, "license": TEXT,
         "generationTool": NAME, "generationDateAndTime": TEXT,
         "variableNamingConvention": re.compile(r"(flat|structured)$"), "numberOfEventIndicators": UNSIGNED}),
    "CoSimulation": (
        {"modelIdentifier": IDENTIFIER},
        {"needsExecutionTool": BOOLEAN, "canHandleVariableCommunicationStepSize": BOOLEAN,
         "canInterpolateInputs": BOOLEAN, "maxOutputDerivativeOrder": UNSIGNED,
         "canRunAsynchronuously": BOOLEAN, "canBeInstantiatedOnlyOncePerProcess": BOOLEAN,
         "canNotUseMemoryManagementFunctions": BOOLEAN, "canGetAndSetFMUstate": BOOLEAN,
         "canSerializeFMUstate": BOOLEAN, "providesDirectionalDerivative": BOOLEAN}),
    **{name: ATTRIBUTES[name] for name in ("UnitDefinitions", "Unit", "BaseUnit", "LogCategories",
                                           "Category", "DefaultExperiment", "ModelVariables",
                                           "ModelStructure")},
    "ScalarVariable": ({"name": NAME, "valueReference": UNSIGNED},
                       {"description": TEXT, "causality": TEXT, "variability": TEXT, "initial": TEXT,
                        "canHandleMultipleSetPerTimeInstant": BOOLEAN}),
    "Real": ({}, {"declaredType": NAME, "unit": NAME, "start": NUMBER, "min": NUMBER, "max": NUMBER}),
    "Outputs": ({}, {}), "InitialUnknowns": ({}, {}),
    "Unknown": ({"index": INDEX}, {"dependencies": TEXT, "dependenciesKind": TEXT}),
}
CHILDREN = {
    "fmiModelDescription": set(ORDER), "UnitDefinitions": {"Unit"}, "Unit": {"BaseUnit"},
    "LogCategories": {"Category"}, "ModelVariables": {"Float64"},
    "ModelStructure": {"Output", "InitialUnknown"},
}
CHILDREN_2 = {**CHILDREN, "ModelVariables": {"ScalarVariable"}, "ScalarVariable": {"Real"},
              "ModelStructure": {"Outputs", "InitialUnknowns"}, "Outputs": {"Unknown"},
              "InitialUnknowns": {"Unknown"}}
# Causality and variability: whether a start value is required, and the values of "initial".
KINDS = {("independent", "continuous"): (False, {None}), ("input", "continuous"): (True, {None, "exact"}),
         ("output", "continuous"): (False, {None, "calculated"})}


def find_shape_faults(element, attributes, children):
    """Yields faults of names and values of elements and attributes."""
    required, optional = attributes[element.tag]
    for name, kind in required.items():
        if name not in element.attrib:
            yield f"{element.tag}: {name} is missing"
    for name, value in element.attrib.items():
        kind = required.get(name) or optional.get(name)
        if kind is None:
            yield f"{element.tag}: has no attribute {name}"
        elif not kind.match(value):
            yield f"{element.tag}: {name} is {value!r}"
    for child in element:
        if child.tag in children.get(element.tag, set()):
            yield from find_shape_faults(child, attributes, children)
        else:
            yield f"{element.tag}: holds {child.tag}"


def find_twice(values, what):
    seen = set()
    for value in values:
        if value in seen:
            yield f"{what} {value} is there twice"
        seen.add(value)


def variables_of(root):
    """Returns the variables in their order, each with the attributes of its type: of 2.0 those of Real."""
    if root.get("fmiVersion") != "2.0":
        return [dict(variable.attrib) for variable in root.iter("Float64")]
    return [{**variable.attrib, **variable[0].attrib} for variable in root.iter("ScalarVariable")]


def find_variable_faults(root):
    units = {unit.get("name") for unit in root.iter("Unit")}
    variables = variables_of(root)
    yield from find_twice([unit.get("name") for unit in root.iter("Unit")], "unit")
    yield from find_twice([category.get("name") for category in root.iter("Category")], "category")
    yield from find_twice([variable.get("name") for variable in variables], "name")
    yield from find_twice([variable.get("valueReference") for variable in variables], "reference")
    for variable in variables:
        name = variable.get("name")
        kind = KINDS.get((variable.get("causality"), variable.get("variability")))
        if kind is None:
            yield f"{name}: causality and variability do not go together"
            continue
        has_start, initial = kind
        if root.get("fmiVersion") == "2.0" and variable.get("causality") == "input":
            initial = {None}
        if has_start != ("start" in variable):
            yield f"{name}: start"
        if variable.get("initial") not in initial:
            yield f"{name}: initial"
        if "unit" in variable and variable.get("unit") not in units:
            yield f"{name}: its unit is not defined"
    times = [v for v in variables if v.get("causality") == "independent"]
    if len(times) != 1 or times[0].get("name") != "time":
        yield "there is not one independent variable, time"


def find_structure_faults(root):
    variables = variables_of(root)
    if root.get("fmiVersion") == "2.0":  # by their places among the variables, from 1 on
        outputs = [str(k) for k, v in enumerate(variables, 1) if v.get("causality") == "output"]
        if [child.tag for child in root.find("ModelStructure")] != ["Outputs", "InitialUnknowns"]:
            yield "Outputs and InitialUnknowns are not there in this order"
            return
        found = {tag: [unknown.get("index") for unknown in root.find("ModelStructure").find(tag)]
                 for tag in ("Outputs", "InitialUnknowns")}
        if found["InitialUnknowns"] != sorted(set(found["InitialUnknowns"]), key=int):
            yield "InitialUnknowns are not in ascending order"
    else:
        outputs = [v.get("valueReference") for v in variables if v.get("causality") == "output"]
        found = {tag + "s": [element.get("valueReference") for element in root.iter(tag)]
                 for tag in ("Output", "InitialUnknown")}
    if found["Outputs"] != outputs:
        yield "Outputs are not the outputs in their order"
    if sorted(found["InitialUnknowns"]) != sorted(outputs):
        yield "InitialUnknowns are not the variables that are calculated"


def find_time_faults(root):
    experiment, simulation = root.find("DefaultExperiment"), root.find("CoSimulation")
    size = float(experiment.get("stepSize", 0))
    if size <= 0.0:
        yield "stepSize is not above 0"
    if root.get("fmiVersion") != "2.0":
        step = float(simulation.get("fixedInternalStepSize", 0))
        if step <= 0.0:
            yield "fixedInternalStepSize is not above 0"
        elif abs(size / step - round(size / step)) > 1e-9:
            yield "stepSize is no multiple of fixedInternalStepSize"
    if float(experiment.get("startTime", 0)) >= float(experiment.get("stopTime", 0)):
        yield "the experiment ends before it starts"


def find_faults(root):
    """Returns the faults of a model description."""
    if root.tag != "fmiModelDescription":
        return ["the root is " + root.tag]
    is_2 = root.get("fmiVersion", "").startswith("2")
    faults = list(find_shape_faults(root, *((ATTRIBUTES_2, CHILDREN_2) if is_2
                                            else (ATTRIBUTES, CHILDREN))))
    faults += [f"{variable.get('name')}: has not one type" for variable in root.iter("ScalarVariable")
               if len(variable) != 1]
    tags = [child.tag for child in root]
    if tags != ORDER:
        faults.append("elements are not there once each, in their order")
    if not faults:
        for rule in (find_variable_faults, find_structure_faults, find_time_faults):
            faults += rule(root)
    return faults


def find_archive_faults(archive, root):
    names = archive.namelist()
    yield from find_twice(names, "file")
    identifier = root.find("CoSimulation").get("modelIdentifier")
    platform = os.uname().machine + "-linux"
    if root.get("fmiVersion") == "2.0" and platform == "x86_64-linux":
        platform = "linux64"
    for name in (f"binaries/{platform}/{identifier}.so", "documentation/licenses/license.txt",
                 "resources/spoke.toml"):
        if name not in names:
            yield f"{name} is missing"
    for name in names:
        if name.startswith("/") or ".." in name or "\\" in name:
            yield f"{name} is no path within the archive"
    if archive.testzip():
        yield "a checksum is wrong"


def faults_of(text):
    return find_faults(ET.fromstring(text))


CHANGES = [  # of a description without faults: what is replaced by what
    ('fmiVersion="3.0"', 'fmiVersion="2.0"'), (' modelName="', ' name="'),
    (' instantiationToken="', ' guid="'), ('modelIdentifier="', 'modelIdentifier="2'),
    ('canGetAndSetFMUState="true"', 'canGetAndSetFMUState="yes"'),
    ('fixedInternalStepSize="', 'fixedInternalStepSize="x'),
    ('<Unit name="s"', '<Unit name="t"'), ('<Unit name="m"', '<Unit name="s"'),
    ('<BaseUnit s="1"/>', '<BaseUnit S="1"/>'), ('<BaseUnit s="1"/>', '<BaseUnit s="0.5"/>'),
    ('name="time"', 'name="t"'), ('name="hub.angle"', 'name="hub.speed"'),
    ('valueReference="2"', 'valueReference="3"'), ('valueReference="2"', 'valueReference="-2"'),
    ('causality="input"', 'causality="local"'), ('causality="independent"', 'causality="output"'),
    ('variability="continuous"', 'variability="fixed"'), (' start="', ' begin="'),
    (' initial="calculated"', ' initial="exact"'), ('<Output valueReference="2"/>', ''),
    ('<Output valueReference="2"/>', '<Output valueReference="99999"/>'),
    ('<InitialUnknown valueReference="2"/>', ''), ('stepSize="', 'stepSize="0.0'),
    ('startTime="0"', 'startTime="1e9"'), ('<Category name="logStatusError"', '<Category name=""'),
    ('</LogCategories>', '</LogCategories><Logs/>'), ('<ModelStructure>', '<ModelStructure><Clock/>'),
]


CHANGES_2 = [
    ('fmiVersion="2.0"', 'fmiVersion="3.0"'), ('fmiVersion="2.0"', 'fmiVersion="2.1"'),
    (' modelName="', ' name="'), (' guid="', ' instantiationToken="'),
    ('modelIdentifier="', 'modelIdentifier="2'), ('canGetAndSetFMUstate', 'canGetAndSetFMUState'),
    ('canNotUseMemoryManagementFunctions="true"', 'canNotUseMemoryManagementFunctions="maybe"'),
    ('<Unit name="s"', '<Unit name="t"'), ('<BaseUnit s="1"/>', '<BaseUnit s="0.5"/>'),
    ('name="time"', 'name="t"'), ('name="hub.angle"', 'name="hub.speed"'),
    ('valueReference="2"', 'valueReference="3"'), ('valueReference="2"', 'valueReference="-2"'),
    ('causality="input"', 'causality="local"'), ('causality="independent"', 'causality="output"'),
    ('variability="continuous"', 'variability="fixed"'), ('<Real unit="rad/s" start="', '<Real begin="'),
    ('causality="input"', 'causality="input" initial="exact"'), ('<Real unit="s"/>', ''),
    ('<Real unit="s"/>', '<Real unit="s"/><Real/>'), ('<Real unit="s"/>', '<Integer/>'),
    (' initial="calculated"', ' initial="exact"'), ('<Unknown index="3"/>', ''),
    ('<Unknown index="3"/>', '<Unknown index="99999"/>'), ('<Unknown index="3"/>', '<Unknown index="0"/>'),
    ('<Unknown index="3"/>', '<Unknown valueReference="2"/>'), ('<InitialUnknowns>', '<Outputs>'),
    ('stepSize="', 'stepSize="-'), ('startTime="0"', 'startTime="1e9"'),
    ('<ModelStructure>', '<ModelStructure><Derivative/>'),
]


def describe(spoke, scenario, file, options):
    """Makes an FMU, checks its archive, and returns its model description, which is without faults."""
    subprocess.run([spoke, "fmu", scenario, "--out", file] + options, check=True,
                   stdout=subprocess.DEVNULL)
    with zipfile.ZipFile(file) as archive:
        text = archive.read("modelDescription.xml").decode()
        faults = faults_of(text) + list(find_archive_faults(archive, ET.fromstring(text)))
    assert not faults, (scenario, options, faults)
    return text


def check_rules(text, changes):
    """Checks that the rules find each of some changes."""
    for before, after in changes:
        assert before in text, before
        try:
            faults = faults_of(text.replace(before, after, 1))
        except ET.ParseError as error:
            faults = [error]
        assert faults, (before, after)


def main(spoke, models, work):
    os.makedirs(work, exist_ok=True)
    calm = ["--set", "wind={velocity=[12,0,0],shear_exponent=0.2,reference_height=90}", "initial={}"]
    for model, options in (("wu_haug_rotor", []), ("nrel_5mw_turbine", []), ("drone_rotor", []),
                           ("nrel_5mw_in_wind", calm),
                           ("solid_bracket", ["--output", "arm.tip", "--input", "none"])):
        scenario, file = os.path.join(models, model + ".toml"), os.path.join(work, model + ".fmu")
        three = describe(spoke, scenario, file, options)
        two = describe(spoke, scenario, file, options + ["--fmi", "2"])
        names = [[v["name"] for v in variables_of(ET.fromstring(text))] for text in (three, two)]
        assert names[0] == names[1], model
        if model == "wu_haug_rotor":
            check_rules(three, CHANGES)
            check_rules(two, CHANGES_2)


main(*sys.argv[1:])
