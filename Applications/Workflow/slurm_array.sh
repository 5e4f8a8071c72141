#!/usr/bin/env bash
# Meshes of many labelmaps by a Slurm array, for sites without Snakemake: Documentation/Clusters.md.
#
#   slurm_array.sh --tasks M INPUT OUTPUT_DIR [options of moserhex batch]
#     submits an array of M tasks, then a job that writes the summary; their words go to OUTPUT_DIR/log.
#   sbatch [options] --array=1-M slurm_array.sh INPUT OUTPUT_DIR [options of moserhex batch]
#     the array alone, with options of sbatch to one's liking.
#
# Each task works through every M-th case, as many at once as it has processors. Where tasks were stopped, do the same again: they
# go on where they were. Some tasks of M again: MOSERHEX_SHARDS=M sbatch --array=3,17 slurm_array.sh ...
# Account, partition, time, program: export SBATCH_ACCOUNT=... SBATCH_PARTITION=... SBATCH_TIMELIMIT=... MOSERHEX=/path/to/moserhex
#
# A minute before its time is over a task is told so: it ends the running cases and has written down which are done.
#SBATCH --job-name=moserhex
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=4
#SBATCH --mem-per-cpu=1500
#SBATCH --time=04:00:00
#SBATCH --signal=B:TERM@60
set -euo pipefail
program=${MOSERHEX:-moserhex}

fail() {
  echo "slurm_array.sh: $1" >&2
  exit 2
}

# Of batch's options those that say what a case is, which collect has, too: into the array list_options.
keep_list_options() {
  list_options=()
  while [ $# -gt 0 ]; do
    case $1 in
      --all-labels | --include=* | --exclude=* | --base=* | --keep-columns=* | --format=*) list_options+=("$1") ;;
      --include | --exclude | --base | --keep-columns | --format)
        list_options+=("$1" "${2:-}")
        shift
        ;;
    esac
    shift
  done
}

# The array, and the job that waits for it.
submit() {
  local tasks=$1 input=$2 folder=$3 array summary
  shift 3
  keep_list_options "$@"
  [[ $tasks =~ ^[1-9][0-9]*$ ]] || fail "--tasks $tasks: must be a number from 1"
  mkdir -p "$folder/log" # sbatch does not make it, and a job whose log cannot be opened does not start
  array=$(MOSERHEX_SHARDS=$tasks sbatch --parsable --array="1-$tasks" --output="$folder/log/%A_%a.out" \
    "$0" "$input" "$folder" "$@")
  summary=$(sbatch --parsable --job-name=moserhex-summary --ntasks=1 --mem=4000 --time=120 \
    --dependency="afterany:${array%%;*}" --output="$folder/log/%A.out" \
    --wrap="$(printf '%q ' exec "$program" collect "$folder" "${list_options[@]}" --cases "$input")")
  echo "job ${array%%;*}: $tasks tasks"
  echo "job ${summary%%;*}: $folder/summary.csv"
}

work() {
  local input=$1 folder=$2 tasks=${MOSERHEX_SHARDS:-}
  shift 2
  if [ -z "$tasks" ]; then
    tasks=$SLURM_ARRAY_TASK_COUNT
    if [ "$SLURM_ARRAY_TASK_MIN" -ne 1 ] || [ "$SLURM_ARRAY_TASK_MAX" -ne "$tasks" ]; then
      fail "an array of other tasks than 1 to M: set MOSERHEX_SHARDS=M"
    fi
  fi
  # In place of this shell, so that signals reach it.
  exec "$program" batch "$input" --output "$folder" --shard "$SLURM_ARRAY_TASK_ID/$tasks" \
    --jobs "${SLURM_CPUS_PER_TASK:-1}" --threads 1 --memory-limit "${SLURM_MEM_PER_CPU:-1500}" --quiet "$@"
}

if [ -n "${SLURM_ARRAY_TASK_ID:-}" ]; then
  [ $# -ge 2 ] || fail "no INPUT and OUTPUT_DIR"
  work "$@"
elif [ "${1:-}" = --tasks ] && [ $# -ge 4 ]; then
  shift
  submit "$@"
else
  fail "usage: slurm_array.sh --tasks M INPUT OUTPUT_DIR [options of moserhex batch]"
fi
