#!/usr/bin/env bash
# Builds the module for Python in an environment of its own, and runs its tests.
set -euo pipefail
cd "$(dirname "$0")/.."

environment=$PWD/target/python
[ -x "$environment/bin/jupyter-execute" ] || {
    # Some distributions split `venv` off.
    python3 -m venv "$environment" || {
        python3 -m pip install --quiet --user virtualenv
        python3 -m virtualenv --quiet "$environment"
    }
    "$environment/bin/pip" install --quiet "maturin>=1.9,<2" "numpy>=2" scipy pandas polars matplotlib pytest \
        nbclient ipykernel
}
# The checks of `lagrange-jit` compile the same crates.
export CARGO_TARGET_DIR=$PWD/target/beside CARGO_INCREMENTAL=0 VIRTUAL_ENV=$environment
cd crates/lagrange-python
"$environment/bin/maturin" develop --quiet --locked
"$environment/bin/python" -m pytest --quiet tests "$@"
