// Splits a mesh into flat patches, so that the top of a slab or the side of a box can be a receiver
// of its own. A patch is connected (after a weld), coplanar and large enough to matter; everything
// else is "the rest", patch id 0.

#pragma once

#include "engine/scene/mesh.hpp"

namespace scene {

/// Finds the patches of `mesh` and writes mesh.patches and mesh.patch_ids. Vertices shared by
/// triangles of different patches are duplicated (every per-vertex array grows alike); triangles
/// and their order stay. Meshes that deform get no patches. The largest patches win when there are
/// more than kMaxPatches. Source of the limits: docs/design.md, Vocabulary (residual at most 1e-4
/// of the mesh's size, at least 5 % of its area).
void split_flat_patches(Mesh& mesh);

} // namespace scene
