// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

namespace planewright::architecture {

/// One breach of the rules of the house.
struct Offence {
    std::string file;  ///< path from the top of the source tree
    int line = 0;      ///< from 1; 0 where the file as a whole offends
    std::string rule;  ///< the rule and what breaks it

    /// `file:line: rule`, as compilers print it.
    std::string text() const { return (line > 0 ? file + ':' + std::to_string(line) : file) + ": " + rule; }
};

using Offences = std::vector<Offence>;

}  // namespace planewright::architecture
