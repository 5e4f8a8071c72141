# Shared by the tests of the workflow: sourced, not run. $moserhex, $workflow and $work are set before.

skip() {
  echo "skipped: $1"
  exit 77
}

fail() {
  echo "FAILED: $1" >&2
  exit 1
}

# expect_status WANTED COMMAND...: runs it; its words are in the file output.
expect_status() {
  local wanted=$1 status=0
  shift
  "$@" > output 2>&1 || status=$?
  if [ "$status" -ne "$wanted" ]; then
    tail -n 60 output >&2
    fail "exit status $status instead of $wanted: $*"
  fi
}

expect_in() {
  grep -qF -- "$2" "$1" || {
    tail -n 60 "$1" >&2
    fail "\"$2\" is not in $1"
  }
}

expect_number() {
  [ "$1" -eq "$2" ] || fail "$3: $1 instead of $2"
}

meshes_in() {
  find "$1" -name '*.vtu' -not -name '.*' | wc -l
}

# expect_all_but_the_bad_one FOLDER COUNT: a mesh and a row of each case, but of case-02 the reason why not.
expect_all_but_the_bad_one() {
  expect_number "$(meshes_in "$1")" $(($2 - 1)) "meshes in $1"
  expect_number "$(grep -c '^case-[0-9]*\.vtu,done,' "$1/summary.csv")" $(($2 - 1)) "cases that are done in $1/summary.csv"
  expect_in "$1/summary.csv" "case-02.vtu,failed,E_TRUNCATED,"
  [ ! -e "$1/case-02.vtu" ] || fail "a mesh of the bad case in $1"
  expect_in "$1/case-02.json" E_TRUNCATED
}

# What files of meshes there are, and when they were written.
state_of() {
  find "$1" -name 'case-*.vtu' -printf '%p %T@\n' | sort
}

run_snakemake() {
  local profile=$1
  shift
  snakemake --snakefile "$workflow/Snakefile" --profile "$workflow/profiles/$profile" --configfile settings.yaml "$@"
}

write_settings() {
  cat > settings.yaml << EOF
inputs: data/cases.csv
output: meshes
mesh_options: --shells 3
moserhex: $1
EOF
}
