# SPDX-FileCopyrightText: 2026 The Planewright authors
# SPDX-License-Identifier: BSD-3-Clause

# Warnings, language standard and sanitizers travel with this target; every target of the project links it privately.
add_library(project_options INTERFACE)
target_compile_features(project_options INTERFACE cxx_std_20)
target_include_directories(project_options INTERFACE "${PROJECT_SOURCE_DIR}")
target_compile_options(project_options INTERFACE -Wall -Wextra -Wconversion -Wshadow)

option(PLANEWRIGHT_WERROR "Treat warnings as errors" ON)
if(PLANEWRIGHT_WERROR)
    target_compile_options(project_options INTERFACE -Werror)
endif()

# GCC 12 warns of overlapping copies in every "literal" + std::string (its bug 105651); GCC 13 does not.
target_compile_options(project_options INTERFACE
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>)

# Contraction into fused multiply-adds would make results depend on the processor the build was made for.
target_compile_options(project_options INTERFACE -ffp-contract=off)

set(PLANEWRIGHT_SANITIZE "" CACHE STRING "Sanitizers to build with, as in -fsanitize=")
if(PLANEWRIGHT_SANITIZE)
    add_compile_options(-fsanitize=${PLANEWRIGHT_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    add_link_options(-fsanitize=${PLANEWRIGHT_SANITIZE})
    # GCC 12 takes std::regex for uninitialised under a sanitizer (its bug 105562).
    target_compile_options(project_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endif()

option(PLANEWRIGHT_COVERAGE "Instrument for gcov" OFF)
if(PLANEWRIGHT_COVERAGE)
    add_compile_options(--coverage -fprofile-update=atomic)
    add_link_options(--coverage)
endif()
