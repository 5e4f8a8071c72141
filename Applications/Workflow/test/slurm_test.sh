#!/usr/bin/env bash
# slurm_test.sh MOSERHEX WORKFLOW WORK: the workflow and the array script on a Slurm cluster of one node, which is started for it.
# Exit status 77: not possible here.
set -euo pipefail
moserhex=$1
workflow=$2
work=$3
here=$(cd "$(dirname "$0")" && pwd)
. "$here/common.sh"

command -v snakemake > /dev/null || skip "no snakemake (Debian's package of that name)"
rm -rf "$work"
mkdir -p "$work"
cd "$work"
cluster=$(mktemp -d /tmp/moserhex-slurm.XXXXXX) # short, as a socket's path must be
stop_cluster() {
  "$here/one_node_slurm.sh" stop "$cluster"
  rm -rf "$cluster"
}
trap stop_cluster EXIT
trap 'exit 1' HUP INT TERM
started=0
"$here/one_node_slurm.sh" start "$cluster" > cluster.txt 2>&1 || started=$?
[ $started -ne 77 ] || skip "$(tail -n 1 cluster.txt)"
[ $started -eq 0 ] || fail "the cluster does not start: $(tail -n 3 cluster.txt)"
export SLURM_CONF=$cluster/slurm.conf
export CI=true # snakemake then looks for ended jobs every second, not every ten

python3 "$here/make_cases.py" data 20 case-02

echo "== twenty cases, one of them bad, one of which the job is cancelled once"
cat > once.sh << EOF
#!/bin/sh
case "\$1 \$2" in "mesh data/case-07.nrrd")
  if [ ! -e $work/was-cancelled ]; then
    touch $work/was-cancelled
    scancel "\$SLURM_JOB_ID"
    sleep 30
  fi
esac
exec $moserhex "\$@"
EOF
chmod +x once.sh
write_settings ./once.sh
expect_status 1 run_snakemake slurm
expect_in output "1 of 20 cases have no mesh: see meshes/summary.csv"
expect_in output "Trying to restart job"
expect_number "$(grep -c 'Trying to restart job' output)" 1 "jobs that were tried again"
expect_all_but_the_bad_one meshes 20
[ -e was-cancelled ] || fail "no job was cancelled"

echo "== the same again makes nothing new"
state_of meshes > before
expect_status 1 run_snakemake slurm
expect_in output "1 of 20 cases have no mesh: see meshes/summary.csv"
if grep -q '^rule mesh' output; then
  fail "a case was run again"
fi
state_of meshes | cmp - before

echo "== two shards"
write_settings "$moserhex"
expect_status 1 run_snakemake slurm --config output=shards shards=2
expect_in output "1 of 20 cases have no mesh: see shards/summary.csv"
expect_all_but_the_bad_one shards 20

echo "== an array of two tasks and the job with the summary"
export MOSERHEX=$moserhex
expect_status 0 "$workflow/slurm_array.sh" --tasks 2 data/cases.csv array --shells 3
expect_in output "2 tasks"
for _ in $(seq 60); do
  [ "$(squeue --noheader | wc -l)" -ne 0 ] || break
  sleep 1
done
cat array/log/* > output
expect_all_but_the_bad_one array 20

echo "== by whichever way, the same meshes"
for folder in shards array; do
  for mesh in meshes/*.vtu; do
    cmp "$mesh" "$folder/${mesh#meshes/}"
  done
done
