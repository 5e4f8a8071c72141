#!/usr/bin/env bash
# Installs what is missing, builds the command, makes the sample prostate, meshes it, and says where the report and the mesh are.
# Usage: ./demo.sh [FOLDER]     FOLDER for the results, default moserhex-demo
set -euo pipefail
results=$(realpath -m "${1:-$(dirname "$0")/moserhex-demo}")
cd "$(dirname "$0")"
. .ci/common.sh

install_packages
use_ccache
cmake --preset release > /dev/null
cmake --build --preset release --target moserhex --parallel "$(build_jobs)"
moserhex=$PWD/build/release/Applications/MoserHex/moserhex

echo
"$moserhex" sample "$results"
echo
"$moserhex" mesh "$results/prostate.nrrd" "$results/prostate.vtu" --report "$results/prostate.html"
echo
echo "The report: $results/prostate.html"
echo "Open it in a browser: it says whether the mesh can be trusted and why, and has the mesh in 3-D. It needs no network."
echo
echo "The mesh itself, $results/prostate.vtu, opens in ParaView and 3D Slicer. The same for your own labelmap:"
echo "  $moserhex mesh YOUR.nii.gz OUTPUT.vtu --report OUTPUT.html"
