#!/usr/bin/env bash
# Compresses the sample prostate between two faces of the cube with CalculiX, on ever finer meshes, and prints the force.
#
#   compress.sh [MOSERHEX [FOLDER [PADDING]]]      the program (moserhex), where the files go (a folder of its own), layers
#                                                  of pillow cells around the lattice (0)
#
# FACE_K0 (Inferior) is held, FACE_K1 (Superior) is moved down by 1 mm; E = 15 kPa, nu = 0.3, small strains. Units: mm, kPa,
# so forces are in mN. Ends with 0 when the force settles: every refinement changes it less than the one before, and the
# last by less than 2 %; and when CalculiX finds the volume that moserhex reports. 77: no CalculiX.
set -euo pipefail
moserhex=$(realpath "$(command -v "${1:-moserhex}")")
folder=${2:-$(mktemp -d)}
padding=${3:-0}
if ! command -v ccx > /dev/null; then
  echo "CalculiX (ccx, Debian package calculix-ccx) is not installed: nothing is compressed." >&2
  exit 77
fi
mkdir -p "$folder"
"$moserhex" sample "$folder" --quiet
cd "$folder"
for shells in 6 8 10 12; do
  "$moserhex" mesh prostate.nrrd "mesh$shells.inp" --shells $shells --padding "$padding" --quiet
  cat > "compress$shells.inp" << END
*INCLUDE, INPUT=mesh$shells.inp
*MATERIAL, NAME=TISSUE
*ELASTIC
15.0, 0.3
*SOLID SECTION, ELSET=ALL, MATERIAL=TISSUE
*STEP
*STATIC
*BOUNDARY
FACE_K0, 1, 3, 0.0
FACE_K1, 1, 2, 0.0
FACE_K1, 3, 3, -1.0
*NODE PRINT, NSET=FACE_K1, TOTALS=ONLY
RF
*EL PRINT, ELSET=ALL, TOTALS=ONLY
EVOL
*END STEP
END
  ccx "compress$shells" > "compress$shells.log"
  awk -v n=$((2 * shells - 1)) -v padding="$padding" -v shells=$shells '/total force/ { what = "force"; next } /total volume/ { what = "volume"; next }
    NF && what == "force" { force = $3; what = "" } NF && what == "volume" { volume = $1; what = "" }
    END { print shells, n ^ 3 + 6 * n ^ 2 * padding, force, volume }' "compress$shells.dat"
done > forces.txt
"$moserhex" quality mesh12.inp --json quality.json --quiet
reported=$(awk -F'[:,]' '/"volume_mm3"/ { print $2; exit }' quality.json)
awk -v reported="$reported" 'BEGIN { print "shells   cells   force [mN]   change   volume [mm^3]"; good = 1 }
  { change = before ? ($3 / before - 1) * 100 : 0
    printf "%6d  %6d  %11.2f  %6.2f %%  %14.4f\n", $1, $2, $3, change, $4
    size = change < 0 ? -change : change
    if (NR > 2 && !(size < last)) good = 0
    last = NR > 1 ? size : 1e9; before = $3
    error = ($4 - reported) / reported; if (error > 1e-6 || error < -1e-6) good = 0 }
  END { if (NR != 4 || !(last < 2)) good = 0
    print good ? "The force settles, and CalculiX finds the volume " reported " of moserhex." : "The force does NOT settle, or the volumes differ."
    exit !good }' forces.txt
