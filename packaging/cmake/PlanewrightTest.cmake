# SPDX-FileCopyrightText: 2026 The Planewright authors
# SPDX-License-Identifier: BSD-3-Clause

include(PlanewrightQt)

foreach(label IN ITEMS app architecture core devices threads ui)
    add_custom_target(tests_${label})
endforeach()

# Every test reads Qt, Eigen and the standard library first: compiled once, not once a test.
file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/test_headers.cpp" CONTENT "// Compiled to make the headers of the tests.\n")
add_library(test_headers OBJECT "${PROJECT_BINARY_DIR}/test_headers.cpp")
target_link_libraries(test_headers PRIVATE Qt6::Core Eigen3::Eigen project_options)
target_precompile_headers(test_headers PRIVATE <QtCore> <Eigen/Geometry> <functional> <map> <optional> <sstream> <string> <vector>)

# planewright_test(<target> SOURCES <files> LIBRARIES <targets> [THREADS] [RUN_BY <program> <arguments>]): one QtTest
# executable, run by CTest without a display.
#
# A test sees no settings of the person who runs it: HOME, the XDG folders and TMPDIR are folders of its own in the build
# tree. It carries the name of its top-level folder under tests/ as CTest label, and is built by the target
# tests_<label>: tests_core builds the tests of core and no others. THREADS adds the label `threads`, for tests of threads
# without Qt outside core and devices, which the thread sanitizer is to see. RUN_BY is a program that runs the test, whose
# path it gets as its last argument. PLANEWRIGHT_SOURCE_DIR is the top of the source tree, as a string literal.
function(planewright_test target)
    cmake_parse_arguments(PARSE_ARGV 1 arg "THREADS" "" "SOURCES;LIBRARIES;RUN_BY")
    add_executable(${target} ${arg_SOURCES})
    planewright_moc(${target})
    target_link_libraries(${target} PRIVATE ${arg_LIBRARIES} Qt6::Test project_options)
    target_compile_definitions(${target} PRIVATE PLANEWRIGHT_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    target_precompile_headers(${target} REUSE_FROM test_headers)
    # Empty where a test includes its own moc, and reading the headers costs half a second.
    set_source_files_properties("${CMAKE_CURRENT_BINARY_DIR}/${target}_autogen/mocs_compilation.cpp"
                                PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
    # The same false alarm as that of -Wrestrict, which a precompiled <string> brings under other names too.
    target_compile_options(${target} PRIVATE
        "$<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-array-bounds;-Wno-stringop-overflow>")
    add_test(NAME ${target} COMMAND ${arg_RUN_BY} $<TARGET_FILE:${target}>)
    planewright_isolate_test(${target})

    if(arg_THREADS)
        set_property(TEST ${target} APPEND PROPERTY LABELS threads)
    endif()
    get_property(labels TEST ${target} PROPERTY LABELS)
    foreach(label IN LISTS labels)
        add_dependencies(tests_${label} ${target})
    endforeach()
endfunction()

# planewright_isolate_test(<test>): the environment and label of planewright_test for a test made by add_test().
function(planewright_isolate_test test)
    set(home "${PROJECT_BINARY_DIR}/test-homes/${test}")
    file(MAKE_DIRECTORY "${home}/config" "${home}/data" "${home}/cache" "${home}/state" "${home}/tmp")
    file(MAKE_DIRECTORY "${home}/run")
    file(CHMOD "${home}/run" DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)

    cmake_path(RELATIVE_PATH CMAKE_CURRENT_SOURCE_DIR BASE_DIRECTORY "${PROJECT_SOURCE_DIR}/tests" OUTPUT_VARIABLE label)
    string(REGEX REPLACE "/.*" "" label "${label}")

    set(environment
        QT_QPA_PLATFORM=offscreen
        LC_ALL=C.UTF-8
        TZ=UTC
        HOME=${home}
        TMPDIR=${home}/tmp
        XDG_CONFIG_HOME=${home}/config
        XDG_DATA_HOME=${home}/data
        XDG_CACHE_HOME=${home}/cache
        XDG_STATE_HOME=${home}/state
        XDG_RUNTIME_DIR=${home}/run)
    set_tests_properties(${test} PROPERTIES ENVIRONMENT "${environment}" LABELS "${label}")
endfunction()
