#!/bin/bash
# Test titles that CMake's lists would break: with a bracket or a semicolon ctest runs several tests as one that
# does not exist, and calls it passed.
# And titles that lack the id of their hard case.
# usage: titles.sh [SOURCE_DIR]      prints the titles; exit 0 when there are none, 1 otherwise
set -u
here=$(cd "$(dirname "$0")" && pwd)
cd "${1:-$here/../..}" || exit 2

# A title is the string literals between the parenthesis and the first comma or the closing parenthesis.
titles() {
    cat tests/*/*_test.cpp | tr '\n' ' ' | grep -oP 'TEST_CASE\(\s*("[^"]*"\s*)+' | grep -oP '".*"'
}
if titles | grep '[][;]'; then exit 1; fi

# A hard case's id is in the title as well as in the tags: ctest's lines show titles.
cat tests/*/*_test.cpp | tr '\n' ' ' | grep -oP 'TEST_CASE\(\s*("[^"]*"\s*)+,\s*"[^"]*"' |
    awk '{ rest = $0
           while (match(rest, /\[[RTCFSQD][0-9][0-9]\]/)) {
               id = substr(rest, RSTART + 1, 3)
               if (gsub(id, id) < 2) { print; bad = 1 }
               rest = substr(rest, RSTART + RLENGTH)
           } }
         END { exit bad }'
