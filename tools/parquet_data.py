#!/usr/bin/env python3
"""Writes the Parquet files of `tests/fit/files`, as data frames write them. Needs pandas, pyarrow and polars."""

import pathlib

import pandas
import polars
import pyarrow
import pyarrow.parquet

FOLDER = pathlib.Path(__file__).parent.parent / "tests" / "fit" / "files"


def main():
    FOLDER.mkdir(parents=True, exist_ok=True)
    frame = pandas.DataFrame(
        {
            "t in s": [0.0, 0.5, 1.0],
            "x in m": [1.0, None, -2.5],
            "count": pandas.array([1, None, 3], dtype="Int16"),
            "single": pandas.Series([0.5, 0.25, 0.125], dtype="float32"),
        }
    )
    # Snappy is what pandas chooses.
    frame.to_parquet(FOLDER / "pandas.parquet", engine="pyarrow", index=False)
    # A frame's index becomes the last column.
    indexed = frame.rename(columns={"t in s": "t"}).set_index("t")
    indexed.to_parquet(FOLDER / "index.parquet", engine="pyarrow", compression=None)
    polars.DataFrame({"t": [0, 1], "x": [1.0, 2.0]}).write_parquet(FOLDER / "zstd.parquet")
    table = pyarrow.table({"t": [0.0, 1.0], "name": ["a", "b"]})
    pyarrow.parquet.write_table(table, FOLDER / "words.parquet")
    dates = pandas.to_datetime(["2026-01-01", "2026-01-02"])
    pandas.DataFrame({"t": dates, "x": [1.0, 2.0]}).to_parquet(FOLDER / "dates.parquet", engine="pyarrow")
    table = pyarrow.table({"t": [0.0, None], "x": [1.0, float("nan")]})
    pyarrow.parquet.write_table(table.select(["t"]), FOLDER / "no_time.parquet")
    pyarrow.parquet.write_table(table.select(["x"]), FOLDER / "not_a_number.parquet")


if __name__ == "__main__":
    main()
