"""The examples of the documentation run as printed."""

import doctest
from pathlib import Path

import lagrange
import pytest

CRATE = Path(__file__).parents[1]
PAGES = [CRATE / "README.md", CRATE.parents[1] / "docs" / "python.md"]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_examples_run(page, monkeypatch):
    # Plots are drawn, but not shown.
    monkeypatch.setenv("MPLBACKEND", "agg")
    examples = [block.split("```")[0] for block in page.read_text(encoding="utf-8").split("```python\n")[1:]]
    assert examples
    for example in examples:
        exec(compile(example, str(page), "exec"), {})


def test_examples_of_help_run():
    names = {}
    for documented in (lagrange, lagrange.System.ensemble):
        test = doctest.DocTestParser().get_doctest(documented.__doc__, names, str(documented), None, None)
        assert test.examples
        assert doctest.DocTestRunner().run(test, clear_globs=False).failed == 0
        names = test.globs
