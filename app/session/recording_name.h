// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <QDateTime>

namespace planewright {

/// A path in a folder that nothing has yet, named by the time: "2026-03-01_14-05-09.pwscan", and "…-2.pwscan" for
/// another one of the same second.
std::string newRecordingPath(const std::string& folder, const QDateTime& time);

}  // namespace planewright
