// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/map_control.h"

#include <algorithm>
#include <utility>

#include "app/window/asking.h"
#include "app/window/place_dialog.h"

namespace planewright {

namespace {

constexpr std::size_t kFewestStops = 2;

/// The edits in force by their seq.
std::vector<int> seqsInForce(const MapEditHistory& history)
{
    std::vector<int> seqs;
    for (const StoredMapEdit& edit : history.all()) {
        if (!edit.undone)
            seqs.push_back(edit.seq);
    }
    return seqs;
}

MapEdit mapEditOf(MapEdit::Kind kind, int scan)
{
    MapEdit edit;
    edit.kind = kind;
    edit.scan = scan;
    return edit;
}

QString filtersOfExport(MapExport kind)
{
    QStringList filters;
    for (const std::string_view suffix : suffixesOf(kind))
        filters.push_back(QStringLiteral("*") +
                          QString::fromUtf8(suffix.data(), static_cast<qsizetype>(suffix.size())));
    return filters.isEmpty() ? QStringLiteral("*.txt") : filters.join(QStringLiteral(";;"));
}

}  // namespace

MapControl::MapControl(WindowParts& parts, FileControl& files, ThemeFollower& follower)
    : QObject(&parts),
      parts_(parts),
      files_(files),
      follower_(follower),
      panel_(new MapPanel(stops_, matches_, parts.window.get()))
{
    panel_->hide();
    parts_.isMapping = [this] { return isBusy(); };
    connect(parts_.window->actions()[QStringLiteral("actMapMode")], &QAction::toggled, this, &MapControl::show);
    connect(&parts_.session, &ScanSession::projectChanged, this, &MapControl::takeProject);
    connect(&parts_.session, &ScanSession::projectBegun, this, &MapControl::refreshActions);
    connect(&parts_.undo, &UndoLine::changed, this, &MapControl::takeUndo);
    connect(&worker_, &BuildingWorker::progressed, this,
            [this](const QString& what, int done, int all) { panel_->setProgress(what, done, all); });
    connect(&worker_, &BuildingWorker::made, this, &MapControl::takeMap);
    connect(&worker_, &BuildingWorker::failed, this, &MapControl::takeFailure);
    connectPanel();
    connectExports();
    refreshActions();
}

void MapControl::connectPanel()
{
    connect(panel_, &MapPanel::cancelRequested, this, [this] {
        worker_.cancel();
        panel_->setIdle();
        if (!map_)
            parts_.window->actions()[QStringLiteral("actMapMode")]->setChecked(false);
    });
    connect(panel_, &MapPanel::closeRequested, this,
            [this] { parts_.window->actions()[QStringLiteral("actMapMode")]->setChecked(false); });
    connect(panel_, &MapPanel::colourByChosen, this, [this] {
        LayerSettings layers = parts_.layers;
        layers.mapColourBy = panel_->colourBy();
        parts_.window->mapView().setLayers(layers);
    });
    connect(panel_, &MapPanel::untilChosen, this, [this](int stops) {
        until_ = map_ && stops == map_->shown->building->allStops ? std::nullopt : std::optional(stops);
        request();
    });
    connect(panel_, &MapPanel::omitRequested, this, [this](int scan, bool omitted) {
        MapEdit omit = mapEditOf(MapEdit::Kind::Omit, scan);
        omit.on = omitted;
        edit(omit);
    });
    connect(panel_, &MapPanel::moveRequested, this, &MapControl::move);
    connect(panel_, &MapPanel::odometryRequested, this, &MapControl::askOdometry);
    connect(panel_, &MapPanel::acceptRequested, this, [this](int row) {
        const ShownMatch& shown = matches_.matchAt(row);
        match(row, sightingOf(shown.plane != kNoPlane ? shown.plane : shown.rivals.front(), shown.own));
    });
    connect(panel_, &MapPanel::rejectRequested, this, [this](int row) { match(row, std::nullopt); });
    connect(panel_, &MapPanel::forceRequested, this, [this](int row, PlaneId plane) {
        if (const auto as = sightingOf(plane, matches_.matchAt(row).own))
            match(row, as);
        else
            parts_.say(tr("That plane of the map is this one, seen by this stop alone."));
    });
    connect(panel_, &MapPanel::matchChosen, this, [this](int row) {
        const ShownMatch& shown = matches_.matchAt(row);
        chosen_ = shown.own;
        select(shown.plane != kNoPlane ? std::vector{shown.plane} : shown.rivals);
    });
    connect(panel_, &MapPanel::stopChosen, this, [this](int row) {
        const int scan = stops_.stop(row).scan;
        std::vector<PlaneId> planes;
        for (std::size_t i = 0; i < map_->planes.size(); ++i) {
            const auto& seenBy = map_->shown->building->planes[i].seenBy;
            if (std::ranges::find(seenBy, scan, &StopPlane::scan) != seenBy.end())
                planes.push_back(static_cast<PlaneId>(i));
        }
        select(planes);
    });
    connect(panel_, &MapPanel::planRequested, this, &MapControl::drawPlan);
    connect(panel_, &MapPanel::floorRequested, this, &MapControl::askFloor);
}

void MapControl::connectExports()
{
    WindowActions& actions = parts_.window->actions();
    const auto on = [&](const char* name, MapExport kind, const QString& title, const QString& file) {
        QAction* action = actions[QLatin1String(name)];
        connect(action, &QAction::triggered, this, [=, this] { exportWithDialog(kind, title, file); });
        return action;
    };
    panel_->setExports(
        {on("actExportMapPlanes", MapExport::MapPlanes, tr("Export planes of the map"), QStringLiteral("map.csv")),
         on("actExportMapPoses", MapExport::MapPoses, tr("Export poses of the stops"), QStringLiteral("poses.txt")),
         on("actExportMapPlan", MapExport::MapPlan, tr("Export the plan of a floor"), QStringLiteral("plan.dxf"))});
}

/// The map's view looks like the first one.
void MapControl::connectView()
{
    if (std::exchange(isLinked_, true))
        return;
    View3d& view = parts_.window->mapView();
    if (const auto presented = view.present(parts_.window->view().presented()); !presented)
        parts_.problem(tr("map"), presented.error());
    const auto applyLayers = [this, &view] {
        LayerSettings layers = parts_.layers;
        layers.mapColourBy = panel_->colourBy();
        view.setLayers(layers);
    };
    connect(&parts_, &WindowParts::layersChanged, this, applyLayers);
    connect(&parts_, &WindowParts::preferencesChanged, this, [this, &view] { view.setTheme(follower_.theme()); });
    connect(&follower_, &ThemeFollower::themeChanged, &view, &View3d::setTheme);
    connect(&view, &View3d::clicked, this, [this](const std::optional<Picked>& picked, bool /*add*/) {
        if (!map_ || !picked || picked->plane == kNoPlane) {
            select({});
            return;
        }
        select({picked->plane});
        const StopPlane& first = map_->shown->building->planes[static_cast<std::size_t>(picked->plane)].seenBy.front();
        chosen_ = first;
        panel_->chooseMatch(matches_.rowOf(first));
    });
    applyLayers();
    view.setTheme(follower_.theme());
}

void MapControl::takeProject()
{
    parts_.window->actions()[QStringLiteral("actMapMode")]->setChecked(false);
    map_.reset();
    until_.reset();
    chosen_.reset();
    stops_.setBuilding(nullptr);
    matches_.setBuilding(nullptr);
    panel_->setBuilding(nullptr);
    refreshActions();
    QAction* action = parts_.window->actions()[QStringLiteral("actMapMode")];
    if (!action->isEnabled() || parts_.window->banner().isVisible())
        return;
    parts_.window->banner().showMessage(Banner::Kind::Notice,
                                        tr("This file has several scans: they can be one map of all stops."),
                                        {{tr("Make the map"), [action] { action->setChecked(true); }}});
}

void MapControl::refreshActions()
{
    WindowActions& actions = parts_.window->actions();
    const PwscanProject* project = parts_.session.project();
    const auto scans = project != nullptr ? project->scans() : Result<std::vector<ScanRecord>>();
    actions[QStringLiteral("actMapMode")]->setEnabled(scans && scans->size() >= kFewestStops);
    for (const char* name : {"actExportMapPlanes", "actExportMapPoses", "actExportMapPlan"})
        actions[QLatin1String(name)]->setEnabled(map_ != nullptr);
}

void MapControl::show(bool on)
{
    if (!on) {
        if (auto* placing = parts_.window->findChild<PlaceDialog*>(QStringLiteral("floorDialog")))
            placing->reject();
        worker_.cancel();
        panel_->setIdle();
        parts_.window->showMapMode(false);
        return;
    }
    connectView();
    parts_.window->showMapMode(true, panel_);
    panel_->setFocus();
    request();
}

void MapControl::request()
{
    const PwscanProject* project = parts_.session.project();
    if (project == nullptr || !parts_.window->showsMapMode())
        return;
    shownEdits_ = seqsInForce(parts_.mapEdits);
    panel_->setProgress(tr("making the map"), 0, 0);
    worker_.make({project->path(), parts_.mapEdits.inForce(), until_, parts_.session.scanInProject(),
                  parts_.parametersOfFiles()});
}

void MapControl::takeMap(const std::shared_ptr<const BuiltMap>& map)
{
    map_ = map;
    const auto& building = map->shown->building;
    stops_.setBuilding(building);
    matches_.setBuilding(building);
    panel_->setBuilding(building);
    panel_->setIdle();
    View3d& view = parts_.window->mapView();
    view.setSelection({});
    view.setMap(map->shown);
    if (chosen_)
        panel_->chooseMatch(matches_.rowOf(*chosen_));
    drawPlan();
    refreshActions();
    for (const std::string& problem : map->problems)
        parts_.log(LogSeverity::Warning, tr("map"), QString::fromStdString(problem));
    if (!std::ranges::all_of(building->floors.begin() + 1, building->floors.end(),
                             [this](int floor) { return isPlacedByHand(floor); }))
        parts_.say(tr("Floors stand where odometry says until they are placed by hand."));
}

void MapControl::takeFailure(const Error& error)
{
    panel_->setIdle();
    parts_.problem(tr("map"), error);
}

/// Undo and redo are of all edits: those of the map make it anew.
void MapControl::takeUndo()
{
    if (parts_.window->showsMapMode() && seqsInForce(parts_.mapEdits) != shownEdits_)
        request();
}

void MapControl::edit(const MapEdit& edit)
{
    if (const auto done = parts_.undo.add(edit); !done)
        parts_.problem(tr("edits"), done.error());
}

void MapControl::move(int scan, int by)
{
    if (until_) {
        parts_.say(tr("Look at the map after the last stop to change the order."));
        return;
    }
    std::vector<int> order;
    for (int row = 0; row < stops_.rowCount(); ++row) {
        if (!stops_.stop(row).isOmitted())
            order.push_back(stops_.stop(row).scan);
    }
    const auto place = std::ranges::find(order, scan) - order.begin();
    // Before the one above it, or before the second one below it.
    const auto before = by < 0 ? place - 1 : place + 2;
    MapEdit moved = mapEditOf(MapEdit::Kind::Order, scan);
    if (before < 0)
        return;
    if (before < static_cast<std::ptrdiff_t>(order.size()))
        moved.before = order[static_cast<std::size_t>(before)];
    edit(moved);
}

void MapControl::askOdometry(int scan)
{
    const int row = stops_.rowOfScan(scan);
    if (row < 0)
        return;
    const ShownStop& stop = stops_.stop(row);
    auto* dialog = new PlaceDialog({QStringLiteral("odometry"), tr("Odometry of stop %1").arg(stop.number),
                                    tr("It is &known where wheels tell it to be")},
                                   stop.told, Pose{}, parts_.window.get());
    connect(dialog, &QDialog::accepted, this, [this, scan, dialog] {
        MapEdit typed = mapEditOf(MapEdit::Kind::Odometry, scan);
        typed.odometry = dialog->place();
        edit(typed);
    });
    ask(dialog);
}

std::optional<SeenPlane> MapControl::sightingOf(PlaneId plane, const StopPlane& own) const
{
    for (const StopPlane& seen : map_->shown->building->planes[static_cast<std::size_t>(plane)].seenBy) {
        if (seen.scan != own.scan || seen.plane != own.plane)
            return SeenPlane{seen.scan, seen.plane};
    }
    return std::nullopt;
}

void MapControl::match(int row, const std::optional<SeenPlane>& as)
{
    const StopPlane own = matches_.matchAt(row).own;
    MapEdit matched = mapEditOf(MapEdit::Kind::Match, own.scan);
    matched.plane = own.plane;
    matched.as = as;
    chosen_ = own;
    edit(matched);
}

void MapControl::select(const std::vector<PlaneId>& planes)
{
    SceneSelection selection;
    selection.planes.insert(planes.begin(), planes.end());
    parts_.window->mapView().setSelection(selection);
}

void MapControl::drawPlan()
{
    if (!map_)
        return;
    const auto plan = std::ranges::find(map_->plans, panel_->planFloor(), &FloorPlan::floor);
    if (plan != map_->plans.end())
        panel_->setPlan(floorPlanSketch(plan->planes, plan->height + panel_->planHeight(), plan->stops));
}

void MapControl::exportWithDialog(MapExport kind, const QString& title, const QString& name)
{
    if (!map_)
        return;
    const QString file = files_.chosenTarget(title, name, filtersOfExport(kind));
    if (!file.isEmpty())
        files_.write(tr("export"), file, exportOf(map_, kind, file, panel_->planFloor(), panel_->planHeight()));
}

}  // namespace planewright
