// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QImage>
#include <QSize>
#include <QString>

#include "app/window/picture_size.h"
#include "app/window/window_parts.h"
#include "core/types/error.h"

namespace planewright {

/// A picture of the 3D view of any size, or of the whole window as it is. The PNG's text chunks hold program, step,
/// parameters and camera.
QImage takePicture(WindowParts& parts, QSize size, bool wholeWindow);

/// Writes a picture beside the target and gives it its name when it is complete. Errors: Usage for a name that does not
/// end in .png; NotWritten.
Result<void> savePicture(const QImage& picture, const QString& file);

/// Makes the window as large as a picture of it is to be [px of the layout: a scaled screen has more]. Errors: Usage
/// where it cannot be so small, or so large.
Result<void> resizeForPicture(WindowParts& parts, QSize size);

}  // namespace planewright
