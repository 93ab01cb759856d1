// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/preset_folder.h"

#include <sstream>

#include <QFile>
#include <QSaveFile>

#include "core/formats/preset_file.h"
#include "ui/models/parameter_model.h"

namespace planewright {

namespace {
constexpr qint64 kLargestFile = 1 << 20;
}

QStringList PresetFolder::load(ParameterModel& model) const
{
    QStringList problems;
    for (const QString& entry : folder_.entryList({QStringLiteral("*.json")}, QDir::Files, QDir::Name)) {
        const QString path = folder_.filePath(entry);
        QFile file(path);
        if (!file.open(QIODevice::ReadOnly)) {
            problems << QStringLiteral("%1: %2").arg(path, file.errorString());
            continue;
        }
        std::istringstream in(file.read(kLargestFile).toStdString());
        Parameters parameters;
        if (const auto read = readPresetFile(in, path.toStdString(), parameters); !read) {
            problems << QString::fromStdString(read.error().message);
            continue;
        }
        const QString problem = model.addPreset(entry.chopped(5), parameters);
        if (!problem.isEmpty())
            problems << QStringLiteral("%1: %2").arg(path, problem);
    }
    return problems;
}

Result<void> PresetFolder::save(const QString& name, const Parameters& parameters) const
{
    std::ostringstream out;
    if (auto written = writePresetFile(out, parameters); !written)
        return written;
    const QByteArray text = QByteArray::fromStdString(out.str());
    QSaveFile file(folder_.filePath(name + QStringLiteral(".json")));
    if (!folder_.mkpath(QStringLiteral(".")) || !file.open(QIODevice::WriteOnly) || file.write(text) != text.size() ||
        !file.commit())
        return fail(ErrorCode::NotWritten, file.fileName().toStdString() + ": " + file.errorString().toStdString() +
                                               "; the preset was not saved");
    return {};
}

}  // namespace planewright
