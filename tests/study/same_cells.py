#!/usr/bin/env python3
"""Whether folders of cells hold the same results, times aside, and the same pictures.

usage: same_cells.py FOLDER FOLDER...
"""
import json
import pathlib
import sys


def cells_of(folder):
    """By name: a result without its times, or a picture's bytes."""
    cells = {}
    for path in sorted(folder.iterdir()):
        if path.suffix == ".json":
            result = json.loads(path.read_text(encoding="utf-8"))
            result.pop("times", None)
            cells[path.name] = result
        else:
            cells[path.name] = path.read_bytes()
    return cells


def main():
    first, *others = [cells_of(pathlib.Path(folder)) for folder in sys.argv[1:]]
    differing = sorted(name for other in others for name in set(first) | set(other)
                       if first.get(name) != other.get(name))
    print("\n".join(f"differs: {name}" for name in differing) or f"{len(first)} files are the same")
    return 1 if differing or not first else 0


if __name__ == "__main__":
    sys.exit(main())
