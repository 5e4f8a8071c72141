# The workflow's settings and its list of cases. Which cases there are and what their files are called is said by moserhex alone.
import csv
import os
import shlex
import subprocess

from snakemake.common import Mode
from snakemake.exceptions import WorkflowError

# Jobs read this file, too, once each: only the first process lists the cases and asks for further attempts.
IS_FIRST_PROCESS = workflow.mode == Mode.default

MOSERHEX = config["moserhex"]
OUTPUT = os.path.normpath(config["output"])
INPUTS = [config["inputs"]] if isinstance(config["inputs"], str) else list(config["inputs"])
LIST_OPTIONS = shlex.split(config["list_options"])
MESH_OPTIONS = shlex.split(config["mesh_options"])
SHARDS = int(config["shards"])
RETRIES = int(config["retries"]) if IS_FIRST_PROCESS else 0

SUMMARY = os.path.join(OUTPUT, "summary.csv")
FIGURES = os.path.join(OUTPUT, "summary.json")
STATE = os.path.join(OUTPUT, ".workflow")
CASE_TABLE = os.path.join(STATE, "cases.tsv")
BATCH = shlex.join([MOSERHEX, "batch", *INPUTS, "--output", OUTPUT, *LIST_OPTIONS, *MESH_OPTIONS])
COLLECT = shlex.join([MOSERHEX, "collect", OUTPUT, "--cases", *INPUTS, *LIST_OPTIONS])


def list_cases():
    """Writes the table of cases. One that did not change keeps its time, for which Snakemake looks."""
    os.makedirs(STATE, exist_ok=True)
    new_table = f"{CASE_TABLE}.{os.getpid()}"
    command = f"{BATCH} --list-cases {shlex.quote(new_table)}"
    outcome = subprocess.run(command, shell=True, stdout=subprocess.DEVNULL).returncode
    if outcome != 0:
        raise WorkflowError(f"No list of cases: exit status {outcome} of {command}")
    if os.path.exists(CASE_TABLE) and same_bytes(CASE_TABLE, new_table):
        os.remove(new_table)
    else:
        os.replace(new_table, CASE_TABLE)


def same_bytes(one, other):
    with open(one, "rb") as a, open(other, "rb") as b:
        return a.read() == b.read()


def read_cases():
    """The rows of the table by what a report is called below the output folder, without its ending."""
    with open(CASE_TABLE, newline="", encoding="utf-8") as table:
        rows = list(csv.DictReader(table, delimiter="\t", quoting=csv.QUOTE_NONE))
    return {os.path.relpath(row["report"], OUTPUT)[: -len(".json")]: row for row in rows}


def say_outcome():
    """Fails where the summary has cases without a mesh."""
    with open(SUMMARY, newline="", encoding="utf-8") as table:
        status = [row["status"] for row in csv.DictReader(table)]
    meshes = status.count("done")
    if meshes < len(status):
        raise WorkflowError(f"{len(status) - meshes} of {len(status)} cases have no mesh: see {SUMMARY}")
    print(f"{meshes} cases, {meshes} meshes: {SUMMARY}")


if IS_FIRST_PROCESS:
    list_cases()
CASES = {} if SHARDS > 0 else read_cases()
