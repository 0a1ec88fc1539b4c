#!/usr/bin/env python3
"""Checks scenes/scene.schema.json with an independent validator: it is itself a valid schema, it accepts every
shipped scene, and it refuses scenes that are wrong in known ways; the same for studies. Exit code 77: the validator
is not installed.

usage: schema_test.py SCENES_FOLDER STUDY_FOLDER
"""
import copy
import json
import pathlib
import re
import sys

try:
    import jsonschema
except ImportError:
    print("python3-jsonschema is not installed")
    sys.exit(77)

STRING_OR_COMMENT = re.compile(r'("(?:\\.|[^"\\])*")|//[^\n]*|/\*.*?\*/', re.DOTALL)


def without_comments(text):
    """JSON with comments as JSON; what looks like a comment inside a string stays."""
    return STRING_OR_COMMENT.sub(lambda match: match.group(1) or " ", text)


def wrong_scenes(scene):
    """Copies of a scene with objects, each wrong in one way, with a name for the way."""
    changes = {
        "unknown field": lambda s: s.update(imgae={}),
        "unknown nested field": lambda s: s["image"].update(widht=1),
        "picture too wide": lambda s: s["image"].update(width=1000000000),
        "negative near plane": lambda s: s["camera"].update(near=-1),
        "text for a number": lambda s: s["image"].update(width="wide"),
        "two kinds of environment": lambda s: s["environment"].update(painted={}, latlong="a.hdr"),
        "unknown preset": lambda s: s.update(presets=["nv18"]),
        "no mesh": lambda s: s["objects"][0].pop("mesh"),
        "nothing to draw": lambda s: s.pop("objects"),
    }
    for name, change in changes.items():
        wrong = copy.deepcopy(scene)
        change(wrong)
        yield name, wrong


def study_failures(folder):
    """The same for study files and their schema."""
    schema = json.loads((folder / "study.schema.json").read_text(encoding="utf-8"))
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
    failures = []
    for path in sorted(path for path in folder.glob("*.json") if path.name != "study.schema.json"):
        study = json.loads(without_comments(path.read_text(encoding="utf-8")))
        failures += [f"{path.name}: {error.json_path}: {error.message}"
                     for error in validator.iter_errors(study)]
        for name, change in {
                "no axes": lambda s: s.pop("axes"),
                "unknown field": lambda s: s.update(axis=[]),
                "unknown plot": lambda s: s["axes"][0].update(plot="pie"),
                "values and points": lambda s: s["axes"][0].update(
                    path="draw.way", values=["fused"], points=[{"label": "p"}]),
                "a point without label": lambda s: s["axes"].append({"name": "n", "points": [{}]}),
        }.items():
            wrong = copy.deepcopy(study)
            change(wrong)
            if validator.is_valid(wrong):
                failures.append(f"{path.name}: accepted with {name}")
    return failures


def main():
    folder = pathlib.Path(sys.argv[1])
    schema = json.loads((folder / "scene.schema.json").read_text(encoding="utf-8"))
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
    failures = []
    scenes = sorted(path for path in folder.glob("*.json") if path.name != "scene.schema.json")
    scenes += sorted(folder.glob("probes/*.json"))
    for path in scenes:
        scene = json.loads(without_comments(path.read_text(encoding="utf-8")))
        failures += [f"{path.name}: {error.json_path}: {error.message}"
                     for error in validator.iter_errors(scene)]
        if "objects" in scene:
            failures += [f"{path.name}: accepted with {name}"
                         for name, wrong in wrong_scenes(scene) if validator.is_valid(wrong)]
    failures += study_failures(pathlib.Path(sys.argv[2]))
    print("\n".join(failures) or f"{len(scenes)} scenes are valid")
    return 1 if failures or not scenes else 0


if __name__ == "__main__":
    sys.exit(main())
