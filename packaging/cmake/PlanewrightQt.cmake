# SPDX-FileCopyrightText: 2026 The Planewright authors
# SPDX-License-Identifier: BSD-3-Clause

# planewright_moc(<target>...): the sources and headers of these targets are read by Qt's moc.
function(planewright_moc)
    # moc stumbles over <compare>, <numbers> and others where libstdc++'s own configuration was not read before.
    set_target_properties(${ARGN} PROPERTIES AUTOMOC ON AUTOMOC_MOC_OPTIONS "--include;version")
endfunction()
