// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QObject>

#include "app/window/window_parts.h"
#include "ui/tour.h"

namespace planewright {

/// Actions of the program itself: preferences, layouts, help.
class ProgramControl : public QObject {
    Q_OBJECT

public:
    explicit ProgramControl(WindowParts& parts);

    /// Versions and renderer, for the head of a bug report.
    QString versions() const;

private:
    void connectLayouts();
    void connectHelp();
    void applyShortcuts();
    void openPreferences();
    void connectTour();
    void startTour();
    void showPage(const QString& title, const QString& resource);

    WindowParts& parts_;
    QHash<QString, QList<QKeySequence>> ownShortcuts_;
    Tour* tour_;
    bool tourIsDue_ = false;  ///< as soon as there are planes
};

}  // namespace planewright
