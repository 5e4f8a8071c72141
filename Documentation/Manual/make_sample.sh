#!/usr/bin/env bash
# What pages of the manual take for granted: the sample's labelmaps, small meshes of both visits, and their reports.
# Usage: make_sample.sh MOSERHEX FOLDER
set -euo pipefail
moserhex=$1
folder=$2
rm -rf "$folder"
"$moserhex" sample "$folder" --quiet
for visit in prostate prostate_followup; do
  "$moserhex" mesh "$folder/$visit.nrrd" "$folder/$visit.vtu" --shells 5 --report "$folder/$visit.json" --quiet
done
