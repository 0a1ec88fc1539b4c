#!/bin/bash
# Calls of the C mathematics library other than sqrt, floor and fabs (docs/exactness.md, rule E02): its results
# differ between processors. Built without optimisation and with the strictest arithmetic, for otherwise the
# compiler folds or inlines some of these calls and no symbol is left to see. g++ for x86 inlines rint, trunc and
# ceil even so, with the right values; banned.sh finds those.
# usage: libm.sh COMPILER BUILD_DIR [SOURCE_DIR]
# prints "archive: symbol" for each; exit 0 when there are none, 1 otherwise, 2 when it cannot tell
set -u -o pipefail
here=$(cd "$(dirname "$0")" && pwd)
# shellcheck source=tests/checks/build_core.sh
. "$here/build_core.sh"
compiler=$1
build=$2
flags="-O0 -fno-builtin -ffp-contract=off -ftrapping-math -fmath-errno"
build_core "$compiler" "$build" "${3:-$here/../..}" "$flags" || exit 2

libm=$("$compiler" -print-file-name=libm.so.6)
provided=$(nm -D --defined-only "$libm" | awk '{sub(/@.*/, "", $3); print $3}' | sort -u)
if ! grep -qx pow <<<"$provided"; then
    echo "libm.sh: $libm does not define pow; nothing can be looked for" >&2
    exit 2
fi

# OpenImageIO's headers bring a header-only fmt into image_file, whose printing of numbers calls ceil; that is
# exact by definition and reaches no pixel.
allowed() {
    if [ "$1" = libimage_file.a ]; then echo '((sqrt|floor|fabs)f?|ceil)'; else echo '(sqrt|floor|fabs)f?'; fi
}

found=0
for archive in $(archives "$build"); do
    name=$(basename "$archive")
    used=$(nm -u "$archive" | awk '$1 == "U" {sub(/@.*/, "", $2); print $2}' | sort -u) || exit 2
    while read -r symbol; do
        echo "$name: $symbol"
        found=1
    done < <(comm -12 <(echo "$provided") <(echo "$used") | grep -vxE "$(allowed "$name")")
done
exit $found
