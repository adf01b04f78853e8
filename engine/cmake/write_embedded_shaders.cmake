# Run by embed_shaders(): writes OUTPUT, the table of the files that FILE_LIST names below FOLDER.
# A raw string literal may hold 65536 characters at least, so long texts are cut into several.
file(STRINGS "${FILE_LIST}" files)
set(rows "")
set(count 0)
foreach(file IN LISTS files)
    file(READ "${FOLDER}/${file}" text)
    set(literals "")
    string(LENGTH "${text}" length)
    set(start 0)
    while(start LESS length)
        string(SUBSTRING "${text}" ${start} 8192 piece)
        string(APPEND literals "R\"glsl_text(${piece})glsl_text\"\n")
        math(EXPR start "${start} + 8192")
    endwhile()
    if(length EQUAL 0)
        set(literals "\"\"")
    endif()
    string(APPEND rows "    gpu::ShaderFile{\"${file}\", ${literals}},\n")
    math(EXPR count "${count} + 1")
endforeach()

file(WRITE "${OUTPUT}" "// Made by embed_shaders() in CMake.

#include \"embedded/${NAME}_shaders.hpp\"

#include <array>

namespace embedded {

namespace {

constexpr std::array<gpu::ShaderFile, ${count}> kFiles = {
${rows}};

} // namespace

gpu::ShaderFolder ${NAME}_shaders() {
    return {\"${NAME}\", kFiles, \"${DISK_PATH}\"};
}

} // namespace embedded
")
