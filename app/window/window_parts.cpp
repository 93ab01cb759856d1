// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/window_parts.h"

#include <utility>

#include <QDateTime>
#include <QDockWidget>
#include <QVBoxLayout>

#include "ui/models/preferences_store.h"
#include "ui/panels/plain_fields.h"

namespace planewright {

WindowParts::WindowParts(const ParameterOptions& given, const QString& settingsFile)
    : settings(settingsFile, QSettings::IniFormat),
      preferences(loadPreferences(settings)),
      session(sessionOptions(given)),
      window(std::make_unique<MainWindow>())
{
    given_ = given;
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

SessionOptions WindowParts::sessionOptions(const ParameterOptions& given)
{
    SessionOptions options;
    options.chooseParameters = [this, given](const std::string& scanner, std::vector<ParametersFrom> stored) {
        if (!given.preset.empty() || !stored.empty())
            return parametersInForce(given, scanner,
                                     given.preset.empty() ? std::move(stored) : std::vector<ParametersFrom>{});
        ParameterOptions preferred = given;
        preferred.preset = preferences.preset;
        auto chosen = parametersInForce(preferred, scanner, {});
        if (chosen)
            return chosen;
        log(LogSeverity::Warning, tr("preferences"),
            tr("The preset of a new scan cannot be used, the default is: %1")
                .arg(QString::fromStdString(chosen.error().message)));
        return parametersInForce(given, scanner, {});
    };
    return options;
}

std::function<Result<std::vector<ParametersFrom>>(const std::string&, std::vector<ParametersFrom>)>
WindowParts::parametersOfFiles() const
{
    ParameterOptions preferred = given_;
    if (preferred.preset.empty())
        preferred.preset = preferences.preset;
    return [given = given_, preferred](const std::string& scanner, std::vector<ParametersFrom> stored) {
        const bool usesStored = given.preset.empty() && !stored.empty();
        return parametersInForce(usesStored ? given : preferred, scanner,
                                 usesStored ? std::move(stored) : std::vector<ParametersFrom>{});
    };
}

void WindowParts::makePanels()
{
    setupTabs_ = new QTabWidget;
    setupTabs_->setObjectName(QStringLiteral("setupTabs"));
    setupTabs_->setDocumentMode(true);
    sourcePanel = new SourcePanel;
    parametersPanel = new ParametersPanel(parameters);
    layersPanel = new LayersPanel;
    clipBoxPanel = new ClipBoxPanel;
    auto* look = new QWidget;
    auto* lookLayout = new QVBoxLayout(look);
    lookLayout->setContentsMargins({});
    lookLayout->addWidget(layersPanel, 1);
    lookLayout->addWidget(clipBoxPanel);
    setupTabs_->addTab(sourcePanel, tr("Source"));
    setupTabs_->addTab(parametersPanel, tr("Parameters"));
    look_ = scrolling(look, setupTabs_);
    setupTabs_->addTab(look_, tr("Layers"));
    window->setPanel(QStringLiteral("dockSetup"), setupTabs_);

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

void WindowParts::showParameter(std::string_view key)
{
    window->findChild<QDockWidget*>(QStringLiteral("dockSetup"))->show();
    setupTabs_->setCurrentWidget(parametersPanel);
    parametersPanel->showParameter(key);
}

void WindowParts::showDevices()
{
    window->findChild<QDockWidget*>(QStringLiteral("dockSetup"))->show();
    setupTabs_->setCurrentWidget(sourcePanel);
    sourcePanel->showDevices();
}

void WindowParts::showClipBox()
{
    if (window->presents())
        return;
    window->findChild<QDockWidget*>(QStringLiteral("dockSetup"))->show();
    setupTabs_->setCurrentWidget(look_);
    look_->widget()->layout()->activate();
    look_->ensureWidgetVisible(clipBoxPanel);
}

void WindowParts::showMap()
{
    std::shared_ptr<const SessionMap> map = session.map();
    if (shownPhase) {
        auto phase = std::make_shared<SessionMap>(*map);
        phase->snapshot = shownPhase;
        map = std::move(phase);
    }
    worker.show({std::move(map), edits.inForce(), session.description(), session.parameters()});
}

const Parameters& WindowParts::extractedWith() const
{
    const std::vector<ExtractedStep>& steps = session.history();
    return steps.empty() || !steps.back().parameters ? session.parameters() : *steps.back().parameters;
}

void WindowParts::log(LogSeverity severity, const QString& source, const QString& text)
{
    if (preferences.logDetail == LogDetail::Problems && severity == LogSeverity::Info)
        return;
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
    window->setStatus(QStringLiteral("stMessage"), text, text);
}

}  // namespace planewright
