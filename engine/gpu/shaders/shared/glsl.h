// Lets a header be compiled by GLSL and by C++: include this first, and in C++ write
// `using namespace gpu::glsl` inside the header's own namespace. Order fields by hand for std140: a vec3
// takes 16 bytes there and 12 here, so keep to vec4, mat4 and scalars in fours.
#ifdef __cplusplus
#pragma once
#include <glm/glm.hpp>
#include <cstdint>
namespace gpu::glsl {
using glm::ivec2;
using glm::ivec4;
using glm::mat4;
using glm::uvec2;
using glm::uvec4;
using glm::vec2;
using glm::vec4;
using uint = std::uint32_t;
} // namespace gpu::glsl
#endif
