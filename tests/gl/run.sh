#!/usr/bin/env bash
# Compares with one of Mesa's drivers: run.sh MESA_COMPARE softpipe|llvmpipe|llvmpipe-float [OPTION...]
# llvmpipe-float filters textures in floating point instead of with weights of 8 bits.
set -euo pipefail

program=$1 driver=$2
shift 2
export LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=${driver%-float}
case "$driver" in
    softpipe | llvmpipe) unset GALLIVM_PERF ;;
    llvmpipe-float) export GALLIVM_PERF=no_aos_sampling ;;
    *) echo "run.sh: no driver '$driver'" >&2; exit 2 ;;
esac

# A machine without the driver would otherwise be compared with another one.
output=$("$program" "$@") && status=0 || status=$?
printf '%s\n' "$output"
case "$output" in
    "$GALLIUM_DRIVER"*) exit "$status" ;;
    *) echo "run.sh: the driver is not $GALLIUM_DRIVER" >&2; exit 2 ;;
esac
