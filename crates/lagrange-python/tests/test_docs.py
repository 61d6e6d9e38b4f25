"""The examples of the documentation run as printed."""

from pathlib import Path

import pytest

PAGE = Path(__file__).parents[3] / "docs" / "python.md"
EXAMPLES = [block.split("```")[0] for block in PAGE.read_text().split("```python\n")[1:]]


def test_the_page_has_examples():
    assert EXAMPLES


@pytest.mark.parametrize("example", EXAMPLES)
def test_examples_run(example, monkeypatch):
    # Plots are drawn, but not shown.
    monkeypatch.setenv("MPLBACKEND", "agg")
    exec(compile(example, str(PAGE), "exec"), {})
