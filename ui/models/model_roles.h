// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Qt>

namespace planewright {

/// What cells answer beside Qt's own roles.
enum ModelRole : int {
    kSortRole = Qt::UserRole,  ///< the plain number of a cell in the unit of its heading, or its text; invalid: unknown
    kSecondSortRole,           ///< of a cell with two numbers, the second
    kPlainTextRole,            ///< all words of the row (asked of any of its cells) that a plain query looks through
    kLimitRole,                ///< the number that the cell's is held against
    kLineRole,                 ///< a TextLine: what the cell says, with tones
};

}  // namespace planewright
