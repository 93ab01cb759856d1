// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <memory>
#include <optional>

#include <QObject>
#include <QScrollArea>
#include <QSettings>
#include <QTabWidget>

#include "app/cli/parameter_options.h"
#include "app/session/scan_session.h"
#include "app/window/background_work.h"
#include "app/window/edit_history.h"
#include "app/window/map_worker.h"
#include "app/window/undo_line.h"
#include "ui/common/layer_settings.h"
#include "ui/common/preferences.h"
#include "ui/main_window.h"
#include "ui/models/log_model.h"
#include "ui/models/map_selection.h"
#include "ui/models/measurements_model.h"
#include "ui/models/parameter_model.h"
#include "ui/models/planes_model.h"
#include "ui/models/playhead.h"
#include "ui/models/segments_model.h"
#include "ui/panels/clip_box_panel.h"
#include "ui/panels/layers_panel.h"
#include "ui/panels/log_panel.h"
#include "ui/panels/measure_panel.h"
#include "ui/panels/parameters_panel.h"
#include "ui/panels/planes_panel.h"
#include "ui/panels/segments_panel.h"
#include "ui/panels/source_panel.h"

namespace planewright {

/// The window program's parts, which its controllers connect. Widgets belong to the window.
class WindowParts : public QObject {
    Q_OBJECT

public:
    /// What the command line says of parameters goes before the preset that the preferences name.
    WindowParts(const ParameterOptions& parameters, const QString& settingsFile);
    ~WindowParts() override;

    /// A line of the log; a problem is also shown as a banner.
    void log(LogSeverity severity, const QString& source, const QString& text);
    void problem(const QString& source, const Error& error);
    /// A sentence in the status bar.
    void say(const QString& text);

    /// Lets the user see and change a parameter.
    void showParameter(std::string_view key);
    /// Lets the user see the form of laser and tilt unit.
    void showDevices();

    /// Lets the user see and change the clip box, unless the view is to be seen alone.
    void showClipBox();

    /// Something is still being worked out for what the window shows, or written.
    bool isAtWork() const
    {
        return worker.isBusy() || background.isBusy() || (isComparing && isComparing()) || (isTrying && isTrying()) ||
               (isMoving && isMoving()) || (isMapping && isMapping());
    }

    /// What the newest step was extracted with; the session's parameters without one.
    const Parameters& extractedWith() const;

    /// What a scan of a file is extracted with: what is stored with it, or else as a new one would be. To be called on
    /// any thread.
    std::function<Result<std::vector<ParametersFrom>>(const std::string& scanner, std::vector<ParametersFrom> stored)>
    parametersOfFiles() const;

    /// Asks for the session's map with the edits in force.
    void showMap();

    QSettings settings;
    Preferences preferences;
    LayerSettings layers;

    MapSelection selection;
    Playhead playhead;
    PlanesModel planes;
    SegmentsModel segments;
    MeasurementsModel measurements;
    LogModel logModel;
    ParameterModel parameters;

    ScanSession session;
    EditHistory edits;
    MapEditHistory mapEdits;
    UndoLine undo{session, edits, mapEdits};
    MapWorker worker;
    BackgroundWork background;
    std::function<bool()> isComparing;  ///< of whoever shows a second map
    std::function<bool()> isTrying;     ///< of whoever looks for devices and tests them
    std::function<bool()> isMapping;    ///< of whoever makes a map of several stops
    std::function<bool()> isMoving;     ///< of whoever tells of steps: it waits for the playhead to rest
    /// Of whoever knows what an address needs beside it: called before it is opened.
    std::function<Result<void>(const std::string& fileOrAddress)> beforeOpen;
    /// What the window shows; never null.
    std::shared_ptr<const ShownMap> shown = std::make_shared<ShownMap>();

    /// The scan after a phase of the step that is looked at; null for the whole step.
    std::shared_ptr<const Snapshot> shownPhase;

    /// What went wrong since something was opened last.
    std::optional<Error> fault;

    std::unique_ptr<MainWindow> window;
    PlanesPanel* planesPanel;
    SegmentsPanel* segmentsPanel;
    MeasurePanel* measurePanel;
    LogPanel* logPanel;
    ParametersPanel* parametersPanel;
    LayersPanel* layersPanel;
    ClipBoxPanel* clipBoxPanel;
    SourcePanel* sourcePanel;

signals:
    /// `shown` is another map.
    void mapShown();
    void layersChanged();
    void preferencesChanged();

private:
    SessionOptions sessionOptions(const ParameterOptions& given);

    ParameterOptions given_;  ///< on the command line
    void makePanels();
    void take(const std::shared_ptr<const ShownMap>& map);

    QTabWidget* setupTabs_ = nullptr;
    QScrollArea* look_ = nullptr;
    QStringList editProblems_;
};

}  // namespace planewright
