// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QObject>

#include "app/files/recording_file.h"
#include "app/window/exports.h"
#include "app/window/scan_control.h"
#include "app/window/window_parts.h"

namespace planewright {

/// Actions of files: open, copies, exports and pictures.
class FileControl : public QObject {
    Q_OBJECT

public:
    FileControl(WindowParts& parts, ScanControl& scan);

    /// The file that somebody chooses to write to; empty for none.
    QString chosenTarget(const QString& title, const QString& name, const QString& filters);
    /// Writes a file in the background, and tells how that went.
    void write(const QString& source, const QString& file, const Result<std::function<Result<void>()>>& writing);

private:
    void openWithDialog();
    void importWithDialog();
    void openChosen(const QString& file);
    void saveCopy();
    void exportWithDialog(ExportKind kind, const QString& title, const QString& name);
    void takeScreenshot();
    void takeScreenshotWithOptions();
    void save(const QImage& picture, const QString& file);
    void validate();
    void tellProblems(const QString& file, const Result<RecordingProblems>& problems);
    QString folder() const;

    WindowParts& parts_;
    ScanControl& scan_;
};

}  // namespace planewright
