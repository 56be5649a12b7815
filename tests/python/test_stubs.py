"""The stub says what the package has: the same names, and the same arguments."""

import ast
import inspect
import pathlib
import re

import pytest

import spoke

STUB = ast.parse((pathlib.Path(spoke.__file__).parent / "__init__.pyi").read_text())
CLASSES = {node.name: node for node in STUB.body if isinstance(node, ast.ClassDef)}
FUNCTIONS = {node.name: node for node in STUB.body if isinstance(node, ast.FunctionDef)}


def arguments_of(node):
    return [argument.arg for argument in node.args.args + node.args.kwonlyargs]


def arguments_found(function):
    try:
        return list(inspect.signature(function).parameters)
    except ValueError:  # of pybind11: its first line tells
        listed = re.search(r"\((.*)\)", function.__doc__.splitlines()[0]).group(1)
        return re.findall(r"(\w+): ", re.sub(r"\[[^\]]*\]", "", listed))


def test_the_stub_has_the_names_of_the_package():
    assert set(CLASSES) | set(FUNCTIONS) | {"model", "__version__"} == set(spoke.__all__)
    assert (pathlib.Path(spoke.__file__).parent / "py.typed").exists()


@pytest.mark.parametrize("name", sorted(CLASSES))
def test_a_class_has_the_names_of_its_stub(name):
    found = getattr(spoke, name)
    bases = [getattr(spoke, base.id, None) or getattr(__builtins__, base.id, object)
             for base in CLASSES[name].bases if isinstance(base, ast.Name)]
    body = [node for node in CLASSES[name].body]
    stubbed = {node.name for node in body if isinstance(node, ast.FunctionDef)}
    stubbed |= {node.target.id for node in body if isinstance(node, ast.AnnAssign)}
    public = {word for word in dir(found) if not word.startswith("_")}
    inherited = {word for base in bases + [BaseException, dict] for word in dir(base)}
    if name == "Result":  # its attributes are of the instance
        public |= {"t", "numbers", "units", "wall_time"}
    assert {word for word in stubbed if not word.startswith("_")} == public - inherited | (
        public & stubbed)
    for node in body:
        if isinstance(node, ast.FunctionDef) and not node.name.startswith("_"):
            member = inspect.getattr_static(found, node.name)
            is_property = any(getattr(d, "id", "") == "property" for d in node.decorator_list)
            assert is_property == isinstance(member, property), node.name
            assert member.__doc__ or getattr(member, "fget", member).__doc__, node.name
            if not is_property:
                assert arguments_of(node) == arguments_found(member), node.name


@pytest.mark.parametrize("name", sorted(FUNCTIONS))
def test_a_function_has_the_arguments_of_its_stub(name):
    assert arguments_of(FUNCTIONS[name]) == arguments_found(getattr(spoke, name))
    assert getattr(spoke, name).__doc__
