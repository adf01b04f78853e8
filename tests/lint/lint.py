#!/usr/bin/env python3
"""The rules of the tree that no compiler checks: who may include whom, where libraries stop, how long files may be.

usage: lint.py ROOT      prints "path:line: message" for each offence; exit code 1 when there is one
"""

import re
import sys
from fnmatch import fnmatch
from pathlib import Path

# Layers, the narrower patterns first: a file belongs to the first one that fits.
LAYERS = [
    ("ecs", ["ecs/*"]),
    ("core", ["engine/core/*"]),
    ("gpu", ["engine/gpu/*"]),
    ("scene", ["engine/scene/*"]),
    ("trace", ["engine/trace/*"]),
    ("play", ["engine/play/*"]),
    ("render", ["engine/render/*"]),
    ("script", ["engine/script/*"]),
    ("app", ["engine/app/*"]),
    ("techniques", ["systems/shadows/techniques/*"]),
    ("shadows", ["systems/shadows/shadow_system.*", "systems/shadows/shadow_system_*",
                 "systems/shadows/shadow_overlay.*", "systems/shadows/technique_*",
                 "systems/shadows/shaders/*"]),
    ("shadows_core", ["systems/shadows/*"]),
    ("games", ["games/*"]),
    ("tools", ["tools/*"]),
    ("tests", ["tests/*"]),
]

# What a layer may include besides itself. A technique's own exception stands in check_include.
SHADOWS_BELOW = {"shadows_core", "gpu", "render", "script", "trace", "scene", "core", "ecs"}
ENGINE = {"gpu", "scene", "trace", "play", "render", "script", "app", "core", "ecs"}
MAY_INCLUDE = {
    "ecs": set(),
    "core": set(),
    "gpu": {"core"},
    "scene": {"core", "ecs"},
    "trace": {"scene", "core", "ecs"},
    "play": {"scene", "core", "ecs"},
    "render": {"gpu", "scene", "core", "ecs"},
    "script": {"scene", "core", "ecs"},
    "app": ENGINE,
    "shadows_core": {"scene", "core", "ecs"},
    "shadows": SHADOWS_BELOW | {"techniques"},
    "techniques": SHADOWS_BELOW | {"shadows"},
    "games": ENGINE | {"shadows", "shadows_core"},
    "tools": ENGINE | {"shadows", "shadows_core", "games"},
    "tests": {name for name, _ in LAYERS},
}

# Libraries, and the layers that may see their headers. Tests may see all.
LIBRARIES = [
    (r"epoxy/|GL/|GLES|EGL/", "OpenGL", {"gpu", "render", "app", "techniques"}),
    (r"GLFW/", "GLFW", {"gpu", "app"}),
    (r"lua", "Lua", {"script"}),
    (r"embree", "Embree", {"trace"}),
    (r"tiny_gltf", "tinygltf", {"scene"}),
    (r"OpenMesh/", "OpenMesh", {"scene"}),
    (r"imgui", "Dear ImGui", {"app", "shadows"}),
    (r"CLI/", "CLI11", {"tools"}),
    (r".*[./]", "a library", {name for name, _ in LAYERS} - {"ecs"}),
]

# Folders of shaders under the names that #include sees (embed_shaders); GLSL and C++ share the headers there.
SHADER_ROOTS = {
    "gpu": "engine/gpu/shaders",
    "render": "engine/render/shaders",
    "shadows": "systems/shadows/shaders",
}

CXX = {".cpp", ".hpp", ".h"}
SHADERS = {".glsl", ".vert", ".frag", ".geom", ".comp"}
CODE = CXX | SHADERS | {".lua", ".py"}
TEXT = CODE | {".md", ".cmake", ".txt", ".json", ".def", ".sh"}
SKIPPED_FOLDERS = {"build", "out", ".git", "assets", "__pycache__", "corpus"}
MAX_LINES = 400

GL_CALL = re.compile(r"\bgl[A-Z]\w*\s*\(")
GL_LAYERS = {"gpu", "render", "techniques", "tests"}
INCLUDE = re.compile(r'\s*#\s*include\s*(["<])([^">]+)[">]')
COMMENTED_CODE = re.compile(r"^\s*(//|--)\s*([\w:.>-]+\(.*\)|[\w:<>*& ]+ [+*|-]?= .*|return\b.*|break);\s*$")
FORBIDDEN_WORDS = re.compile(r"keep" + r" in sync", re.IGNORECASE)
UNNUMBERED = re.compile(r"\b(" + "TO" + r"DO|FIX" + r"ME|XX" + r"X)\b(?!\(#\d+\))")


def layer_of(path):
    return next((name for name, patterns in LAYERS if any(fnmatch(path, p) for p in patterns)), None)


def check_include(path, bracket, target, root):
    """The offence of one #include, or None."""
    layer = layer_of(path)
    if ".." in target.split("/"):
        return "include climbs with '../'; includes are written from the root"
    first, _, rest = target.partition("/")
    if first in SHADER_ROOTS:
        target = f"{SHADER_ROOTS[first]}/{rest}"
    elif bracket == "<":
        for pattern, library, layers in LIBRARIES:
            if re.match(pattern, target):
                allowed = layer in layers or layer == "tests"
                return None if allowed else f"{layer} includes {library} (<{target}>)"
        return None
    if target.startswith("embedded/"):  # made by embed_shaders()
        return None
    if not (root / target).is_file():
        return f"'{target}' is not a file of the tree; includes are written from the root"
    below = layer_of(target)
    if layer == "techniques" and below == "techniques" and is_technique(target, root):
        own = Path(path).stem == Path(target).stem
        return None if own else f"a technique includes another one ('{target}')"
    if below == layer or below in MAY_INCLUDE[layer]:
        return None
    return f"{layer} includes {below} ('{target}')"


def is_technique(path, root):
    """techniques.def names the techniques; the other files beside them are shared helpers."""
    names = root / "systems/shadows/techniques.def"
    return names.is_file() and re.search(rf"\b{re.escape(Path(path).stem)}\b", names.read_text()) is not None


def exempt_from_size(path, text):
    """Generated files say so at their top ("Made from schema.cpp by ..."); Blender scripts author models."""
    return re.match(r"\W*(Generated|Made) (by|from) ", text) is not None or (path.endswith(".py") and "import bpy" in text)


def check_cxx_line(path, line, root):
    found = INCLUDE.match(line)
    if found and Path(path).suffix in CXX and layer_of(path):
        offence = check_include(path, found[1], found[2], root)
        if offence:
            yield offence
    if GL_CALL.search(line.split("//")[0]) and layer_of(path) not in GL_LAYERS and Path(path).suffix in CXX:
        yield "calls OpenGL outside engine/gpu, engine/render and systems/shadows/techniques"


def check_text_line(path, line):
    if line != line.rstrip():
        yield "ends in white space"
    if "\t" in line:
        yield "contains a tab"
    if FORBIDDEN_WORDS.search(line):
        yield "the same fact stands in two places; let one be read from the other"
    if UNNUMBERED.search(line):
        yield "a thing left to do needs an issue number: (#12)"
    if Path(path).suffix in CODE and COMMENTED_CODE.match(line):
        yield "looks like commented-out code"


def check_file(path, text, root):
    """All offences of one file, as (line number, message)."""
    lines = text.splitlines()
    suffix = Path(path).suffix
    if suffix in CODE and len(lines) > MAX_LINES and not exempt_from_size(path, text):
        yield len(lines), f"has {len(lines)} lines; split files over {MAX_LINES}"
    if suffix == ".hpp" and not text.startswith("//"):
        yield 1, "does not open with what it is for"
    if suffix == ".hpp" and "#pragma once" not in text:
        yield 1, "has no #pragma once"
    if text and not text.endswith("\n"):
        yield len(lines), "does not end in a newline"
    for number, line in enumerate(lines, 1):
        for offence in check_text_line(path, line):
            yield number, offence
        for offence in check_cxx_line(path, line, root):
            yield number, offence


def files_of(root):
    for file in sorted(root.rglob("*")):
        path = file.relative_to(root)
        named = path.suffix in TEXT or str(path) in ("dev", ".ci/run", ".luacheckrc")
        if named and file.is_file() and not SKIPPED_FOLDERS.intersection(path.parts):
            yield str(path), file


def offences(root):
    for path, file in files_of(root):
        for line, message in check_file(path, file.read_text(encoding="utf-8", errors="replace"), root):
            yield f"{path}:{line}: {message}"


def main():
    if len(sys.argv) != 2 or not Path(sys.argv[1]).is_dir():
        print(__doc__, file=sys.stderr)
        return 2
    found = list(offences(Path(sys.argv[1])))
    print("\n".join(found + [f"lint: {len(found)} offences"]))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
