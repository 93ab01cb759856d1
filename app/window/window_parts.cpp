// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/window_parts.h"

#include <utility>

#include <QDateTime>
#include <QTabWidget>

#include "ui/models/preferences_store.h"

namespace planewright {

WindowParts::WindowParts(SessionOptions options, const QString& settingsFile)
    : settings(settingsFile, QSettings::IniFormat),
      preferences(loadPreferences(settings)),
      session(std::move(options)),
      window(std::make_unique<MainWindow>())
{
    layers.palette = preferences.palette;
    makePanels();
    connect(&worker, &MapWorker::shown, this,
            [this](const std::shared_ptr<const ShownMap>& map, const QStringList& problems) {
                if (problems != editProblems_) {
                    for (const QString& text : problems)
                        log(LogSeverity::Warning, tr("edits"), text);
                    editProblems_ = problems;
                }
                take(map);
            });
}

WindowParts::~WindowParts() = default;

void WindowParts::makePanels()
{
    auto* setup = new QTabWidget;
    setup->setObjectName(QStringLiteral("setupTabs"));
    setup->setDocumentMode(true);
    sourcePanel = new SourcePanel;
    parametersPanel = new ParametersPanel(parameters);
    layersPanel = new LayersPanel;
    setup->addTab(sourcePanel, tr("Source"));
    setup->addTab(parametersPanel, tr("Parameters"));
    setup->addTab(layersPanel, tr("Layers"));
    window->setPanel(QStringLiteral("dockSetup"), setup);

    planesPanel = new PlanesPanel(planes, selection);
    planesPanel->setObjectName(QStringLiteral("planesPanel"));
    window->setPanel(QStringLiteral("dockPlanes"), planesPanel);

    segmentsPanel = new SegmentsPanel(segments, selection);
    segmentsPanel->setObjectName(QStringLiteral("segmentsPanel"));
    measurePanel = new MeasurePanel(measurements);
    measurePanel->setObjectName(QStringLiteral("measurePanel"));
    logPanel = new LogPanel(logModel);
    logPanel->setObjectName(QStringLiteral("logPanel"));
    window->addBottomPanel(segmentsPanel, tr("Segments"));
    window->addBottomPanel(measurePanel, tr("Measurements"));
    window->addBottomPanel(logPanel, tr("Log"));
}

void WindowParts::take(const std::shared_ptr<const ShownMap>& map)
{
    shown = map;
    selection.keepWhatIsIn(*map);
    planes.setMap(map);
    segments.setMap(map);
    measurements.setMap(map);
    window->view().setMap(map);
    emit mapShown();
}

void WindowParts::showMap()
{
    worker.show({session.map(), edits.inForce(), session.description(), session.parameters()});
}

void WindowParts::log(LogSeverity severity, const QString& source, const QString& text)
{
    logModel.append({QDateTime::currentDateTime(), severity, source, text});
}

void WindowParts::problem(const QString& source, const Error& error)
{
    const QString text = QString::fromStdString(error.message);
    log(LogSeverity::Error, source, text);
    window->banner().showMessage(Banner::Kind::Problem, text);
}

void WindowParts::say(const QString& text)
{
    window->setStatus(QStringLiteral("stMessage"), text);
}

}  // namespace planewright
