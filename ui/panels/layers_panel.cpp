// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/layers_panel.h"

#include <cmath>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QSlider>
#include <QVBoxLayout>

#include "ui/panels/plain_fields.h"

namespace planewright {

namespace {

constexpr double kPercent = 100.0;
constexpr int kSizeWidth = 54;  // [px]

QString asciiText(std::string_view ascii)
{
    return QString::fromLatin1(ascii.data(), static_cast<qsizetype>(ascii.size()));
}

QString capitalised(QString text)
{
    text[0] = text[0].toUpper();
    return text;
}

}  // namespace

LayersPanel::LayersPanel(QWidget* parent)
    : QWidget(parent), colourBy_(new QuietComboBox(this)), labels_(new QCheckBox(tr("Names on planes"), this))
{
    setObjectName(QStringLiteral("layersPanel"));
    auto* content = new QWidget(this);
    auto* grid = new QGridLayout(content);
    grid->setContentsMargins(8, 8, 8, 8);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(2);
    grid->setColumnStretch(1, 1);

    colourBy_->setObjectName(QStringLiteral("colourBy"));
    colourBy_->setAccessibleName(tr("Colour by"));
    for (const std::string_view name : kColourByNames)
        colourBy_->addItem(capitalised(asciiText(name)));
    auto* colourLabel = new QLabel(tr("Colour b&y"), content);
    colourLabel->setBuddy(colourBy_);
    grid->addWidget(colourLabel, 0, 0);
    grid->addWidget(colourBy_, 0, 1, 1, 2);
    auto* opacityTitle = new QLabel(tr("Opacity"), content);
    auto* sizeTitle = new QLabel(tr("Size, px"), content);
    grid->addWidget(opacityTitle, 1, 1);
    grid->addWidget(sizeTitle, 1, 2);
    for (std::size_t i = 0; i < kLayers; ++i)
        addRow(grid, static_cast<Layer>(i));
    labels_->setObjectName(QStringLiteral("layerLabels"));
    labels_->setAccessibleName(labels_->text());
    grid->addWidget(labels_, grid->rowCount(), 0, 1, 3);
    grid->setRowStretch(grid->rowCount(), 1);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    layout->addWidget(content);
    setTabOrder(colourBy_, rows_.front().visible);
    for (std::size_t i = 0; i < kLayers; ++i) {
        setTabOrder(rows_[i].visible, rows_[i].opacity);
        setTabOrder(rows_[i].opacity, rows_[i].size);
        setTabOrder(rows_[i].size, i + 1 < kLayers ? rows_[i + 1].visible : labels_);
    }
    setSettings(settings_);
    connect(colourBy_, &QComboBox::currentIndexChanged, this, &LayersPanel::change);
    connect(labels_, &QCheckBox::toggled, this, &LayersPanel::change);
}

void LayersPanel::addRow(QGridLayout* grid, Layer layer)
{
    const QString name = asciiText(kLayerNames[static_cast<std::size_t>(layer)]);
    Row& row = rows_[static_cast<std::size_t>(layer)];
    row.visible = new QCheckBox(name, this);
    row.visible->setObjectName(QStringLiteral("layer%1").arg(static_cast<int>(layer)));
    row.visible->setAccessibleName(tr("Show %1").arg(name));
    row.opacity = new QuietSlider(this);
    row.opacity->setObjectName(QStringLiteral("opacity%1").arg(static_cast<int>(layer)));
    row.opacity->setRange(5, 100);
    row.opacity->setPageStep(10);
    row.opacity->setMinimumWidth(30);
    row.opacity->setAccessibleName(tr("Opacity of %1, percent").arg(name));
    row.size = new PlainSpinBox(this);
    row.size->setObjectName(QStringLiteral("size%1").arg(static_cast<int>(layer)));
    row.size->setRange(0.5, 20.0);
    row.size->setSingleStep(0.5);
    row.size->setDecimals(1);
    row.size->setFixedWidth(kSizeWidth);
    row.size->setAccessibleName(tr("Size of %1, pixels").arg(name));
    const int line = grid->rowCount();
    grid->addWidget(row.visible, line, 0);
    grid->addWidget(row.opacity, line, 1);
    grid->addWidget(row.size, line, 2);
    connect(row.visible, &QCheckBox::toggled, this, &LayersPanel::change);
    connect(row.opacity, &QSlider::valueChanged, this, &LayersPanel::change);
    connect(row.size, &QDoubleSpinBox::valueChanged, this, &LayersPanel::change);
}

void LayersPanel::setSettings(const LayerSettings& settings)
{
    settings_ = settings;
    taking_ = true;
    for (std::size_t i = 0; i < kLayers; ++i) {
        const LayerStyle& style = settings.styles[i];
        rows_[i].visible->setChecked(style.visible);
        rows_[i].opacity->setValue(static_cast<int>(std::lround(style.opacity * kPercent)));
        rows_[i].opacity->setToolTip(tr("%1 %").arg(rows_[i].opacity->value()));
        rows_[i].size->setValue(style.size);
        rows_[i].opacity->setEnabled(style.visible);
        rows_[i].size->setEnabled(style.visible);
    }
    colourBy_->setCurrentIndex(static_cast<int>(settings.colourBy));
    labels_->setChecked(settings.labels);
    taking_ = false;
}

void LayersPanel::change()
{
    if (taking_)
        return;
    LayerSettings changed = settings_;
    for (std::size_t i = 0; i < kLayers; ++i) {
        changed.styles[i].visible = rows_[i].visible->isChecked();
        changed.styles[i].opacity = rows_[i].opacity->value() / kPercent;
        changed.styles[i].size = rows_[i].size->value();
    }
    changed.colourBy = static_cast<ColourBy>(colourBy_->currentIndex());
    changed.labels = labels_->isChecked();
    setSettings(changed);
    emit settingsChanged(settings_);
}

}  // namespace planewright
