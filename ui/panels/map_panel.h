// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <vector>

#include <QWidget>

#include "core/formats/floor_plan_sketch.h"
#include "ui/common/layer_settings.h"
#include "ui/models/matches_model.h"
#include "ui/models/stops_model.h"

class QAction;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSlider;
class QTabWidget;
class QToolButton;

namespace planewright {

class FilteredTable;
class FloorPlanView;

/// A map of several stops: which stops it is made of, what each of their planes is in it, and its plan. What somebody
/// wishes is a signal; the panel shows it when a map comes that has it.
class MapPanel : public QWidget {
    Q_OBJECT

public:
    /// The models must live as long as this.
    MapPanel(StopsModel& stops, MatchesModel& matches, QWidget* parent = nullptr);

    /// Null: there is no map.
    void setBuilding(const std::shared_ptr<const ShownBuilding>& building);
    /// A map is being made: so many of all.
    void setProgress(const QString& what, int done, int all);
    void setIdle();
    void setPlan(FloorPlanSketch sketch);
    /// What the button of exports offers.
    void setExports(const QList<QAction*>& actions);
    /// Keeps a row in sight and chosen.
    void chooseMatch(int row);

    MapColourBy colourBy() const;
    int planFloor() const;
    double planHeight() const;
    FilteredTable* stopsTable() const { return stops_; }
    FilteredTable* matchesTable() const { return matches_; }

signals:
    void cancelRequested();
    void closeRequested();
    void colourByChosen();
    /// The map as it was after so many stops.
    void untilChosen(int stops);
    void omitRequested(int scan, bool omitted);
    /// One place up (−1) or down.
    void moveRequested(int scan, int by);
    void odometryRequested(int scan);
    void acceptRequested(int row);
    void rejectRequested(int row);
    void forceRequested(int row, planewright::PlaneId plane);
    void matchChosen(int row);
    void stopChosen(int row);
    /// Another floor, or another height.
    void planRequested();
    void floorRequested(int floor);

private:
    QWidget* makeStops();
    QWidget* makeMatches();
    QWidget* makePlan();
    void refreshStops();
    void refreshMatches();
    int chosenStop() const;
    int chosenMatch() const;

    StopsModel& stopsModel_;
    MatchesModel& matchesModel_;
    std::shared_ptr<const ShownBuilding> building_;
    QLabel* summary_;
    QProgressBar* progress_;
    QPushButton* close_;
    QComboBox* colourBy_;
    QToolButton* exports_;
    QSlider* until_;
    QLabel* untilText_;
    QTabWidget* tabs_;
    FilteredTable* stops_ = nullptr;
    QPushButton* omit_ = nullptr;
    QPushButton* up_ = nullptr;
    QPushButton* down_ = nullptr;
    QPushButton* odometry_ = nullptr;
    QLabel* warning_ = nullptr;
    FilteredTable* matches_ = nullptr;
    QPushButton* accept_ = nullptr;
    QPushButton* reject_ = nullptr;
    QComboBox* target_ = nullptr;
    QPushButton* force_ = nullptr;
    QComboBox* floor_ = nullptr;
    QDoubleSpinBox* height_ = nullptr;
    QPushButton* placeFloor_ = nullptr;
    FloorPlanView* plan_ = nullptr;
    bool isBusy_ = false;
};

}  // namespace planewright
