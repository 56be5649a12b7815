"""Arguments of a wrong type: a TypeError in one sentence, for all that is public.

The stub says what each argument is. It is read when a call has failed, so that calls that succeed
cost no more, and take what they took before.
"""

import ast
import functools
import inspect
import os
import pathlib
import types
import typing
from collections import abc

import numpy as np


def check_arguments(names):
    """Lets functions and classes of these public names explain arguments that they cannot take."""
    import spoke

    for name in names:
        member = getattr(spoke, name)
        if isinstance(member, type) and not issubclass(member, BaseException):
            _check_class(member)
        elif isinstance(member, (types.FunctionType, types.BuiltinFunctionType)):
            setattr(spoke, name, _checked(member, name))


def _check_class(found):
    for base in found.__mro__:
        if not base.__module__.startswith("spoke"):
            continue
        for name, member in list(vars(base).items()):
            called = f"{found.__name__}.{name}"
            if isinstance(member, property):
                if member.fset and not hasattr(member.fset, "__wrapped__"):
                    setattr(base, name, property(member.fget, _checked(member.fset, called),
                                                 doc=member.__doc__))
            elif (name in ("__getitem__", "__call__") or not name.startswith("_")
                  or name == "__init__" and base is found):
                if callable(member) and not hasattr(member, "__wrapped__"):
                    setattr(base, name, _checked(member, called))


def _checked(function, name):
    @functools.wraps(function)
    def call(*args, **kwargs):
        try:
            return function(*args, **kwargs)
        except KeyError:  # a mapping may be asked for any key
            raise
        except (TypeError, ValueError, AttributeError) as error:
            told = _explain(error, name, args, kwargs)
            if told is None:
                raise
            raise TypeError(told) from None

    return call


def _explain(error, name, args, kwargs):
    """A sentence about the arguments of a call that failed; None if they are as the stub says."""
    stub = _stub()
    if not stub:
        return None
    is_raw = isinstance(error, TypeError) and "incompatible" in str(error)
    expected = stub.get(name)
    owner, _, method = name.rpartition(".")
    called = f"{owner}.{method}()" if owner and method != "__init__" else f"spoke.{owner or name}()"
    if expected is None and method == "__init__" and isinstance(error, TypeError):
        return f"spoke.{owner} is not made by a call: functions of spoke return it"
    if expected is None:
        return None
    if not isinstance(expected, list):  # of an attribute
        return _misfit(name, args[1], expected)
    told = None
    for signature in expected:
        try:
            bound = signature.bind(*args, **kwargs)
        except TypeError as unbound:
            told = told or f"{called}: {unbound}, expected {_list(signature)}"
            continue
        misfits = (_misfit(argument, value, signature.parameters[argument].annotation)
                   for argument, value in bound.arguments.items())
        misfit = next(filter(None, misfits), None)
        if misfit:
            return f"{called}: {misfit}"
        given = ", ".join(f"{argument} = {_show(value)}"
                          for argument, value in bound.arguments.items() if argument != "self")
        return f"{called} cannot take {given}" if is_raw else None
    return told


def _list(signature):
    named = [name if parameter.default is parameter.empty else f"{name}=..."
             for name, parameter in signature.parameters.items() if name != "self"]
    return "(" + ", ".join(named) + ")"


@functools.cache
def _stub():
    """By name, "run" as "Simulation.run": the signatures of a function, or the type of an attribute."""
    import spoke

    path = pathlib.Path(__file__).with_name("__init__.pyi")
    if not path.exists():
        return {}
    names = {"__name__": "spoke", "__package__": "spoke", **vars(spoke)}
    found = {}

    def run(node):
        exec(compile(ast.Module([node], []), str(path), "exec"), names)

    def add(node, owner):
        if isinstance(node, ast.FunctionDef):
            if any(getattr(decorator, "id", "") == "property" for decorator in node.decorator_list):
                return
            node.decorator_list = []  # of overloads, which then follow one another
            run(node)
            found.setdefault(owner + node.name, []).append(inspect.signature(names[node.name]))
        elif owner and isinstance(node, ast.AnnAssign):
            annotation = ast.Expression(node.annotation)
            found[owner + node.target.id] = eval(compile(annotation, str(path), "eval"), names)

    for node in ast.parse(path.read_text()).body:
        if isinstance(node, ast.ClassDef):
            for member in node.body:
                add(member, node.name + ".")
        elif isinstance(node, (ast.ImportFrom, ast.Import, ast.Assign)):
            run(node)
        else:
            add(node, "")
    return found


def _misfit(name, value, kind):
    """What is wrong with an argument, or with one of its elements; None if nothing is."""
    if _fits(value, kind):
        return None
    if _is_list(value):
        for one in _alternatives(kind):
            if typing.get_origin(one) is abc.Sequence:
                element, = typing.get_args(one)
                wrong = (_misfit(f"{name}[{k}]", item, element) for k, item in enumerate(value))
                told = next(filter(None, wrong), None)
                if told:
                    return told
    return f"{name} is {_show(value)}, expected {_words(kind)}"


def _show(value):
    text = " ".join(repr(value).split())
    return text if len(text) <= 60 else text[:57] + "..."


def _alternatives(kind):
    """The types of a union, each one for itself; a type alone."""
    if typing.get_origin(kind) is typing.Annotated:
        return _alternatives(typing.get_args(kind)[0])
    if typing.get_origin(kind) in (typing.Union, types.UnionType):
        return [one for part in typing.get_args(kind) for one in _alternatives(part)]
    return [kind]


def _is_list(value):
    return (hasattr(value, "__len__") and hasattr(value, "__getitem__")
            and not isinstance(value, (str, bytes, abc.Mapping))
            and not (isinstance(value, np.ndarray) and value.ndim == 0))


def _is_scalar(value):
    return not isinstance(value, np.ndarray) or value.ndim == 0


def _fits(value, kind):
    origin, parts = typing.get_origin(kind), typing.get_args(kind)
    if kind is typing.Any or kind is inspect.Parameter.empty:
        return True
    if origin in (typing.Union, types.UnionType):
        return any(_fits(value, part) for part in parts)
    if origin is typing.Annotated:
        return _fits(value, parts[0]) and len(value) == parts[1]
    if origin is abc.Sequence:
        return _is_list(value) and all(_fits(item, parts[0]) for item in value)
    if origin is tuple:
        return _is_list(value) and len(value) == len(parts) and all(map(_fits, value, parts))
    if origin is np.ndarray:
        return isinstance(value, np.ndarray) and value.ndim == 1 and value.dtype.kind in "biuf"
    if kind is float:
        return _is_scalar(value) and (hasattr(value, "__float__") or hasattr(value, "__index__"))
    if kind is int:
        return _is_scalar(value) and hasattr(value, "__index__")
    if kind is bool:
        return isinstance(value, (int, np.bool_))
    return callable(value) if origin is abc.Callable else isinstance(value, origin or kind)


_WORDS = {float: "a number", int: "a whole number", bool: "True or False", str: "text",
          types.NoneType: "None", abc.Mapping: "a dictionary", abc.Callable: "a function",
          os.PathLike: "a path", np.ndarray: "an array"}
_MANY = {float: "numbers", int: "whole numbers"}


def _words(kind):
    """What a type of the stub is, in words."""
    if typing.get_origin(kind) is typing.Annotated:
        return f"{typing.get_args(kind)[1]} numbers"
    told = list(dict.fromkeys(_words_of_one(one) for one in _alternatives(kind)))
    return " or ".join(filter(None, [", ".join(told[:-1]), told[-1]]))


def _words_of_one(kind):
    origin, parts = typing.get_origin(kind), typing.get_args(kind)
    if origin is abc.Sequence:
        element = parts[0]
        many = _MANY.get(element) or (f"{element.__name__}s" if isinstance(element, type)
                                      else f"items, each {_words(element)}")
        return f"a list of {many}"
    if origin is tuple:
        return f"a pair of {_MANY[parts[0]]}"
    name = (origin or kind).__name__
    return _WORDS.get(origin or kind) or ("an " if name[0] in "AEIOU" else "a ") + name
