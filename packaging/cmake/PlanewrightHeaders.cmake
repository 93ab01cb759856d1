# SPDX-FileCopyrightText: 2026 The Planewright authors
# SPDX-License-Identifier: BSD-3-Clause

# Headers of others are most of what a compiler reads here: they are compiled once for many targets. No source may rely on
# them: it includes what it uses, and clang-tidy, which reads none of them, would find where one does not.

# planewright_headers(<target> LIBRARIES <targets> HEADERS <headers>): the headers, compiled as targets with these libraries
# read them.
function(planewright_headers target)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LIBRARIES;HEADERS")
    file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/${target}.cpp" CONTENT "// Compiled to make the headers.\n")
    add_library(${target} OBJECT "${PROJECT_BINARY_DIR}/${target}.cpp")
    target_link_libraries(${target} PRIVATE ${arg_LIBRARIES} project_options)
    target_precompile_headers(${target} PRIVATE ${arg_HEADERS})
    # Clang would refuse headers that a compiler cache gives back after the sources were checked out anew.
    target_compile_options(${target} PRIVATE "$<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>")
endfunction()

# planewright_reuse_headers(<headers target> <target>...): these targets read the headers as they were compiled.
function(planewright_reuse_headers headers)
    foreach(target IN LISTS ARGN)
        target_precompile_headers(${target} REUSE_FROM ${headers})
        # Empty where a source includes its own moc, and reading the headers costs half a second.
        set_source_files_properties("${CMAKE_CURRENT_BINARY_DIR}/${target}_autogen/mocs_compilation.cpp"
                                    PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
        # The same false alarm as that of -Wrestrict, which a precompiled <string> brings under other names too.
        target_compile_options(${target} PRIVATE
            "$<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-array-bounds;-Wno-stringop-overflow;-Wno-stringop-overread>")
    endforeach()
endfunction()
