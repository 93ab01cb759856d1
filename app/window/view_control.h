// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include <QObject>

#include "app/window/window_parts.h"
#include "ui/theme/theme_follower.h"

namespace planewright {

/// Actions of the view: cameras, layers, colours, theme, clip box, and one selection for the view and the tables.
class ViewControl : public QObject {
    Q_OBJECT

public:
    /// `follower` was made while the application still had the desktop's palette.
    ViewControl(WindowParts& parts, ThemeFollower& follower);

    /// Layers as they are to be; the palette stays.
    void setLayers(const LayerSettings& settings);

private:
    void connectCameras();
    void connectLayers();
    void connectColours();
    void connectTheme();
    void connectSelection();
    void applyLayers();
    void applyDrawing();
    void applyTheme(Theme theme);
    void select(const std::optional<Picked>& picked, bool add);

    WindowParts& parts_;
    ThemeFollower& follower_;
};

}  // namespace planewright
