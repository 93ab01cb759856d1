// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/session/recording_name.h"

#include <filesystem>
#include <system_error>

#include <QString>

namespace planewright {

std::string newRecordingPath(const std::string& folder, const QDateTime& time)
{
    const std::string begin = folder + "/" + time.toString(QStringLiteral("yyyy-MM-dd_HH-mm-ss")).toStdString();
    std::string path = begin + ".pwscan";
    std::error_code error;
    for (int number = 2; std::filesystem::exists(path, error); ++number)
        path = begin + "-" + std::to_string(number) + ".pwscan";
    return path;
}

}  // namespace planewright
