"""The inputs of the commands under faults: as small as they can be, and of every kind."""
import json
import struct
import zlib

SCENE = {
    "title": "Faults",
    "image": {"width": 12, "height": 8, "background": 0.0},
    "camera": {"eye": [0.0, 0.0, 4.0], "target": [0.0, 0.0, 0.0], "up": [0.0, 1.0, 0.0],
               "vertical_fov_degrees": 32.0, "near": 1.0, "far": 10.0},
    "environment": {"latlong": "sky.hdr", "cells": 4},
    "white": 1.0,
    "factorization": {"map_size": 4, "samples": 640, "held_out": 10},
    "materials": {"phong": {"modified_phong": {"diffuse": 0.5, "specular": 0.5, "exponent": 2.0}}},
    "meshes": {"octahedron": {"file": "octahedron.obj"}, "quad": {"quad": {}}},
    "textures": {"board": {"file": "board.png"}},
    "objects": [{"mesh": "octahedron", "material": "phong"}],
    "passes": [{"mesh": "quad", "units": [{"texture": "board"}], "depth_test": None}],
    "presets": ["ideal64", "nv17"],
}

STUDY = {
    "title": "Faults",
    "base": {"presets": ["nv17"]},
    # A cell is kept with the times of one round, then with those of all: with one, and clocks that advance by a fixed
    # step, the two files have the same bytes.
    "timing": {"seconds": 0.0, "least_rounds": 1, "most_rounds": 1, "long_frame": 10.0},
    "axes": [
        {"name": "preset", "title": "Preset", "plot": "bars", "against": "ideal64", "path": "presets.0",
         "values": ["gl13", "nv17"]},
        {"name": "map_size", "title": "Map size", "plot": "line", "needs_objects": True,
         "path": "factorization.map_size", "values": [4, 8]},
        {"name": "technique", "title": "Technique", "needs_objects": True,
         "points": [{"label": "two factors"}, {"label": "exact", "set": {"draw.technique": "exact"}}]},
    ],
}

OCTAHEDRON = """v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1
f 1 3 5\nf 3 2 5\nf 2 4 5\nf 4 1 5\nf 3 1 6\nf 2 3 6\nf 4 2 6\nf 1 4 6\n"""

FILES = ("scene.json", "octahedron.obj", "sky.hdr", "board.png")


def sky():
    """Radiance HDR of 8 x 4 pixels, without runs: mantissas, and 128 for an exponent of 0."""
    pixels = bytes(v for i in range(32) for v in (40 + 5 * i, 200 - 4 * i, 90 + i, 128))
    return b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 8\n" + pixels


def png_chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def board():
    """PNG of 2 x 2 pixels, RGBA."""
    rows = b"".join(b"\0" + bytes(row) for row in ([255, 0, 0, 255, 9, 9, 9, 255], [0, 99, 0, 255] * 2))
    header = struct.pack(">IIBBBBB", 2, 2, 8, 6, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + png_chunk(b"IHDR", header) + png_chunk(b"IDAT", zlib.compress(rows))
            + png_chunk(b"IEND", b""))


def write_inputs(folder):
    folder.mkdir(parents=True)
    (folder / "scene.json").write_text(json.dumps(SCENE))
    (folder / "study.json").write_text(json.dumps(STUDY))
    (folder / "octahedron.obj").write_text(OCTAHEDRON)
    (folder / "sky.hdr").write_bytes(sky())
    (folder / "board.png").write_bytes(board())
