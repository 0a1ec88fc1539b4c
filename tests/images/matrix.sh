#!/usr/bin/env bash
# The same hashes from every compiler and setting of this machine: builds image_hashes in each configuration
# below build/matrix and compares with tests/images/hashes.txt. usage: matrix.sh [all | NAME ...]
# Without names: the one that differs most from the release build, by compiler, level and instructions.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

declare -A compiler=(
    [gcc-O0]=g++ [gcc-O2]=g++ [gcc-O3-native]=g++ [gcc-sanitize]=g++
    [clang-O0]=clang++ [clang-O2]=clang++ [clang-O3-native]=clang++ [clang-sanitize-native]=clang++)
declare -A flags=(
    [gcc-O0]="-O0" [gcc-O2]="-O2" [gcc-O3-native]="-O3 -march=native"
    [gcc-sanitize]="-O1 -fsanitize=address,undefined -fno-sanitize-recover=all"
    [clang-O0]="-O0" [clang-O2]="-O2" [clang-O3-native]="-O3 -march=native"
    [clang-sanitize-native]="-O1 -march=native -fsanitize=address,undefined -fno-sanitize-recover=all")

names=("$@")
[ ${#names[@]} -gt 0 ] || names=(clang-sanitize-native)
[ "${names[0]}" != all ] || names=("${!compiler[@]}")

passed=0 failed=0
for name in "${names[@]}"; do
    build=build/matrix/$name
    # Debug adds no optimisation of its own, so the flags decide.
    cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_COMPILER="${compiler[$name]}" \
        -DCMAKE_CXX_FLAGS="${flags[$name]}" -DCMAKE_CXX_FLAGS_DEBUG="" -DTWOFOLD_TESTS=ON \
        -DCMAKE_PROJECT_INCLUDE=cmake/precompiled.cmake >/dev/null
    cmake --build "$build" --target image_hashes | tail -n 1
    for threads in 1 7; do
        echo "== $name (${compiler[$name]} ${flags[$name]}), $threads threads"
        if tests/images/check.sh "$build/tests/image_hashes" "$threads"; then
            passed=$((passed + 1))
        else
            failed=$((failed + 1))
        fi
    done
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
