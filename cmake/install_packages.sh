#!/usr/bin/env bash
# Installs the Debian packages that are missing: install_packages.sh build|check|gl|study|platforms|fuzz
# docs/dependencies.md says what each is for.
set -euo pipefail

build=(ca-certificates g++ cmake ninja-build pkg-config libglm-dev libfmt-dev libtbb-dev
       nlohmann-json3-dev libcli11-dev libopenimageio-dev libhwy-dev libssl-dev)
check=("${build[@]}" clang libclang-rt-14-dev catch2 libmpfr-dev libgmm++-dev libeigen3-dev libtinyobjloader-dev
       binutils git python3 python3-jsonschema chromium valgrind)
# To compare with Mesa's drivers without a screen (-DTWOFOLD_GL=ON).
gl=("${build[@]}" libegl-dev libgl-dev libopengl-dev libegl1 libegl-mesa0 libgl1-mesa-dri)
# Other processors' compilers and emulators (tests/platforms/run).
platforms=(g++ clang cmake ninja-build python3 libglm-dev libfmt-dev libtbb-dev libhwy-dev
           libc++-14-dev libc++abi-14-dev lld-14 qemu-user-static
           g++-i686-linux-gnu g++-aarch64-linux-gnu g++-arm-linux-gnueabihf g++-riscv64-linux-gnu
           g++-powerpc64le-linux-gnu g++-mips64el-linux-gnuabi64 g++-s390x-linux-gnu
           wasi-libc libc++-14-dev-wasm32 libc++abi-14-dev-wasm32 libclang-rt-14-dev-wasm32 nodejs)
# libFuzzer and the sanitizers (tests/fuzz/run).
fuzz=("${build[@]}" clang libclang-rt-14-dev python3)
# To drive the shards of a study.
study=("${build[@]}" snakemake)

case "${1:-}" in
    build) wanted=("${build[@]}") ;;
    check) wanted=("${check[@]}") ;;
    gl) wanted=("${gl[@]}") ;;
    study) wanted=("${study[@]}") ;;
    platforms) wanted=("${platforms[@]}") ;;
    fuzz) wanted=("${fuzz[@]}") ;;
    *) echo "usage: $0 build|check|gl|study|platforms|fuzz" >&2; exit 2 ;;
esac

missing=()
for package in "${wanted[@]}"; do
    status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
    [ "$status" = installed ] || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { echo "install as root or with sudo: ${missing[*]}" >&2; exit 2; }
    as_root=(sudo)
fi
echo "installing: ${missing[*]}" >&2
export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
