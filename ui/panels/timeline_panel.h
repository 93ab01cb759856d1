// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QWidget>

#include "ui/panels/timeline_strip.h"

class QAction;
class QComboBox;
class QLabel;
class QMenu;
class QSpinBox;

namespace planewright {

class LiveButton;

/// The actions that the timeline has buttons for.
struct TimelineActions {
    QAction* first;
    QAction* back;
    QAction* play;  ///< checked while it plays
    QAction* forward;
    QAction* last;
    QAction* loop;  ///< checked while there is a range that is played again and again
    QAction* eventBack;
    QAction* eventForward;
    QAction* live;
};

/// The timeline: buttons, and the strip of all steps. It shows what it is given and says what was asked for.
class TimelinePanel : public QWidget {
    Q_OBJECT

public:
    explicit TimelinePanel(const TimelineActions& actions, QWidget* parent = nullptr);

    TimelineStrip& strip() { return *strip_; }

    /// The places that there are. `planned`: steps that there will be, 0 where nobody knows; `isWhole`: none will come.
    void setColumns(std::vector<TimelineColumn> columns, int planned, bool isWhole);
    /// What is looked at; −1 for nothing.
    void setPlace(int place);
    /// Somebody looks back while the scan goes on.
    void setLooksBack(bool looksBack);

    /// How fast the history is played: 1 is the time that it took.
    double speed() const;
    /// One speed slower or faster, as far as there are any.
    void changeSpeed(int by);
    TimelineEvent eventKind() const;

    /// What may be done with a place, shown in a menu at it.
    void setPlaceActions(const QList<QAction*>& actions);
    /// The place of the menu that was shown last.
    int menuPlace() const { return menuPlace_; }

signals:
    void placeRequested(int place);
    /// A step that was typed, from 0.
    void stepRequested(int step);
    void loopRequested(std::optional<std::pair<int, int>> loop);
    void speedChanged(double speed);
    void eventKindChanged();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void makeRow(const TimelineActions& actions);

    TimelineStrip* strip_;
    QSpinBox* step_;
    QComboBox* speed_;
    QComboBox* kind_;
    LiveButton* live_;
    QMenu* menu_;
    int menuPlace_ = -1;
};

}  // namespace planewright
