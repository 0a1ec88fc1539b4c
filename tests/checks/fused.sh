#!/bin/bash
# Fused multiply-add instructions in an optimised build for this machine (docs/exactness.md, rule E01): they
# round once where the source rounds twice.
# usage: fused.sh COMPILER BUILD_DIR [SOURCE_DIR]
# prints the first hits of each archive; exit 0 when there are none, 1 otherwise, 2 when it cannot tell
set -u -o pipefail
here=$(cd "$(dirname "$0")" && pwd)
# shellcheck source=tests/checks/build_core.sh
. "$here/build_core.sh"

flags="-O3 -march=native"
case $(uname -m) in
    # -mfma, so that a machine without the instructions finds them too: nothing built here is run.
    x86_64) flags="$flags -mfma" pattern='\bvf(n)?m(add|sub)' ;;
    aarch64) flags="-O3 -mcpu=native" pattern='\b(fn?m(add|sub)|fml[as])\b' ;;
    riscv64) flags="-O3" pattern='\bfn?m(add|sub)\.[sdh]' ;;
    ppc64le) flags="-O3 -mcpu=native" pattern='\b(fn?m(add|sub)s?|xvn?m(add|sub)[am][sd]p|xsn?m(add|sub)[am][sd]p)\b' ;;
    s390x) flags="-O3 -march=native" pattern='\b(ma|ms)(e|d|eb|db)r?\b|\bvfn?m[as]' ;;
    *) echo "fused.sh: no pattern for $(uname -m)" >&2; exit 2 ;;
esac
build_core "$1" "$2" "${3:-$here/../..}" "$flags" || exit 2

found=0
for archive in $(archives "$2"); do
    hits=$(objdump -d --no-show-raw-insn "$archive" | grep -nE "$pattern")
    if [ -n "$hits" ]; then
        echo "$(basename "$archive"): $(wc -l <<<"$hits") fused instructions, such as"
        head -n 5 <<<"$hits"
        found=1
    fi
done
exit $found
