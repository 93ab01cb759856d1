# SPDX-FileCopyrightText: 2026 The Planewright authors
# SPDX-License-Identifier: BSD-3-Clause

# What the window is made of. VTK's targets are known only to the folder that finds them, and below.
find_package(Qt6 6.4 REQUIRED COMPONENTS Core DBus Gui OpenGLWidgets Widgets)
find_package(VTK 9.1 REQUIRED COMPONENTS ChartsCore CommonCore CommonDataModel RenderingContext2D RenderingCore RenderingOpenGL2
                                 glew opengl)

# planewright_vtk_factories(<target>): fills VTK's factories from a library's sources, so that no program has to.
function(planewright_vtk_factories target)
    vtk_module_autoinit(TARGETS ${target} MODULES VTK::RenderingCore VTK::RenderingOpenGL2)
endfunction()
