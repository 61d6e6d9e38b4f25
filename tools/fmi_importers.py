#!/usr/bin/env python3
"""Runs units in programs other than FMPy, and compares their motions with `lagrange simulate`.

    tools/fmi_importers.py PATH_OF_LAGRANGE

The programs are libcosim, which reads version 2.0 by the FMI Library, and Ecos, which reads 2.0 and 3.0 by fmi4c:
`pip install libcosimpy ecospy tbb`. One that is missing is skipped with a word about it.
"""

import ctypes
import importlib.util
import sys
import sysconfig
import tempfile
from pathlib import Path

import numpy as np

from fmi_check import EVERY, SYSTEMS, assignments, command, expected

NANOSECONDS = 1_000_000_000
# These programs pass no tolerance, so that units integrate with theirs, 1e-10.
LARGEST = 1e-8


def by_libcosim(unit, names, times):
    """Returns the columns of these names at these times."""
    from libcosimpy.CosimExecution import CosimExecution
    from libcosimpy.CosimLogging import CosimLogLevel, log_output_level
    from libcosimpy.CosimObserver import CosimObserver
    from libcosimpy.CosimSlave import CosimLocalSlave

    log_output_level(CosimLogLevel.FATAL)
    execution = CosimExecution.from_step_size(step_size=round(EVERY * NANOSECONDS))
    slave = execution.add_local_slave(CosimLocalSlave(fmu_path=str(unit), instance_name="unit"))
    observer = CosimObserver.create_last_value()
    execution.add_observer(observer=observer)
    found = {entry.name.decode(): entry.reference for entry in execution.slave_variables(slave_index=slave)}
    references, rows = [found[name] for name in names], []
    for time in times:
        assert execution.simulate_until(target_time=round(time * NANOSECONDS)), f"{unit.name} fails at {time}"
        rows.append(list(observer.last_real_values(slave_index=slave, variable_references=references)))
    return np.array(rows).T


def by_ecos(unit, names, times):
    """Returns the columns of these names at these times."""
    # Ecos needs this library, which a package installs where the loader does not look.
    for library in Path(sysconfig.get_path("data"), "lib").glob("libtbb.so.*"):
        ctypes.CDLL(str(library), mode=ctypes.RTLD_GLOBAL)
    from ecospy import EcosSimulation, EcosSimulationStructure

    structure = EcosSimulationStructure()
    structure.add_model("unit", str(unit))
    rows = []
    with EcosSimulation(structure=structure, step_size=EVERY) as simulation:
        simulation.init()
        for time in times:
            simulation.step(round((time - simulation.get_time()) / EVERY))
            rows.append([simulation.get_real(f"unit::{name}") for name in names])
    return np.array(rows).T


# Module, function, and versions of the standard.
PROGRAMS = {"libcosim": ("libcosimpy", by_libcosim, (2,)), "Ecos": ("ecospy", by_ecos, (2, 3))}


def compare(lagrange, folder, name):
    text, parameters, starts, inputs = SYSTEMS[name]
    file = folder / "system.lag"
    file.write_text(text)
    values = {**parameters, **inputs}
    reference = expected(lagrange, folder, file, values, starts)
    names, times = [column for column in reference if column != "t"], reference["t"][1:]
    scales = [max(1.0, np.abs(reference[column]).max()) for column in names]
    for program, (module, run, versions) in PROGRAMS.items():
        if importlib.util.find_spec(module) is None:
            continue
        for version in versions:
            unit = folder / f"{name.replace(' ', '_')}_{version}.fmu"
            options = assignments("set", values) + assignments("start", starts)
            command(lagrange, "fmu", file, "--fmi", version, "-o", unit, *options)
            found = run(unit, names, times)
            apart = [np.abs(column - reference[column_name][1:]).max() for column, column_name in zip(found, names)]
            difference = max(part / scale for part, scale in zip(apart, scales))
            print(f"{name:16} FMI {version}.0   {program} {difference:.1e}", flush=True)
            assert difference < LARGEST, f"{name} in {program}"


def main():
    for program, (module, _, _) in PROGRAMS.items():
        if importlib.util.find_spec(module) is None:
            print(f"{program} skipped: `pip install {module}`")
    with tempfile.TemporaryDirectory() as folder:
        for name in SYSTEMS:
            compare(sys.argv[1], Path(folder), name)


if __name__ == "__main__":
    main()
