#!/usr/bin/env bash
# Installs what is missing, checks the formatting, builds everything, runs the whole test suite; then the same for Core
# alone, without ITK.
# Usage: ./test.sh [ctest options], for example ./test.sh --label-regex HexMap
set -euo pipefail
cd "$(dirname "$0")"
. .ci/common.sh

# Independent readers of what is written; tests of them skip, saying so, where they are absent.
packages="$packages clang-format-14 calculix-ccx gmsh python3-meshio"
# The Python module and its tests are left out, saying so, where these are absent.
packages="$packages pybind11-dev python3-dev python3-numpy mricron-data"
# A Slurm cluster of one node, and Snakemake, for the test of the workflow; it skips, saying so, where they are absent.
packages="$packages munge slurmctld slurmd slurm-client snakemake"
# A browser for the tests of the HTML reports, which skip, saying so, where it is absent.
packages="$packages chromium fonts-dejavu-core"
# The manual as a site, and its validator.
packages="$packages doxygen furo python3-myst-parser python3-sphinx tidy"
install_packages
use_ccache
check_formatting
for preset in release core-only; do
  echo "== $preset"
  cmake --preset $preset -DMoserHex_BUILD_MANUAL=ON
  cmake --build --preset $preset --parallel "$(build_jobs)"
  ctest --preset $preset --parallel 2 "$@"
done
echo "All tests passed."
