# SPDX-FileCopyrightText: 2026 The Planewright authors
# SPDX-License-Identifier: BSD-3-Clause

# planewright_test(<target> SOURCES <files> LIBRARIES <targets>): one QtTest executable, run by CTest without a display.
function(planewright_test target)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LIBRARIES")
    add_executable(${target} ${arg_SOURCES})
    set_target_properties(${target} PROPERTIES AUTOMOC ON)
    target_link_libraries(${target} PRIVATE ${arg_LIBRARIES} Qt6::Test project_options)
    add_test(NAME ${target} COMMAND ${target})
    set_tests_properties(${target} PROPERTIES ENVIRONMENT "QT_QPA_PLATFORM=offscreen;LC_ALL=C.UTF-8" TIMEOUT 600)
endfunction()
