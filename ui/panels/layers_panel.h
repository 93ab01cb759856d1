// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>

#include <QWidget>

#include "ui/common/layer_settings.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QSlider;

namespace planewright {

/// Which layers the 3D view shows, how solid and how large, and what their colours tell.
class LayersPanel : public QWidget {
    Q_OBJECT

public:
    explicit LayersPanel(QWidget* parent = nullptr);

    const LayerSettings& settings() const { return settings_; }
    /// Shows settings from elsewhere, as from a shortcut that hides a layer; tells nobody.
    void setSettings(const LayerSettings& settings);

signals:
    void settingsChanged(const planewright::LayerSettings& settings);

private:
    struct Row {
        QCheckBox* visible = nullptr;
        QSlider* opacity = nullptr;
        QDoubleSpinBox* size = nullptr;
    };
    void addRow(QGridLayout* grid, Layer layer);
    void change();

    LayerSettings settings_;
    std::array<Row, kLayers> rows_;
    QComboBox* colourBy_;
    QCheckBox* labels_;
    bool taking_ = false;  // settings from elsewhere are on their way into the controls
};

}  // namespace planewright
