// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QObject>

#include "app/window/building_worker.h"
#include "app/window/file_control.h"
#include "app/window/map_exports.h"
#include "app/window/window_parts.h"
#include "ui/models/matches_model.h"
#include "ui/models/stops_model.h"
#include "ui/panels/map_panel.h"
#include "ui/theme/theme_follower.h"

namespace planewright {

class PlaceDialog;

/// Makes one map of all scans of the file and shows it in the place of the scan, with what the operator says of stops
/// and matches: edits of the file, in one line of undo with those of planes.
class MapControl : public QObject {
    Q_OBJECT

public:
    MapControl(WindowParts& parts, FileControl& files, ThemeFollower& follower);

    /// The map that is shown; null without one.
    const std::shared_ptr<const BuiltMap>& map() const { return map_; }
    bool isBusy() const { return worker_.isBusy(); }

private:
    void connectPanel();
    void connectView();
    void connectExports();
    void takeProject();
    void show(bool on);
    void refreshActions();
    void request();
    void takeMap(const std::shared_ptr<const BuiltMap>& map);
    void takeFailure(const Error& error);
    void takeUndo();
    void edit(const MapEdit& edit);
    void move(int scan, int by);
    void askOdometry(int scan);
    void askFloor(int number);
    void showHandles(const MappedFloor& floor, const Pose& there, PlaceDialog* dialog);
    bool isPlacedByHand(int floor) const;
    void match(int row, const std::optional<SeenPlane>& as);
    /// A sighting of a plane of the map by another stop than the one that saw `own`.
    std::optional<SeenPlane> sightingOf(PlaneId plane, const StopPlane& own) const;
    void select(const std::vector<PlaneId>& planes);
    void drawPlan();
    void exportWithDialog(MapExport kind, const QString& title, const QString& name);

    WindowParts& parts_;
    FileControl& files_;
    ThemeFollower& follower_;
    StopsModel stops_;
    MatchesModel matches_;
    MapPanel* panel_;
    std::shared_ptr<const BuiltMap> map_;
    std::vector<int> shownEdits_;      ///< those in force of the newest request, by their seq
    std::optional<int> until_;         ///< as many stops are looked at
    std::optional<StopPlane> chosen_;  ///< whose match comes into sight again
    bool isLinked_ = false;
    BuildingWorker worker_;
};

}  // namespace planewright
