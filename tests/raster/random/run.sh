#!/usr/bin/env bash
# A quarter of a million random states by the fast pipeline and by the reference, and a quarter as many whose units
# choose among levels of detail, one part for each core:
#   run.sh FAST_EQUALS_REFERENCE [STATES]
# Prints the totals of each part; exit 1 if any state differs. The default takes some three minutes on two cores.
set -euo pipefail
program=$1
states=${2:-253200}
parts=$(nproc)
count=$(((states + parts - 1) / parts))

pids=()
for ((part = 0; part < parts; part++)); do
    {
        "$program" --first $((part * count)) --count "$count" -o build/fast_failures &&
            "$program" --levels --first $((part * count)) --count $((count / 4)) -o build/fast_failures
    } &
    pids+=($!)
done
failed=0
for pid in "${pids[@]}"; do
    wait "$pid" || failed=1
done
exit "$failed"
