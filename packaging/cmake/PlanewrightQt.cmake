# SPDX-FileCopyrightText: 2026 The Planewright authors
# SPDX-License-Identifier: BSD-3-Clause

get_target_property(MOC Qt6::moc IMPORTED_LOCATION)
configure_file("${CMAKE_CURRENT_LIST_DIR}/moc-alone.in" "${PROJECT_BINARY_DIR}/moc-alone" @ONLY)

# planewright_moc(<target>...): the sources and headers of these targets are read by Qt's moc, each file alone.
function(planewright_moc)
    set_target_properties(${ARGN} PROPERTIES AUTOMOC ON AUTOMOC_COMPILER_PREDEFS OFF
                                             AUTOMOC_EXECUTABLE "${PROJECT_BINARY_DIR}/moc-alone")
endfunction()
