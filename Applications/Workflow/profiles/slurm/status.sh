#!/usr/bin/env bash
# status.sh JOB: success, running or failed, for snakemake --cluster-status.
#
# From the controller; from the accounts, where there are any, once the controller has forgotten the job (MinJobAge, five minutes
# unless set). A controller that does not answer says nothing about the job, which then counts as running.
set -u
job=${1%%;*} # of "job;cluster"

if answer=$(scontrol --oneliner show job "$job" 2>&1); then
  state=$(sed -n 's/.*JobState=\([A-Z_]*\).*/\1/p' <<< "$answer")
elif [[ $answer == *"Invalid job id"* ]]; then
  state=$(sacct --allocations --noheader --parsable2 --format=State --jobs="$job" 2> /dev/null | head -n 1)
  state=${state:-GONE}
else
  state=UNKNOWN
fi
case $state in
  COMPLETED) echo success ;;
  PENDING | CONFIGURING | RUNNING | COMPLETING | STAGE_OUT | SUSPENDED | STOPPED | SIGNALING | RESIZING | REQUEUED | REQUEUE_HOLD | \
    REQUEUE_FED | SPECIAL_EXIT | RESV_DEL_HOLD | UNKNOWN) echo running ;;
  *) echo failed ;;
esac
