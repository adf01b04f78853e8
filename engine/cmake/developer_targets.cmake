# format, format-check: the same clang-format over every C++ file.
file(GLOB_RECURSE formatted_files CONFIGURE_DEPENDS
    ecs/*.[ch]pp engine/*.[ch]pp systems/*.[ch]pp tools/*.[ch]pp tests/*.[ch]pp)
add_custom_target(format COMMAND clang-format -i ${formatted_files} WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}")
add_custom_target(format-check
    COMMAND clang-format --dry-run --Werror ${formatted_files} WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}")
