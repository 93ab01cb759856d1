// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/charts_control.h"

#include <QFileDialog>

#include "ui/charts/charts_panel.h"
#include "ui/common/error_limit.h"
#include "ui/common/scan_charts.h"

namespace planewright {

namespace {

/// Between two pictures of a scan that goes on.
constexpr std::chrono::milliseconds kChartsPause{400};

}  // namespace

ChartsControl::ChartsControl(WindowParts& parts) : QObject(&parts), parts_(parts), panel_(new ChartsPanel)
{
    parts_.window->addBottomPanel(panel_, tr("Charts"));
    due_.setSingleShot(true);
    due_.setInterval(kChartsPause);
    connect(&due_, &QTimer::timeout, this, &ChartsControl::update);
    connect(&parts_.playhead, &Playhead::historyChanged, this, &ChartsControl::request);
    connect(&parts_.session, &ScanSession::parametersChanged, this, &ChartsControl::request);
    connect(&parts_.playhead, &Playhead::placeChanged, panel_, &ChartsPanel::setPlace);
    connect(panel_, &ChartsPanel::placeChosen, &parts_.playhead, &Playhead::goTo);
    connect(panel_, &ChartsPanel::saveRequested, this, &ChartsControl::save);
    connect(panel_, &ChartsPanel::shown, this, [this] {
        if (isOld_)
            update();
    });
    connect(parts_.window->actions()[QStringLiteral("actShowCharts")], &QAction::triggered, panel_, [this] {
        parts_.window->showBottomPanel(panel_->objectName());
        panel_->setFocus();
    });
    panel_->setCharts(scanCharts({}, errorLimitOf(parts_.extractedWith())));
}

/// A timer that runs already is left alone, so that charts grow while steps come faster than they are drawn.
void ChartsControl::request()
{
    isOld_ = true;
    if (panel_->isVisible() && !due_.isActive())
        due_.start();
}

void ChartsControl::update()
{
    due_.stop();
    if (!panel_->isVisible())
        return;
    isOld_ = false;
    panel_->setCharts(scanCharts(parts_.playhead.history(), errorLimitOf(parts_.extractedWith())));
    panel_->setPlace(parts_.playhead.place());
}

void ChartsControl::save()
{
    const QString folder = parts_.settings.value(QStringLiteral("folder")).toString();
    QString filter;
    QString file = QFileDialog::getSaveFileName(
        parts_.window.get(), tr("Save charts"),
        (folder.isEmpty() ? QString() : folder + QLatin1Char('/')) + QStringLiteral("charts.png"),
        tr("PNG pictures (*.png);;SVG pictures (*.svg)"), &filter);
    if (file.isEmpty())
        return;
    if (QFileInfo(file).suffix().isEmpty())
        file += filter.contains(QLatin1String("svg")) ? QStringLiteral(".svg") : QStringLiteral(".png");
    parts_.settings.setValue(QStringLiteral("folder"), QFileInfo(file).absolutePath());
    if (panel_->savePicture(file))
        parts_.say(tr("Wrote %1").arg(file));
    else
        parts_.problem(tr("charts"),
                       {ErrorCode::NotWritten, file.toStdString() + ": cannot be written. Choose another folder."});
}

}  // namespace planewright
