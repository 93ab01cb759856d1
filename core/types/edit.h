// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "core/types/plane.h"

namespace planewright {

/// What the operator says of planes that were found; the scan stays as it was recorded.
struct Edit {
    enum class Kind {
        Rename,    ///< `text` is the name; empty takes it away
        Classify,  ///< `text` is the class; empty gives the one by normal and height back
        Hide,      ///< kept, and not shown, while `on`
        Delete,
        Merge,  ///< two or more planes become one
        Split,  ///< one plane is searched for planes anew
        Lock,   ///< no other edit changes it, while `on`
    };
    Kind kind = Kind::Rename;
    std::vector<PlaneId> planes;  ///< one at least; of a merge the first gives name and class
    std::string text;             ///< of a name or class
    bool on = true;               ///< of Hide and Lock
};

}  // namespace planewright
