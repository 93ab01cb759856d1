// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/map_panel.h"

#include <algorithm>
#include <array>
#include <utility>

#include <QAction>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTabWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include "core/types/plane_words.h"
#include "ui/models/number_text.h"
#include "ui/panels/filtered_table.h"
#include "ui/panels/floor_plan_view.h"
#include "ui/panels/plain_fields.h"

namespace planewright {

namespace {

constexpr double kHighestCut = 100.0;  // [m]

using StopsKind = FilterKey::Kind;
constexpr std::array<FilterKey, 4> kStopsKeys{{
    {"stop", StopsKind::Number, static_cast<int>(StopsColumn::Stop)},
    {"floor", StopsKind::Number, static_cast<int>(StopsColumn::Floor)},
    {"sigma", StopsKind::Number, static_cast<int>(StopsColumn::Sigma)},
    {"open", StopsKind::Number, static_cast<int>(StopsColumn::Open)},
}};
constexpr std::array<FilterKey, 5> kMatchesKeys{{
    {"stop", StopsKind::Number, static_cast<int>(MatchesColumn::Stop)},
    {"state", StopsKind::Text, static_cast<int>(MatchesColumn::State)},
    {"class", StopsKind::Text, static_cast<int>(MatchesColumn::Class)},
    {"area", StopsKind::Number, static_cast<int>(MatchesColumn::Area)},
    {"chi", StopsKind::Number, static_cast<int>(MatchesColumn::ChiSquare)},
}};

QPushButton* mapButton(const QString& name, const QString& text, const QString& tip, QWidget* parent)
{
    auto* button = new QPushButton(text, parent);
    button->setObjectName(name);
    button->setToolTip(tip);
    return button;
}

QString summaryOf(const ShownBuilding& building)
{
    const auto placed = std::ranges::count_if(building.stops, &ShownStop::isPlaced);
    const auto unsure = std::ranges::count_if(
        building.stops, [](const ShownStop& stop) { return !stop.isOmitted() && !stop.warning.empty(); });
    QString text = MapPanel::tr("%1 placed, %2 of the map")
                       .arg(countText(placed, MapPanel::tr("stop"), MapPanel::tr("stops")),
                            countText(static_cast<qsizetype>(building.planes.size()), MapPanel::tr("plane"),
                                      MapPanel::tr("planes")));
    if (unsure > 0)
        text += MapPanel::tr("; ⚠ %1 to look at").arg(unsure);
    return text;
}

}  // namespace

MapPanel::MapPanel(StopsModel& stops, MatchesModel& matches, QWidget* parent)
    : QWidget(parent),
      stopsModel_(stops),
      matchesModel_(matches),
      summary_(new QLabel(this)),
      progress_(new QProgressBar(this)),
      close_(mapButton(QStringLiteral("mapClose"), tr("Close map"), tr("Go back to the scan"), this)),
      colourBy_(new QuietComboBox(this)),
      exports_(new QToolButton(this)),
      until_(new QuietSlider(this)),
      untilText_(new QLabel(this)),
      tabs_(new QTabWidget(this))
{
    setObjectName(QStringLiteral("mapPanel"));
    summary_->setObjectName(QStringLiteral("mapSummary"));
    summary_->setWordWrap(true);
    progress_->setObjectName(QStringLiteral("mapProgress"));
    progress_->setAccessibleName(tr("Progress of the map"));
    colourBy_->setObjectName(QStringLiteral("mapColourBy"));
    colourBy_->setAccessibleName(tr("What colours of planes tell"));
    for (const std::string_view name : kMapColourByNames)
        colourBy_->addItem(QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size())));
    exports_->setObjectName(QStringLiteral("mapExports"));
    exports_->setText(tr("Export"));
    exports_->setToolTip(tr("Write planes, poses or plans of the map to files"));
    exports_->setPopupMode(QToolButton::InstantPopup);
    until_->setObjectName(QStringLiteral("mapUntil"));
    until_->setAccessibleName(tr("The map after this stop"));
    until_->setOrientation(Qt::Horizontal);
    until_->setTracking(false);
    untilText_->setObjectName(QStringLiteral("mapUntilText"));

    auto* top = new QHBoxLayout;
    auto* colourLabel = new QLabel(tr("&Colour by"), this);
    colourLabel->setBuddy(colourBy_);
    top->addWidget(colourLabel);
    top->addWidget(colourBy_, 1);
    top->addWidget(exports_);
    top->addWidget(close_);
    auto* way = new QHBoxLayout;
    way->addWidget(untilText_);
    way->addWidget(until_, 1);
    tabs_->setObjectName(QStringLiteral("mapTabs"));
    tabs_->setDocumentMode(true);
    tabs_->addTab(makeStops(), tr("Stops"));
    tabs_->addTab(makeMatches(), tr("Matches"));
    tabs_->addTab(makePlan(), tr("Floor plan"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->addLayout(top);
    layout->addWidget(summary_);
    layout->addWidget(progress_);
    layout->addLayout(way);
    layout->addWidget(tabs_, 1);

    connect(close_, &QPushButton::clicked, this, [this] { isBusy_ ? emit cancelRequested() : emit closeRequested(); });
    connect(colourBy_, &QComboBox::currentIndexChanged, this, &MapPanel::colourByChosen);
    connect(until_, &QSlider::valueChanged, this, &MapPanel::untilChosen);
    setFocusProxy(tabs_);
    setBuilding(nullptr);
    setIdle();
}

QWidget* MapPanel::makeStops()
{
    auto* page = new QWidget(this);
    stops_ = new FilteredTable(&stopsModel_, kStopsKeys,
                               {.objectName = QStringLiteral("stopsTable"),
                                .accessibleName = tr("Stops of the map"),
                                .filterName = tr("Filter the stops"),
                                .filterPlaceholder = tr("Filter: floor:1 open>0"),
                                .emptyText = tr("The map is being made; stops appear here.")},
                               {0, 3, 4, 6, 7, 8, 9, 10}, page);
    stops_->view()->setEditTriggers(QAbstractItemView::NoEditTriggers);
    const QString number = QStringLiteral("00.000");
    stops_->setWidths({QStringLiteral("000"), QStringLiteral("000"), QStringLiteral("0"), number, number, number,
                       QStringLiteral("000.0"), QStringLiteral("00"), QStringLiteral("00"), QStringLiteral("00"),
                       tr("planes against odometry")});
    omit_ = mapButton(QStringLiteral("stopOmit"), tr("Take out"), tr("Make the map without this stop"), page);
    up_ = mapButton(QStringLiteral("stopUp"), tr("Earlier"), tr("Let the stop come before the one above it"), page);
    down_ = mapButton(QStringLiteral("stopDown"), tr("Later"), tr("Let the stop come after the one below it"), page);
    odometry_ = mapButton(QStringLiteral("stopOdometry"), tr("Odometry…"),
                          tr("Type in where wheels tell the stop to be, or that nobody knows"), page);
    warning_ = new QLabel(page);
    warning_->setObjectName(QStringLiteral("stopWarning"));
    warning_->setWordWrap(true);
    auto* buttons = new QHBoxLayout;
    for (QPushButton* button : {omit_, up_, down_, odometry_})
        buttons->addWidget(button);
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins({});
    layout->addWidget(stops_, 1);
    layout->addWidget(warning_);
    layout->addLayout(buttons);
    connect(stops_, &FilteredTable::chosenChanged, this, [this] {
        refreshStops();
        if (const int row = chosenStop(); row >= 0)
            emit stopChosen(row);
    });
    connect(omit_, &QPushButton::clicked, this, [this] {
        const ShownStop& stop = stopsModel_.stop(chosenStop());
        emit omitRequested(stop.scan, !stop.isOmitted());
    });
    connect(up_, &QPushButton::clicked, this, [this] { emit moveRequested(stopsModel_.stop(chosenStop()).scan, -1); });
    connect(down_, &QPushButton::clicked, this, [this] { emit moveRequested(stopsModel_.stop(chosenStop()).scan, 1); });
    connect(odometry_, &QPushButton::clicked, this,
            [this] { emit odometryRequested(stopsModel_.stop(chosenStop()).scan); });
    return page;
}

QWidget* MapPanel::makeMatches()
{
    auto* page = new QWidget(this);
    matches_ = new FilteredTable(&matchesModel_, kMatchesKeys,
                                 {.objectName = QStringLiteral("matchesTable"),
                                  .accessibleName = tr("Matches of the stops' planes"),
                                  .filterName = tr("Filter the matches"),
                                  .filterPlaceholder = tr("Filter: state:open stop:3 chi>10"),
                                  .emptyText = tr("The map is being made; matches appear here.")},
                                 {0, 1, 2, 4, 5, 6, 7}, page);
    matches_->view()->setEditTriggers(QAbstractItemView::NoEditTriggers);
    matches_->setWidths({QStringLiteral("000"), QStringLiteral("P000"), tr("ceiling"), QStringLiteral("00.00"),
                         tr("matched by hand"), QStringLiteral("P000"), QStringLiteral("00.00"),
                         QStringLiteral("P000, P000")});
    accept_ = mapButton(QStringLiteral("matchAccept"), tr("Accept"),
                        tr("Keep this match whatever else changes; an open plane is the first it may be"), page);
    reject_ = mapButton(QStringLiteral("matchReject"), tr("Reject"), tr("Make it a plane of its own"), page);
    target_ = new QuietComboBox(page);
    target_->setObjectName(QStringLiteral("matchTarget"));
    target_->setAccessibleName(tr("Plane of the map to match with"));
    force_ = mapButton(QStringLiteral("matchForce"), tr("Match with"), tr("Make it this plane of the map"), page);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(accept_);
    buttons->addWidget(reject_);
    buttons->addWidget(force_);
    buttons->addWidget(target_, 1);
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins({});
    layout->addWidget(matches_, 1);
    layout->addLayout(buttons);
    connect(matches_, &FilteredTable::chosenChanged, this, [this] {
        refreshMatches();
        if (const int row = chosenMatch(); row >= 0)
            emit matchChosen(row);
    });
    connect(accept_, &QPushButton::clicked, this, [this] { emit acceptRequested(chosenMatch()); });
    connect(reject_, &QPushButton::clicked, this, [this] { emit rejectRequested(chosenMatch()); });
    connect(force_, &QPushButton::clicked, this,
            [this] { emit forceRequested(chosenMatch(), target_->currentData().toInt()); });
    return page;
}

QWidget* MapPanel::makePlan()
{
    auto* page = new QWidget(this);
    floor_ = new QuietComboBox(page);
    floor_->setObjectName(QStringLiteral("planFloor"));
    floor_->setAccessibleName(tr("Floor of the plan"));
    height_ = new PlainSpinBox(page);
    height_->setObjectName(QStringLiteral("planHeight"));
    height_->setAccessibleName(tr("Height of the cut above the floor"));
    height_->setRange(0.0, kHighestCut);
    height_->setSingleStep(0.1);
    height_->setDecimals(2);
    height_->setSuffix(QStringLiteral(" m"));
    height_->setValue(1.0);
    plan_ = new FloorPlanView(page);
    auto* fields = new QHBoxLayout;
    auto* floorLabel = new QLabel(tr("F&loor"), page);
    floorLabel->setBuddy(floor_);
    auto* heightLabel = new QLabel(tr("Cut &above it"), page);
    heightLabel->setBuddy(height_);
    for (QWidget* widget : std::initializer_list<QWidget*>{floorLabel, floor_, heightLabel, height_})
        fields->addWidget(widget);
    fields->addStretch(1);
    placeFloor_ =
        mapButton(QStringLiteral("placeFloor"), tr("&Place floor…"),
                  tr("Say where this floor is in the building, or let it snap to the walls of another"), page);
    fields->addWidget(placeFloor_);
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins({});
    layout->addLayout(fields);
    layout->addWidget(plan_, 1);
    connect(floor_, &QComboBox::currentIndexChanged, this, &MapPanel::planRequested);
    connect(placeFloor_, &QPushButton::clicked, this, [this] { emit floorRequested(planFloor()); });
    connect(height_, &QDoubleSpinBox::valueChanged, this, &MapPanel::planRequested);
    return page;
}

void MapPanel::setBuilding(const std::shared_ptr<const ShownBuilding>& building)
{
    building_ = building;
    const QSignalBlocker quietUntil(until_);
    const QSignalBlocker quietFloor(floor_);
    const QString floor = floor_->currentText();
    floor_->clear();
    target_->clear();
    const bool any = building_ && building_->allStops > 0;
    until_->setEnabled(any);
    exports_->setEnabled(any);
    placeFloor_->setEnabled(any);
    if (!any) {
        summary_->setText(tr("No map yet."));
        untilText_->clear();
    } else {
        summary_->setText(summaryOf(*building_));
        const auto stops = std::ranges::count_if(building_->stops, [](const ShownStop& s) { return !s.isOmitted(); });
        until_->setRange(1, building_->allStops);
        until_->setValue(static_cast<int>(stops));
        untilText_->setText(tr("After stop %1 of %2").arg(stops - 1).arg(building_->allStops - 1));
        for (const int number : building_->floors)
            floor_->addItem(QString::number(number), number);
        floor_->setCurrentIndex(std::max(floor_->findText(floor), 0));
        for (std::size_t i = 0; i < building_->planes.size(); ++i)
            target_->addItem(QString::fromStdString(planeLabel(static_cast<PlaneId>(i))), static_cast<int>(i));
    }
    refreshStops();
    refreshMatches();
}

void MapPanel::setProgress(const QString& what, int done, int all)
{
    isBusy_ = true;
    progress_->setVisible(true);
    progress_->setFormat(what + QStringLiteral(" %v / %m"));
    progress_->setRange(0, all);
    progress_->setValue(done);
    close_->setText(tr("Cancel"));
    refreshStops();
    refreshMatches();
}

void MapPanel::setIdle()
{
    isBusy_ = false;
    progress_->setVisible(false);
    close_->setText(tr("Close map"));
    refreshStops();
    refreshMatches();
}

void MapPanel::setPlan(FloorPlanSketch sketch)
{
    plan_->setSketch(std::move(sketch));
}

void MapPanel::setExports(const QList<QAction*>& actions)
{
    exports_->addActions(actions);
}

void MapPanel::chooseMatch(int row)
{
    matches_->choose({row});
    refreshMatches();
}

MapColourBy MapPanel::colourBy() const
{
    return static_cast<MapColourBy>(colourBy_->currentIndex());
}

int MapPanel::planFloor() const
{
    return floor_->currentData().toInt();
}

double MapPanel::planHeight() const
{
    return height_->value();
}

int MapPanel::chosenStop() const
{
    const std::vector<int> rows = stops_->chosenRows();
    return rows.size() == 1 ? rows.front() : -1;
}

int MapPanel::chosenMatch() const
{
    const std::vector<int> rows = matches_->chosenRows();
    return rows.size() == 1 ? rows.front() : -1;
}

void MapPanel::refreshStops()
{
    const int row = building_ ? chosenStop() : -1;
    const bool any = row >= 0;
    const ShownStop* stop = any ? &stopsModel_.stop(row) : nullptr;
    const bool isThere = any && !stop->isOmitted();
    omit_->setText(any && stop->isOmitted() ? tr("Take in again") : tr("Take out"));
    omit_->setEnabled(any);
    up_->setEnabled(isThere && stop->number > 0);
    down_->setEnabled(isThere && stop->number + 1 < building_->allStops);
    odometry_->setEnabled(isThere);
    warning_->setText(any ? QString::fromStdString(stop->warning) : QString());
    warning_->setVisible(any && !stop->warning.empty());
}

void MapPanel::refreshMatches()
{
    const int row = building_ ? chosenMatch() : -1;
    const ShownMatch* match = row >= 0 ? &matchesModel_.matchAt(row) : nullptr;
    const bool isShared = match != nullptr && match->plane != kNoPlane &&
                          building_->planes[static_cast<std::size_t>(match->plane)].seenBy.size() > 1;
    accept_->setEnabled(isShared || (match != nullptr && !match->rivals.empty()));
    reject_->setEnabled(isShared || (match != nullptr && match->state == MatchState::Open));
    target_->setEnabled(match != nullptr);
    force_->setEnabled(match != nullptr && target_->count() > 0);
    if (match != nullptr && !match->rivals.empty())
        target_->setCurrentIndex(target_->findData(match->rivals.front()));
}

}  // namespace planewright
