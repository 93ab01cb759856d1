// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "core/types/error.h"

namespace planewright {

/// Where the program's OpenGL functions come from: the system's library, or OSMesa, which needs no display.
///
/// VTK calls some forty OpenGL functions by name. The program defines these itself and passes them on, so that one
/// program can do both. The choice is made once, before anything is drawn.
enum class OpenGlSource { System, Osmesa };

OpenGlSource openGlSource();

/// Takes OpenGL from OSMesa from now on. Errors (NoRenderer): the library is not installed or lacks a function.
Result<void> useOsmesa();

/// A function of OSMesa's own, once useOsmesa() has succeeded.
void* osmesaFunction(const char* name);

}  // namespace planewright
