// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QImage>
#include <QString>

namespace planewright {

/// How far a picture may be from its reference: other processors and other versions of the renderer round otherwise.
inline constexpr int kChannelTolerance = 8;       ///< of 255
inline constexpr double kShareTolerance = 0.005;  ///< of the pixels
inline constexpr int kFewestColours = 50;         ///< a picture with fewer is blank

/// What is wrong with a picture beside the reference of a name in `reference_images`; empty if nothing. With
/// PLANEWRIGHT_WRITE_REFERENCES set to a folder the picture is written there, to be looked at; with it set to the
/// folder of the references it becomes one. A picture that differs is left in the test's temporary folder.
QString differenceFromReference(const QImage& picture, const QString& name);

/// How many colours a picture has, counted up to a limit.
int coloursOf(const QImage& picture, int limit);

}  // namespace planewright
