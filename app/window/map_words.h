// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QString>

#include "core/formats/map_edit.h"

namespace planewright {

/// An edit of a map in a line, as "Scan 3: P05 is P02 of scan 1".
QString lineOf(const MapEdit& edit);

}  // namespace planewright
