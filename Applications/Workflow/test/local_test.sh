#!/usr/bin/env bash
# local_test.sh MOSERHEX WORKFLOW WORK: the workflow on this machine, and what judge.sh and status.sh say. Exit status 77: no snakemake.
set -euo pipefail
moserhex=$1
workflow=$2
work=$3
here=$(cd "$(dirname "$0")" && pwd)
. "$here/common.sh"

rm -rf "$work"
mkdir -p "$work"
cd "$work"

echo "== what is an answer, and what is tried again"
judged() { # judged STATUS_OF_COMMAND WORDS LAST
  local status=0
  "$workflow/judge.sh" "$3" judge.log sh -c "echo '$2' >&2; exit $1" 2> /dev/null || status=$?
  echo $status
}
expect_number "$(judged 0 '' 0)" 0 "a mesh"
expect_number "$(judged 3 'error: a: no voxels [E_TRUNCATED]' 0)" 0 "a refusal"
expect_number "$(judged 4 'error: a: not exact [E_NOT_EXACT]' 0)" 0 "no mesh"
expect_number "$(judged 4 'error: a: no memory [E_MEMORY]' 0)" 4 "no memory"
expect_number "$(judged 4 'error: a: no memory [E_MEMORY]' 1)" 0 "no memory at the last attempt"
expect_number "$(judged 1 'warning: a: too slow [E_TIMEOUT]' 0)" 1 "a batch that lacked time"
expect_number "$(judged 74 'error: a: disk full [E_IO]' 1)" 74 "a full disk"
expect_number "$(judged 137 '' 1)" 137 "a process that was killed"

echo "== states of jobs"
mkdir -p bin
cat > bin/scontrol << 'EOF'
#!/bin/sh
[ -n "$ANSWER" ] || { echo "$COMPLAINT" >&2; exit 1; }
echo "JobId=$4 JobState=$ANSWER Reason=None"
EOF
printf '#!/bin/sh\necho "$ACCOUNT"\n' > bin/sacct
chmod +x bin/scontrol bin/sacct
state() { PATH=$work/bin:$PATH "$workflow/profiles/slurm/status.sh" "7;cluster"; }
export ANSWER COMPLAINT ACCOUNT
for ANSWER in PENDING RUNNING COMPLETING REQUEUED; do [ "$(state)" = running ] || fail $ANSWER; done
for ANSWER in FAILED TIMEOUT OUT_OF_MEMORY NODE_FAIL CANCELLED PREEMPTED; do [ "$(state)" = failed ] || fail $ANSWER; done
ANSWER=COMPLETED && [ "$(state)" = success ] || fail $ANSWER
ANSWER=
COMPLAINT="slurm_load_jobs error: Unable to contact slurm controller (connect failure)"
[ "$(state)" = running ] || fail "a controller that does not answer"
COMPLAINT="slurm_load_jobs error: Invalid job id specified"
[ "$(state)" = failed ] || fail "a job that nobody knows"
ACCOUNT=COMPLETED && [ "$(state)" = success ] || fail "a job that the accounts know"

command -v snakemake > /dev/null || skip "no snakemake (Debian's package of that name)"
python3 "$here/make_cases.py" data 4 case-02
write_settings "$moserhex"

echo "== a dry run names the cases and makes none"
expect_status 0 run_snakemake local --dry-run
expect_number "$(grep -c '^rule mesh' output)" 4 "jobs"
expect_number "$(meshes_in .)" 0 "meshes"

echo "== a job for each case"
expect_status 1 run_snakemake local
expect_in output "1 of 4 cases have no mesh: see meshes/summary.csv"
expect_all_but_the_bad_one meshes 4

echo "== another option for all: all again"
expect_status 0 run_snakemake local --dry-run --config mesh_options="--shells 4"
expect_number "$(grep -c '^rule mesh' output)" 4 "jobs"

echo "== the bad case is mended: it alone is run"
python3 "$here/make_cases.py" mended 2
cp mended/case-02.nrrd data/
expect_status 0 run_snakemake local
expect_number "$(grep -c '^rule mesh' output)" 1 "jobs"
expect_in output "4 cases, 4 meshes: meshes/summary.csv"

echo "== shards"
expect_status 0 run_snakemake local --config shards=2 output=shards
expect_number "$(meshes_in shards)" 4 "meshes"

echo "== a program that dies is tried again, then the case is missing"
printf '#!/bin/sh\ncase "$1 $2" in "mesh data/case-03.nrrd") kill -SEGV $$ ;; esac\nexec %s "$@"\n' "$moserhex" > dies.sh
chmod +x dies.sh
expect_status 1 run_snakemake local --config output=crash moserhex=./dies.sh retries=1
expect_number "$(grep -c 'Trying to restart job' output)" 1 "attempts after the first"
expect_in crash/summary.csv "case-03.vtu,missing,"
expect_number "$(meshes_in crash)" 3 "meshes"

echo "== cases that lack memory get more"
for shards in 0 1; do
  expect_status 0 run_snakemake local --config output=memory-$shards shards=$shards memory_mb=40 retries=4
  expect_in output "Trying to restart job"
  expect_number "$(meshes_in memory-$shards)" 4 "meshes"
done

echo "== no list"
expect_status 1 run_snakemake local --config inputs=nowhere.csv
expect_in output "No list of cases"
