#!/usr/bin/env bash
# Exports systems as units of the Functional Mock-up Interface, and compares their motions, in an environment of its own.
# The command `lagrange` is built, unless one is given.
set -euo pipefail
cd "$(dirname "$0")/.."

environment=$PWD/target/fmi
"$environment/bin/python" -c "import fmpy, scipy" 2>/dev/null || {
    # Some distributions split `venv` off.
    python3 -m venv "$environment" || {
        python3 -m pip install --quiet --user virtualenv
        python3 -m virtualenv --quiet "$environment"
    }
    "$environment/bin/pip" install --quiet "fmpy>=0.3.20" "numpy>=2" scipy
}
[ $# -gt 0 ] || cargo build --quiet --locked -p lagrange-cli
command=${1:-${CARGO_TARGET_DIR:-target}/debug/lagrange}
"$environment/bin/python" tools/fmi_check.py "$command"

# Other programs that import units, as far as they are to be had for this platform.
"$environment/bin/python" -c "import libcosimpy" 2>/dev/null ||
    "$environment/bin/pip" install --quiet "libcosimpy>=0.0.6" "ecospy>=0.7.2" tbb ||
    echo "libcosim and Ecos could not be installed"
"$environment/bin/python" tools/fmi_importers.py "$command"
