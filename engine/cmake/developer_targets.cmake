# Targets for people: what they do stands in ./dev.
foreach(verb format format-check lint)
    add_custom_target(${verb} COMMAND ./dev ${verb} WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}" USES_TERMINAL)
endforeach()
