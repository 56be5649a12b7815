"""Python values as TOML: scenarios from dictionaries, and values that override keys."""

import json
import math

from ._spoke import InputError


def make_overrides(values):
    """{"blade.bodies": 8} as ["blade.bodies=8"], what --set takes."""
    return [f"{key}={_literal(value, key)}" for key, value in values.items()]


def make_toml(tables):
    """A dictionary as a TOML document."""
    return "".join(f"{_key(key)} = {_literal(value, key)}\n" for key, value in tables.items())


def _key(key):
    return json.dumps(str(key))


def _literal(value, key):
    if hasattr(value, "tolist"):  # of NumPy
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        return repr(value) if math.isfinite(value) else str(value)
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, dict):
        items = (f"{_key(k)} = {_literal(v, f'{key}.{k}')}" for k, v in value.items())
        return "{" + ", ".join(items) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_literal(item, key) for item in value) + "]"
    error = InputError(
        f"{key}: is a {type(value).__name__}, expected a number, text, list or dictionary")
    error.key = key
    raise error
