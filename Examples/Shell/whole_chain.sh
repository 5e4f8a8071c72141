#!/usr/bin/env bash
# From labelmaps to an atlas, by the command alone: sample, mesh, quality, transfer, compare, atlas, figures.
#
#   whole_chain.sh [MOSERHEX [FOLDER [SHELLS]]]     the program (moserhex), where the files go (a folder of its own), 10
#
# Put your own labelmaps in place of the sample's. Ends with 0 when every step did, and its results are there.
set -euo pipefail
moserhex=$(realpath "$(command -v "${1:-moserhex}")")
folder=${2:-$(mktemp -d)}
shells=${3:-10}
mkdir -p "$folder"
cd "$folder"

echo "== labelmaps"
"$moserhex" sample .

echo "== meshes: the follow-up is tied to the baseline"
mkdir -p meshes
"$moserhex" mesh prostate.nrrd meshes/baseline.vtu --shells "$shells" --report meshes/baseline.json --quiet
"$moserhex" mesh prostate_followup.nrrd meshes/followup.vtu --shells "$shells" --template meshes/baseline.vtu \
  --report meshes/followup.json --quiet

echo "== quality"
for visit in baseline followup; do
  "$moserhex" quality "meshes/$visit.vtu" --json "quality_$visit.json" --quiet
  "$moserhex" figure "meshes/$visit.vtu" "quality_$visit.png" --title "Scaled Jacobian, $visit"
done

echo "== zones of the baseline, in the cube and in the follow-up"
"$moserhex" transfer prostate_zones.nrrd --mesh meshes/baseline.vtu --labels --to-cube zones_cube.nrrd
"$moserhex" transfer prostate_zones.nrrd --mesh meshes/baseline.vtu --labels --to-mesh meshes/followup.vtu \
  --to-image zones_followup.nrrd --like prostate_followup.nrrd

echo "== what has changed"
"$moserhex" compare meshes/baseline.vtu meshes/followup.vtu --align none --times 0,12 --output change

echo "== the mean"
"$moserhex" atlas meshes --output atlas
"$moserhex" figure atlas/mean.vtu mean.png --kind shells --colour shell --title "The mean"

for file in quality_baseline.json quality_followup.png zones_cube.nrrd zones_followup.nrrd change/regions.csv change/series.pvd \
  atlas/mean.vtu mean.png; do
  test -s "$file" || { echo "$folder/$file is missing" >&2; exit 1; }
done
echo "All files are in $folder"
