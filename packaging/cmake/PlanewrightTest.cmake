# SPDX-FileCopyrightText: 2026 The Planewright authors
# SPDX-License-Identifier: BSD-3-Clause

include(PlanewrightHeaders)

foreach(label IN ITEMS app architecture core devices threads ui)
    add_custom_target(tests_${label})
endforeach()

# Under sanitizers most of a test's compile time is the optimiser's, on code that runs for a moment; what is tested is
# optimised as ever. A test is not fuzzed either.
set(planewright_test_options "")
if(PLANEWRIGHT_SANITIZE AND CMAKE_CXX_COMPILER_ID STREQUAL Clang)
    set(planewright_test_options -O0 -fno-sanitize=fuzzer-no-link)
endif()

planewright_headers(test_headers
    LIBRARIES Qt6::Core Eigen3::Eigen
    HEADERS <QtCore> <Eigen/Geometry> <functional> <map> <optional> <sstream> <string> <vector>)
target_compile_options(test_headers PRIVATE ${planewright_test_options})

add_library(test_program STATIC "${PROJECT_SOURCE_DIR}/tests/test_program.cpp")
target_link_libraries(test_program PRIVATE Qt6::Test project_options)

# planewright_tests(<program> SOURCES <files> LIBRARIES <targets> [THREADS] [RUN_BY <program> <arguments>]): a program of
# QtTest classes, one for each source x_test.cpp; each is a test of CTest, x_test, and runs in a process of its own without
# a display. The target x_test builds its program.
#
# A test sees no settings of the person who runs it: HOME, the XDG folders and TMPDIR are folders of its own in the build
# tree. It carries the name of its top-level folder under tests/ as CTest label, and is built by the target
# tests_<label>: tests_core builds the tests of core and no others. THREADS adds the label `threads`, for tests of threads
# without Qt outside core and devices, which the thread sanitizer is to see. RUN_BY is a program that runs the test, whose
# path and name it gets as its last arguments. PLANEWRIGHT_SOURCE_DIR is the top of the source tree, as a string literal.
function(planewright_tests program)
    cmake_parse_arguments(PARSE_ARGV 1 arg "THREADS" "" "SOURCES;LIBRARIES;RUN_BY")
    add_executable(${program} ${arg_SOURCES})
    planewright_moc_tests(${program} ${arg_SOURCES})
    target_link_libraries(${program} PRIVATE test_program ${arg_LIBRARIES} Qt6::Test project_options)
    target_compile_definitions(${program} PRIVATE PLANEWRIGHT_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    target_compile_options(${program} PRIVATE ${planewright_test_options})
    planewright_reuse_headers(test_headers ${program})

    foreach(source IN LISTS arg_SOURCES)
        cmake_path(GET source STEM test)
        if(NOT test MATCHES "_test$")
            continue()
        endif()
        if(NOT TARGET ${test})
            add_custom_target(${test} DEPENDS ${program})
        endif()
        add_test(NAME ${test} COMMAND ${arg_RUN_BY} $<TARGET_FILE:${program}> ${test})
        planewright_isolate_test(${test})
        if(arg_THREADS)
            set_property(TEST ${test} APPEND PROPERTY LABELS threads)
        endif()
        get_property(labels TEST ${test} PROPERTY LABELS)
        foreach(label IN LISTS labels)
            add_dependencies(tests_${label} ${program})
        endforeach()
    endforeach()
endfunction()

# planewright_moc_tests(<target> <sources>): x.moc for each x_test.cpp, which includes it. Automoc would start, read and
# compile some files for each of the many programs; a class of tests needs none of what it looks for.
function(planewright_moc_tests target)
    foreach(source IN LISTS ARGN)
        cmake_path(GET source STEM name)
        if(name MATCHES "_test$")
            add_custom_command(OUTPUT "${name}.moc"
                               COMMAND Qt6::moc "${CMAKE_CURRENT_SOURCE_DIR}/${source}" -o "${name}.moc"
                               DEPENDS "${source}" VERBATIM)
            target_sources(${target} PRIVATE "${CMAKE_CURRENT_BINARY_DIR}/${name}.moc")
        endif()
    endforeach()
    target_include_directories(${target} PRIVATE "${CMAKE_CURRENT_BINARY_DIR}")
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

# planewright_opengl_test(<name> <program> <test>): runs a test of a program once more, with OpenGL on a display of its
# own. Sanitizers do not look for the ends of all strings there, since xkbcommon copies from buffers that have none, nor for
# leaks, which drivers and D-Bus have; the same test without OpenGL tells those of the product.
function(planewright_opengl_test name program test)
    find_program(XVFB_RUN xvfb-run REQUIRED)
    add_test(NAME ${name} COMMAND ${XVFB_RUN} -a -s "-screen 0 1600x1000x24" $<TARGET_FILE:${program}> ${test})
    planewright_isolate_test(${name})
    set_property(TEST ${name} APPEND PROPERTY ENVIRONMENT QT_QPA_PLATFORM=xcb
                 ASAN_OPTIONS=detect_stack_use_after_return=1:check_initialization_order=1:detect_leaks=0)
endfunction()
