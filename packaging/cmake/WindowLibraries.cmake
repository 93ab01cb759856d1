# SPDX-FileCopyrightText: 2026 The Planewright authors
# SPDX-License-Identifier: BSD-3-Clause

# What the window is made of. VTK's targets are known only to the folder that finds them, and below.
find_package(Qt6 6.4 REQUIRED COMPONENTS Core DBus Gui OpenGLWidgets Widgets)
find_package(VTK 9.1 REQUIRED COMPONENTS CommonCore CommonDataModel RenderingCore RenderingOpenGL2 glew opengl)

# planewright_window_program(<target>): VTK's factories are filled where a program is linked, not in libraries.
function(planewright_window_program target)
    vtk_module_autoinit(TARGETS ${target} MODULES VTK::RenderingCore VTK::RenderingOpenGL2)
endfunction()
