#!/usr/bin/env bash
# judge.sh LAST LOG COMMAND...
#
# Runs a command of moserhex, its words into LOG, and says by the exit status whether Snakemake is to try again: 0 when the case or
# the cases have their answers, meshes or refusals, which are the same every time; else the command's own.
# What lacked memory or time, crashed or could not read or write is tried again, unless LAST is 1: then that is the answer.
set -u
last=$1
log=$2
shift 2

"$@" > "$log" 2>&1
status=$?
case $status in
  0) exit 0 ;;
  1 | 3 | 4) # batch: some cases failed; mesh: bad input, no mesh
    if [ "$last" -eq 1 ] || ! grep -qE '\[E_(MEMORY|TIMEOUT|CRASH|INTERNAL|IO|CANTCREAT)\]' "$log"; then
      exit 0
    fi
    ;;
esac
tail -n 5 "$log" >&2
exit $status
