"""Writes the models of the sample level: sundial.glb, statue.glb and walker.glb, beside this file.

usage: blender -b --python games/sample/models/author_models.py      (Blender 3.4, with numpy)

Everything is computed, nothing is drawn by hand or random: the same Blender writes the same bytes.
"""

import sys
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(FOLDER))

from authoring import blender_files, statue, sundial, walker  # noqa: E402  after the path is set


def main():
    for name, build in (("sundial", sundial.build), ("statue", statue.build), ("walker", walker.build)):
        blender_files.start_empty()
        build()
        blender_files.export_glb(FOLDER / f"{name}.glb")


main()
