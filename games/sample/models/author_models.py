"""Writes the models of the sample level beside this file, all or those that are named.

usage: blender -b --python games/sample/models/author_models.py [-- NAME...]      (Blender 3.4, with numpy)

Everything is computed, nothing is drawn by hand or random: the same Blender writes the same bytes.
"""

import sys
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(FOLDER))

from authoring import blender_files, court, fountain, landscape, statue, sundial, walker  # noqa: E402  after the path is set


BUILDERS = {
    "arch": court.build_arch,
    "bench": court.build_bench,
    "column": court.build_column,
    "cypress": landscape.build_cypress,
    "fountain": fountain.build,
    "hills": landscape.build_hills,
    "jar": court.build_jar,
    "lantern": court.build_lantern,
    "statue": statue.build,
    "sundial": sundial.build,
    "walker": walker.build,
}


def main():
    names = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else list(BUILDERS)
    for name in names:
        blender_files.start_empty()
        BUILDERS[name]()
        blender_files.export_glb(FOLDER / f"{name}.glb")


main()
