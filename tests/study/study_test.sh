#!/usr/bin/env bash
# A study from outside: shards and their merge, interruption, the same bytes again, the page in Chromium.
# usage: study_test.sh TWOFOLD SOURCE_DIR
set -euo pipefail
twofold=$1 source=$2
here=$source/tests/study
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
tiny=("$source/scenes/sphere-lobe.json" --study "$here/tiny_study.json" -q)
study() { "$twofold" study "${tiny[@]}" "$@"; }
fail() { echo "FAILED: $1" >&2; exit 1; }

# A study whose one cell cannot be drawn ends with a warning, and says why.
code=0
study -o "$work/whole" >"$work/output" 2>&1 || code=$?
[ $code -eq 1 ] || { cat "$work/output"; fail "exit code $code of a study with a failed cell, wanted 1"; }
grep -q 'warning: .*24 x 24' "$work/output" || fail "the failed cell is not named"
for file in report.html cells.csv figures/map_size.svg figures/budget.svg figures/error-frame.svg \
            figures/convergence.svg; do
    [ -s "$work/whole/$file" ] || fail "no $file"
done
[ -z "$(find "$work" -name '*.tmp')" ] || fail "a temporary file is left"

# Again: nothing is measured, and the page says the same.
cp "$work/whole/report.html" "$work/first.html"
study -o "$work/whole" >"$work/output" 2>&1 || true
grep -q 'measured 0 cells' "$work/output" || fail "a finished study was measured again"
cmp "$work/whole/report.html" "$work/first.html"

# Killed at a few moments: what was finished stays, no half file is taken for a cell, the rest is made up for.
for moment in 0.3 0.6 1.0; do
    "$twofold" study "${tiny[@]}" -o "$work/killed" >/dev/null 2>&1 &
    child=$!
    sleep $moment
    kill -9 $child 2>/dev/null || true
    wait $child 2>/dev/null || true
done
study -o "$work/killed" >/dev/null 2>&1 || true
[ -z "$(find "$work/killed" -name '*.tmp')" ] || fail "temporary files of killed studies are left"

# Shards, in folders of their own, and their merge.
study -o "$work/s1" --shard 1/2 >/dev/null
study -o "$work/s2" --shard 2/2 >/dev/null
[ ! -e "$work/s1/report.html" ] || fail "a shard wrote a report"
code=0
study -o "$work/half" --merge "$work/s1" >"$work/output" 2>&1 || code=$?
[ $code -eq 2 ] && grep -q 'cells were not measured' "$work/output" || fail "a merge with a shard missing"
study -o "$work/merged" --merge "$work/s1" "$work/s2" >/dev/null 2>&1 || true

# All of them found the same, times aside; pictures to the byte.
python3 "$here/same_cells.py" "$work/whole/cells" "$work/killed/cells" "$work/merged/cells"

# The page, as it opens and as one uses it.
"$here/report_page.sh" "$work/merged/report.html"
python3 "$here/with_script.py" "$work/merged/report.html" "$here/study_actions.js" "$work/used.html"
"$here/report_page.sh" "$work/used.html"

# Wrong usage.
for wrong in "--shard 3/2" "--study $work/none.json" "--merge $work/none"; do
    # shellcheck disable=SC2086
    if "$twofold" study "$source/scenes/sphere-lobe.json" -o "$work/x" -q $wrong >/dev/null 2>&1; then
        fail "accepted: $wrong"
    fi
done
echo "study: shards, interruption and page as they should be"
