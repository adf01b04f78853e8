// glTF 2.0 files (.gltf, .glb) into Models. tinygltf parses; everything it does not look at
// (indices, counts, NaN, node cycles, accessor bounds) is checked here, so that whatever comes back
// is safe to use.

#pragma once

#include "engine/core/result.hpp"
#include "engine/scene/model.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace scene {

/// Reads a model: meshes with health reports and flat patches, nodes, materials, cameras, lights,
/// skins, morphs, clips. Errors: no such file, not glTF, or any number in it that is out of its
/// range; the sentence names what and where ("mesh 'Box' primitive 0: index 65535 at 3 is past its
/// 24 vertices").
engine::Result<Model> load_gltf(const std::filesystem::path& file);

/// The same from memory, without access to files beside it (fuzzing, tests).
engine::Result<Model> load_gltf_bytes(std::span<const std::uint8_t> bytes, const std::string& name);

} // namespace scene
