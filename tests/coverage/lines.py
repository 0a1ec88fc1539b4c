#!/usr/bin/env python3
"""Adds up what gcov counted in a build folder: lines.py BUILD [FOLDER ...]. A line counts as run if any of its copies, in
templates or in several programs, was. Prints a table by folder, then the lines that nothing ran."""
import gzip
import json
import subprocess
import sys
import tempfile
from collections import defaultdict
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FOLDERS = ("texunit", "raster", "factor", "scenes", "study", "cli")


def counted(note):
    """(file, line, count) of one object, run or not."""
    with tempfile.TemporaryDirectory() as place:
        subprocess.run(["gcov", "--json-format", note], cwd=place, capture_output=True, check=True)
        for file in Path(place).glob("*.gcov.json.gz"):
            for source in json.loads(gzip.decompress(file.read_bytes()))["files"]:
                for line in source["lines"]:
                    yield source["file"], line["line_number"], line["count"]


def counts_of(build):
    """By file, how often each of its lines was run."""
    total = defaultdict(lambda: defaultdict(int))
    notes = [n.resolve() for n in sorted(Path(build).rglob("*.gcno"))]
    with ThreadPoolExecutor() as pool:
        for lines in pool.map(lambda n: list(counted(n)), notes):
            for file, number, count in lines:
                path = (Path(build).resolve() / file).resolve()
                if path.is_relative_to(ROOT) and path.relative_to(ROOT).parts[0] in FOLDERS:
                    total[path.relative_to(ROOT)][number] += count
    return total


def ranges(numbers):
    """1-3, 7"""
    parts = []
    for n in sorted(numbers):
        if parts and parts[-1][1] == n - 1:
            parts[-1][1] = n
        else:
            parts.append([n, n])
    return ", ".join(str(a) if a == b else f"{a}-{b}" for a, b in parts)


def main():
    total = counts_of(sys.argv[1])
    print("| folder | lines | run | share |\n|---|---|---|---|")
    folders = sys.argv[2:] or FOLDERS
    for folder in folders:
        counts = [c for path, lines in total.items() if path.parts[0] == folder for c in lines.values()]
        done = sum(c > 0 for c in counts)
        print(f"| {folder} | {len(counts)} | {done} | {100 * done / max(1, len(counts)):.1f} % |")
    print()
    for path in sorted(total):
        missed = [n for n, count in total[path].items() if count == 0]
        if missed and path.parts[0] in folders:
            print(f"{path}: {ranges(missed)}")


if __name__ == "__main__":
    main()
