// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <QJsonObject>
#include <QString>

#include "app/window/scan_control.h"
#include "app/window/window_parts.h"
#include "core/types/error.h"

namespace planewright {

/// Performs actions on the window from a file: a JSON object a line, named as the actions of the window are.
class ScriptRunner {
public:
    ScriptRunner(WindowParts& parts, ScanControl& scan) : parts_(parts), scan_(scan) {}

    /// Performs all lines; the first that fails ends it. Errors name file, line and what to do: Unreadable for a file
    /// that cannot be read, GateFailed for a line that fails.
    Result<void> run(const QString& file);

    /// True once a line said `quit`.
    bool quits() const { return quits_; }

private:
    Result<void> perform(const QJsonObject& line);
    Result<void> open(const QJsonObject& line);
    Result<void> goTo(const QJsonObject& line);
    Result<void> select(const QJsonObject& line);
    Result<void> trigger(const QJsonObject& line);
    Result<void> set(const QJsonObject& line);
    Result<void> wait(const QJsonObject& line);
    Result<void> screenshot(const QJsonObject& line);
    Result<void> expect(const QJsonObject& line);
    Result<void> quit(const QJsonObject& line);
    Result<QObject*> objectOf(const QJsonObject& line);
    void settle();

    WindowParts& parts_;
    ScanControl& scan_;
    bool quits_ = false;
};

}  // namespace planewright
