"""Modules of C, compiled and called without a wrapper."""

import ctypes
import re
import shutil
import subprocess

import lagrange
import numpy as np
import pytest

from test_lagrange import BALL, CART, DOUBLE


@pytest.mark.skipif(shutil.which("cc") is None, reason="there is no C compiler")
@pytest.mark.parametrize("text", [DOUBLE, CART, BALL])
def test_modules_of_c_are_called_by_ctypes(tmp_path, text):
    system = lagrange.System(text)
    header, source = system.c()
    name = re.search(r'#include "(\w+)\.h"', source)[1]
    (tmp_path / f"{name}.h").write_text(header)
    (tmp_path / f"{name}.c").write_text(source)
    library = tmp_path / "module.so"
    flags = ["-std=c99", "-O2", "-shared", "-fPIC", "-ffp-contract=off"]
    subprocess.run(["cc", *flags, "-o", library, tmp_path / f"{name}.c", "-lm"], check=True)
    module = ctypes.CDLL(str(library))
    fields, y = np.array([*system.parameters.values()]), np.linspace(0.3, 0.8, len(system.state_names))

    def call(function, size):
        pointer, out = ctypes.POINTER(ctypes.c_double), np.zeros(size)
        arrays = [array.ctypes.data_as(pointer) for array in (y, fields, out)]
        getattr(module, f"{name}_{function}")(ctypes.c_double(0.5), *arrays)
        return out

    np.testing.assert_allclose(call("rhs", len(y)), system.rhs(0.5, y), rtol=1e-15)
    mass = system.mass_matrix(0.5, y)
    np.testing.assert_allclose(call("mass_matrix", mass.size).reshape(mass.shape), mass, rtol=1e-15)
    np.testing.assert_allclose(call("energy", 1)[0], system.energy(0.5, y), rtol=1e-15)
    names = (ctypes.c_char_p * len(y)).in_dll(module, f"{name}_state_names")
    assert [entry.decode() for entry in names] == system.state_names
