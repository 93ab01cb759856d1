// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QVariant>

#include "ui/models/planes_model.h"

namespace planewright {

/// What a cell of the table of planes says; "…" where it is still being worked out.
QString planeCellText(const ShownPlane& shown, PlaneColumn column, const LengthStyle& style);

/// The plain number or text of a cell, see PlanesModel; invalid where it is unknown.
QVariant planeCellValue(const ShownPlane& shown, PlaneColumn column);

/// The heading of a column, with its unit: in full for tool tips and screen readers, or as short as it stands in the
/// table.
QString planeColumnTitle(PlaneColumn column, const LengthStyle& style);
QString planeColumnMeaning(PlaneColumn column);

}  // namespace planewright
