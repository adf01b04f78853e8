# embed_scripts(<output> <module>...): writes scripts/<module>.lua (dots are folders) into a C++ file, so that programs
# need no files beside them.
function(embed_scripts output)
    set(rows "")
    foreach(module IN LISTS ARGN)
        string(REPLACE "." "/" path "${module}")
        set(file "${PROJECT_SOURCE_DIR}/scripts/${path}.lua")
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
        file(READ "${file}" text)
        string(APPEND rows "    if (name == \"${module}\") return R\"lua(${text})lua\";\n")
    endforeach()
    file(CONFIGURE OUTPUT "${output}" @ONLY CONTENT [=[
// Made from scripts/ by embed_scripts.cmake.
#include "engine/script/modules.hpp"

namespace script {

std::optional<std::string_view> shipped_module(std::string_view name) {
@rows@    return std::nullopt;
}

} // namespace script
]=])
endfunction()
