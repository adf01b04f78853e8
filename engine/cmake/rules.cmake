# engine_target(<name> SOURCES ... LINK ...): a static library with the project's rules.
add_library(project_rules INTERFACE)
target_compile_features(project_rules INTERFACE cxx_std_20)
target_include_directories(project_rules INTERFACE "${PROJECT_SOURCE_DIR}")
target_compile_options(project_rules INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wold-style-cast
    -Wnon-virtual-dtor -Woverloaded-virtual -Wdouble-promotion
    # GCC 12 raises false alarms about std::string here (its bugs 105651 and 105329).
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-stringop-overflow>)
# FMT_SHARED is what fmt::fmt defines: precompiled headers fit only targets that agree about it.
target_compile_definitions(project_rules INTERFACE GLM_FORCE_DEPTH_ZERO_TO_ONE GLM_ENABLE_EXPERIMENTAL FMT_SHARED)

# What nearly every file includes, compiled once for the engine and once for its tests. Files still include what they
# use: the fuzz and tidy presets build without these.
foreach(kind engine tests)
    file(GENERATE OUTPUT "${PROJECT_BINARY_DIR}/precompiled_${kind}.cpp" CONTENT "")
    add_library(precompiled_${kind} STATIC "${PROJECT_BINARY_DIR}/precompiled_${kind}.cpp")
    target_link_libraries(precompiled_${kind} PRIVATE project_rules)
    set_target_properties(precompiled_${kind} PROPERTIES CXX_EXTENSIONS OFF)
    target_precompile_headers(precompiled_${kind} PRIVATE
        <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <map> <memory> <optional> <set> <span>
        <string> <string_view> <unordered_map> <utility> <vector>
        <fmt/format.h> <fmt/ranges.h> <glm/glm.hpp> <glm/gtc/quaternion.hpp> <glm/gtc/matrix_transform.hpp>)
endforeach()
target_link_libraries(precompiled_tests PRIVATE GTest::gmock)
target_precompile_headers(precompiled_tests PRIVATE <gmock/gmock.h> <gtest/gtest.h>)

function(engine_target name)
    cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
    add_library(${name} STATIC ${ARG_SOURCES})
    target_link_libraries(${name} PUBLIC project_rules ${ARG_LINK})
    set_target_properties(${name} PROPERTIES CXX_EXTENSIONS OFF)
    target_precompile_headers(${name} REUSE_FROM precompiled_engine)
endfunction()

# cpu_tests, gl_tests and the like: everything that the tests of one label need; benchmarks: all of them.
foreach(label cpu gl capture lint)
    add_custom_target(${label}_tests)
endforeach()
add_custom_target(benchmarks)

# gnomon_test(<name> LABEL cpu|gl|capture|lint SOURCES ... LINK ...): one GoogleTest program.
function(gnomon_test name)
    cmake_parse_arguments(ARG "" "LABEL" "SOURCES;LINK" ${ARGN})
    add_executable(${name} ${ARG_SOURCES})
    target_link_libraries(${name} PRIVATE project_rules GTest::gmock GTest::gtest_main ${ARG_LINK})
    set_target_properties(${name} PROPERTIES CXX_EXTENSIONS OFF)
    target_precompile_headers(${name} REUSE_FROM precompiled_tests)
    target_compile_definitions(${name} PRIVATE PROJECT_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    add_dependencies(${ARG_LABEL}_tests ${name})
    gtest_discover_tests(${name}
        DISCOVERY_TIMEOUT 60
        PROPERTIES LABELS "${ARG_LABEL}" TIMEOUT 300 SKIP_REGULAR_EXPRESSION "\\[  SKIPPED \\]")
endfunction()

# gnomon_benchmark(<name> SOURCES ... LINK ...): one Google Benchmark program, run by ./dev bench; not part of "all".
function(gnomon_benchmark name)
    cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
    add_executable(${name} EXCLUDE_FROM_ALL ${ARG_SOURCES})
    add_dependencies(benchmarks ${name})
    target_link_libraries(${name} PRIVATE project_rules benchmark::benchmark_main ${ARG_LINK})
    set_target_properties(${name} PROPERTIES
        CXX_EXTENSIONS OFF RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bench")
endfunction()
