// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include <QDBusVariant>
#include <QObject>

#include "ui/common/palette.h"
#include "ui/common/preferences.h"

namespace planewright {

/// Knows which theme the window is to have: the one chosen, or that of the desktop.
///
/// What the desktop prefers is asked of its settings portal (org.freedesktop.appearance, color-scheme), as Qt does not
/// tell before 6.5; where there is none, the palette that Qt came up with decides. The portal also knows whether motion
/// is to be reduced (reduced-motion).
class ThemeFollower : public QObject {
    Q_OBJECT

public:
    /// Made before the first applyTheme(), while the application still has the desktop's palette.
    explicit ThemeFollower(QObject* parent = nullptr);

    void setChoice(ThemeChoice choice);
    Theme theme() const;

    /// Asks the portal; the answer comes as themeChanged() where it changes anything.
    void askDesktop();

    /// What a value of color-scheme stands for: 1 dark, 2 light, all else nothing.
    static std::optional<Theme> preferred(unsigned int colorScheme);

signals:
    void themeChanged(planewright::Theme theme);

public slots:
    /// The portal's signal.
    void takeSetting(const QString& group, const QString& key, const QDBusVariant& value);

private:
    void ask(const QString& key);
    void setDesktop(std::optional<Theme> theme);

    ThemeChoice choice_ = ThemeChoice::System;
    std::optional<Theme> desktop_;
    Theme atStart_;
};

}  // namespace planewright
