# SPDX-FileCopyrightText: 2026 The Planewright authors
# SPDX-License-Identifier: BSD-3-Clause

# moc stumbles over <compare>, <numbers> and others where libstdc++'s own configuration was not read before. The name of a
# header alone would be looked for in the build folder ever after, and everything built anew since it is not there.
file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/moc_first.h" CONTENT "#include <version>\n")

# planewright_moc(<target>...): the sources and headers of these targets are read by Qt's moc.
function(planewright_moc)
    set_target_properties(${ARGN} PROPERTIES AUTOMOC ON AUTOMOC_MOC_OPTIONS "--include;${PROJECT_BINARY_DIR}/moc_first.h")
endfunction()
