#!/usr/bin/env bash
# An effect that changes nothing costs less than 0.1 % of a frame's instructions: run.sh UNUSED_EFFECTS
set -euo pipefail
command -v valgrind >/dev/null || { echo "valgrind is missing"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

valgrind -q --tool=callgrind --callgrind-out-file="$work/out" --collect-atstart=no \
    --toggle-collect=counted_draw --dump-after=counted_draw "$1" >"$work/names"

# Each call of counted_draw leaves a dump: out.1, out.2 ...
number=0 failed=0
while IFS= read -r name; do
    number=$((number + 1))
    count=$(sed -n 's/^\(totals\|summary\): *//p' "$work/out.$number" | head -n 1)
    case $name in *": nothing") plain=$count ;; esac
    difference=$((count > plain ? count - plain : plain - count))
    printf '%-60s %12s %+d\n' "$name" "$count" $((count - plain))
    [ "$count" -gt 1000000 ] || { echo "FAILED: nothing was counted"; failed=1; }
    [ $((difference * 1000)) -lt "$plain" ] || { echo "FAILED: more than 0.1 %"; failed=1; }
done <"$work/names"
[ "$number" -gt 0 ] || failed=1
exit "$failed"
