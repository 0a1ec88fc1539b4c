#!/usr/bin/env bash
# The shipped Snakefile for real: two local cores, then a submit script; both find what one process finds.
# usage: snakemake.sh TWOFOLD SOURCE_DIR
set -euo pipefail
twofold=$(realpath "$1") source=$(realpath "$2")  # jobs run in folders of their own
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
command -v snakemake >/dev/null || { echo "snakemake is missing; on Debian: apt-get install snakemake" >&2; exit 1; }
tiny=("$source/scenes/sphere-lobe.json" --study "$source/tests/study/tiny_study.json" -q)
"$twofold" study "${tiny[@]}" -o "$work/whole" >/dev/null 2>&1 || [ $? -eq 1 ]

drive() {
    local out=$1
    shift
    snakemake -s "$source/study/Snakefile" -d "$work" --quiet --nolock "$@" --config twofold="$twofold" \
        scene="$source/scenes/sphere-lobe.json" study="$source/tests/study/tiny_study.json" out="$out" shards=3
    [ -s "$out/report.html" ]
}
drive "$work/local" --cores 2
export TWOFOLD_SUBMITTED=$work/submitted
drive "$work/cluster" --jobs 2 --latency-wait 30 --cluster "$source/tests/study/submit.sh"
[ "$(wc -l <"$work/submitted")" -eq 4 ] || { echo "FAILED: not three shards and a report were submitted" >&2; exit 1; }
"$source/tests/study/same_cells.py" "$work/whole/cells" "$work/local/cells" "$work/cluster/cells"
