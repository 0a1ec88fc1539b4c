#!/usr/bin/env bash
# Compares what a hash program prints with the pinned hashes: check.sh PLATFORM_HASHES THREADS
# Prints the lines that differ (- pinned, + found); exit 1 if any do.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
diff -U0 --label pinned --label found "$here/hashes.txt" <("$1" "$2")
echo "$(wc -l <"$here/hashes.txt") hashes equal with $2 threads"
