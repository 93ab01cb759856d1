// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>

namespace planewright {

/// A program that has a node of /dev open.
struct PortHolder {
    int process = 0;      ///< 0: nobody tells which, only that there is one
    std::string program;  ///< "rosrun"; empty as above

    /// "the program rosrun (process 4711)", or "another program".
    std::string describe() const;
};

/// Who has a node open, of those programs that this user may look at; empty: none of them. Looks and touches nothing.
std::optional<PortHolder> holderOf(const std::string& node);

/// The same, and also whether a program that this user may not look at has locked it or taken it for its own
/// (flock, TIOCEXCL). Opens the node for a moment, which raises the lines of a modem: only for who is about to use it.
std::optional<PortHolder> holderOrLockOf(const std::string& node);

}  // namespace planewright
