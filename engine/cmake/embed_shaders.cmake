# embed_shaders(<target> VIRTUAL_ROOT <name> DIR <folder>): puts every file below the folder into the target as
# one table, `gpu::ShaderFolder embedded::<name>_shaders()`, declared in "embedded/<name>_shaders.hpp".
# Files are named "<name>/path" in GLSL; C++ includes the headers of shared/ by the same names. New files are
# found at the next build. With SHADER_HOT_RELOAD the table also says where the folder lies, and its files
# are read from there.
set(embed_shaders_script "${CMAKE_CURRENT_LIST_DIR}/write_embedded_shaders.cmake")
set(embed_shaders_outputs "${PROJECT_BINARY_DIR}/generated")

function(embed_shaders target)
    cmake_parse_arguments(ARG "" "VIRTUAL_ROOT;DIR" "" ${ARGN})
    get_filename_component(folder "${ARG_DIR}" ABSOLUTE)
    file(GLOB_RECURSE files CONFIGURE_DEPENDS RELATIVE "${folder}" "${folder}/*")
    list(SORT files)
    list(TRANSFORM files PREPEND "${folder}/" OUTPUT_VARIABLE paths)

    # The folder under its virtual name, so that `#include "<name>/shared/x.h"` means the same to both languages.
    file(MAKE_DIRECTORY "${embed_shaders_outputs}/embedded")
    file(CREATE_LINK "${folder}" "${embed_shaders_outputs}/${ARG_VIRTUAL_ROOT}" SYMBOLIC)

    set(disk_path "")
    if(SHADER_HOT_RELOAD)
        set(disk_path "${folder}")
    endif()
    set(header "${embed_shaders_outputs}/embedded/${ARG_VIRTUAL_ROOT}_shaders.hpp")
    set(source "${embed_shaders_outputs}/embedded/${ARG_VIRTUAL_ROOT}_shaders.cpp")
    set(file_list "${embed_shaders_outputs}/embedded/${ARG_VIRTUAL_ROOT}_files.txt")
    list(JOIN files "\n" lines)
    file(CONFIGURE OUTPUT "${file_list}" CONTENT "${lines}" @ONLY)
    file(CONFIGURE OUTPUT "${header}" CONTENT [[
// Made by embed_shaders() in CMake.

#pragma once

#include "engine/gpu/shader_source.hpp"

namespace embedded {

gpu::ShaderFolder @ARG_VIRTUAL_ROOT@_shaders();

} // namespace embedded
]] @ONLY)
    add_custom_command(OUTPUT "${source}"
        COMMAND "${CMAKE_COMMAND}" "-DNAME=${ARG_VIRTUAL_ROOT}" "-DFOLDER=${folder}" "-DFILE_LIST=${file_list}"
            "-DDISK_PATH=${disk_path}" "-DOUTPUT=${source}" -P "${embed_shaders_script}"
        DEPENDS ${paths} "${file_list}" "${embed_shaders_script}"
        COMMENT "Embedding the shaders of ${ARG_VIRTUAL_ROOT}"
        VERBATIM)
    target_sources(${target} PRIVATE "${source}")
    target_include_directories(${target} PUBLIC "${embed_shaders_outputs}")
endfunction()
