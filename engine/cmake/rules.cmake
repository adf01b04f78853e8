# engine_target(<name> SOURCES ... LINK ...): a static library with the project's rules.
add_library(project_rules INTERFACE)
target_compile_features(project_rules INTERFACE cxx_std_20)
target_include_directories(project_rules INTERFACE "${PROJECT_SOURCE_DIR}")
target_compile_options(project_rules INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wold-style-cast
    -Wnon-virtual-dtor -Woverloaded-virtual -Wdouble-promotion
    # GCC 12 raises false alarms about std::string here (its bug 105651).
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
target_compile_definitions(project_rules INTERFACE GLM_FORCE_DEPTH_ZERO_TO_ONE GLM_ENABLE_EXPERIMENTAL)

function(engine_target name)
    cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
    add_library(${name} STATIC ${ARG_SOURCES})
    target_link_libraries(${name} PUBLIC project_rules ${ARG_LINK})
    set_target_properties(${name} PROPERTIES CXX_EXTENSIONS OFF)
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
