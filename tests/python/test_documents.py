"""What the documents show runs: docs/python.md, the tutorial, the examples."""

import ast
import json
import re
import runpy

import pytest
from conftest import SOURCE

EXAMPLES = sorted((SOURCE / "examples/python").glob("*.py"))


def show(code, names):
    """Runs a cell as a notebook does: what its last expression is, is shown."""
    tree = ast.parse(code)
    last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, "cell", "exec"), names)
    if last is not None:
        value = eval(compile(ast.Expression(last.value), "cell", "eval"), names)
        return value._repr_html_() if hasattr(value, "_repr_html_") else repr(value)
    return None


def test_the_tutorial_runs_cell_by_cell():
    cells = json.loads((SOURCE / "docs/tutorial.ipynb").read_text())["cells"]
    code = ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"]
    assert len(code) > 5
    names = {}
    shown = [show(cell, names) for cell in code]
    assert sum("<iframe" in (text or "") for text in shown) == 3


def test_the_blocks_of_the_page_run(monkeypatch):
    monkeypatch.chdir(SOURCE)
    blocks = re.findall(r"```python\n(.*?)```", (SOURCE / "docs/python.md").read_text(), re.DOTALL)
    assert len(blocks) > 5
    names = {}
    for block in blocks:
        exec(compile(block, "docs/python.md", "exec"), names)


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda file: file.stem)
def test_an_example_runs(example):
    needed = {"scipy", "pandas"} & set(re.findall(r"^(?:from|import) (\w+)", example.read_text(),
                                                  re.MULTILINE))
    for package in needed:
        pytest.importorskip(package)
    runpy.run_path(str(example), run_name="__main__")


def test_no_output_is_kept_in_the_tutorial():
    cells = json.loads((SOURCE / "docs/tutorial.ipynb").read_text())["cells"]
    assert not any(cell.get("outputs") or cell.get("execution_count") for cell in cells)
