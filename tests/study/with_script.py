#!/usr/bin/env python3
"""Writes a copy of a page with one more script at its end.

usage: with_script.py PAGE SCRIPT COPY
"""
import pathlib
import sys

page, script, copy = map(pathlib.Path, sys.argv[1:])
html = page.read_text(encoding="utf-8")
copy.write_text(html.replace("</body>", f"<script>{script.read_text(encoding='utf-8')}</script></body>"),
                encoding="utf-8")
