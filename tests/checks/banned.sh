#!/bin/bash
# Source constructs whose result depends on compiler, library or machine (docs/exactness.md, section 2.1).
# usage: banned.sh [SOURCE_DIR]      prints the hits; exit 0 when there are none, 1 otherwise
set -u
here=$(cd "$(dirname "$0")" && pwd)
cd "${1:-$here/../..}" || exit 2

# Pictures and meshes below scenes/data are not code.
grep -rnIE --exclude-dir=data -f "$here/banned.txt" texunit raster factor scenes
case $? in
    0) exit 1 ;;
    1) exit 0 ;;
    *) exit 2 ;;
esac
