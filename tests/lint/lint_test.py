#!/usr/bin/env python3
"""The lint must be able to fail: each rule is shown a small tree that breaks it, and one that does not."""

import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
import lint  # noqa: E402

HEADER = "// What it is for.\n\n#pragma once\n"

# Files that includes of the cases below may name.
TREE = {
    "ecs/entity.hpp": HEADER,
    "engine/core/text.hpp": HEADER,
    "engine/gpu/texture.hpp": HEADER,
    "engine/scene/mesh.hpp": HEADER,
    "engine/render/renderer.hpp": HEADER,
    "engine/render/shaders/shared/frame.h": HEADER,
    "systems/shadows/pairs.hpp": HEADER,
    "systems/shadows/shadow_system.hpp": HEADER,
    "systems/shadows/techniques/blob.hpp": HEADER,
    "systems/shadows/techniques/planar.hpp": HEADER,
    "systems/shadows/techniques/map_common.hpp": HEADER,
    "systems/shadows/techniques.def": "SHADOW_TECHNIQUE(blob)\nSHADOW_TECHNIQUE(planar)\n",
}

# (path, content, part of the message)
BAD = [
    ("ecs/a.hpp", HEADER + '#include "engine/core/text.hpp"\n', "ecs includes core"),
    ("ecs/a.hpp", HEADER + "#include <fmt/format.h>\n", "ecs includes a library"),
    ("engine/core/a.cpp", '#include "ecs/entity.hpp"\n', "core includes ecs"),
    ("engine/gpu/a.cpp", '#include "engine/scene/mesh.hpp"\n', "gpu includes scene"),
    ("engine/scene/a.cpp", '#include "engine/gpu/texture.hpp"\n', "scene includes gpu"),
    ("engine/render/a.cpp", '#include "systems/shadows/pairs.hpp"\n', "render includes shadows_core"),
    ("engine/script/a.cpp", '#include "engine/render/renderer.hpp"\n', "script includes render"),
    ("systems/shadows/a.cpp", '#include "engine/gpu/texture.hpp"\n', "shadows_core includes gpu"),
    ("systems/shadows/a.cpp", '#include "engine/render/renderer.hpp"\n', "shadows_core includes render"),
    ("systems/shadows/a.cpp", '#include "systems/shadows/shadow_system.hpp"\n', "shadows_core includes shadows"),
    ("systems/shadows/geometry/a.cpp", "#include <epoxy/gl.h>\n", "shadows_core includes OpenGL"),
    ("systems/shadows/a.cpp", "#include <lua.hpp>\n", "shadows_core includes Lua"),
    ("systems/shadows/techniques/blob.cpp", '#include "systems/shadows/techniques/planar.hpp"\n', "another one"),
    ("systems/shadows/a.cpp", "#include <render/shared/frame.h>\n", "shadows_core includes render"),
    ("tools/gnomon/a.cpp", "#include <embree3/rtcore.h>\n", "tools includes Embree"),
    ("engine/scene/a.cpp", '#include "../core/text.hpp"\n', "climbs"),
    ("engine/scene/a.cpp", '#include "mesh.hpp"\n', "not a file of the tree"),
    ("engine/scene/a.cpp", "void f() { glFinish(); }\n", "calls OpenGL"),
    ("tools/a.cpp", "int x;\n" * 401, "401 lines"),
    ("scripts/a.lua", "-- What it is for.\n" + "local x = 1\n" * 400, "401 lines"),
    ("engine/core/a.hpp", "#pragma once\n", "does not open"),
    ("engine/core/a.hpp", "// What it is for.\n", "no #pragma once"),
    ("engine/core/a.cpp", "int x; \n", "white space"),
    ("engine/core/a.cpp", "\tint x;\n", "tab"),
    ("engine/core/a.cpp", "int x;", "newline"),
    ("engine/core/a.cpp", "// " + "TO" + "DO mend this\n", "issue number"),
    ("docs/a.md", "Keep" + " in sync with b.md.\n", "two places"),
    ("engine/core/a.cpp", "// draw(mesh, 3);\n", "commented-out"),
    ("engine/core/a.cpp", "    // const int x = 3;\n", "commented-out"),
]

GOOD = [
    ("engine/scene/a.cpp", '#include "engine/core/text.hpp"\n#include <tiny_gltf.h>\n#include <vector>\n'),
    ("engine/gpu/a.cpp", "#include <epoxy/gl.h>\nvoid f() { glFinish(); }\n"),
    ("systems/shadows/a.cpp", '#include "engine/scene/mesh.hpp"\n#include "ecs/entity.hpp"\n'),
    ("systems/shadows/techniques/blob.cpp", '#include "systems/shadows/techniques/blob.hpp"\n'),
    ("systems/shadows/techniques/blob.cpp", '#include "systems/shadows/techniques/map_common.hpp"\n'),
    ("systems/shadows/techniques/blob.cpp", "#include <render/shared/frame.h>\n"),
    ("systems/shadows/shadow_system.cpp", '#include "engine/gpu/texture.hpp"\n'),
    ("tests/a.cpp", '#include "systems/shadows/shadow_system.hpp"\n#include <lua.hpp>\n'),
    ("engine/core/a.cpp", "// What glFinish() waits for; the rest (see below) is free.\nint x;\n"),
    ("engine/core/a.cpp", "// " + "TO" + "DO(#12): mend this\n"),
    ("scripts/meta/a.lua", "-- Made from the schema by gnomon.\n" + "local x = 1\n" * 500),
    ("games/sample/models/a.py", "import bpy\n" * 500),
    ("build/engine/core/a.cpp", "\tnothing here is ours \n"),
]


class LintTest(unittest.TestCase):
    def offences(self, path, content):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in {**TREE, path: content}.items():
                file = Path(folder, name)
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(text, encoding="utf-8")
            return list(lint.offences(Path(folder)))

    def test_each_rule_finds_its_offence_and_nothing_else(self):
        for path, content, message in BAD:
            with self.subTest(path=path, content=content[:60]):
                found = self.offences(path, content)
                self.assertEqual(len(found), 1, found)
                self.assertTrue(found[0].startswith(path + ":"), found)
                self.assertIn(message, found[0])

    def test_what_is_allowed_passes(self):
        for path, content in GOOD:
            with self.subTest(path=path, content=content[:60]):
                self.assertEqual(self.offences(path, content), [])


if __name__ == "__main__":
    unittest.main()
