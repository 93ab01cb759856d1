// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QWidget>

#include "ui/models/life_events_model.h"
#include "ui/panels/lineage_view.h"

class QLabel;
class QStackedWidget;
class QTableView;

namespace planewright {

/// Where the selected planes come from and what became of them: as a graph, and in words below it.
class LineagePanel : public QWidget {
    Q_OBJECT

public:
    explicit LineagePanel(QWidget* parent = nullptr);

    /// A chart without bars: nothing is selected.
    void setChart(LineageChart chart);
    void setChosen(std::set<PlaneId> planes) { view_->setChosen(std::move(planes)); }
    /// The step that is looked at, −1 for the forced last pass; `isThere` false for none.
    void setStep(int step, bool isThere = true);
    void setPlanePalette(PlanePalette palette) { view_->setPlanePalette(palette); }

    LineageView* view() const { return view_; }
    QTableView* table() const { return table_; }
    const LifeEventsModel& model() const { return model_; }
    /// The text that stands in the graph's place, or nothing.
    QString shownInstead() const;

signals:
    /// The panel has come into view.
    void shown();
    /// A plane at a step (−1 the forced last pass) is to be looked at.
    void planeChosen(planewright::PlaneId plane, int step);

protected:
    void showEvent(QShowEvent* event) override;

private:
    void makeTable();
    void choose(std::size_t event);
    void chooseRow(std::optional<std::size_t> event);

    LifeEventsModel model_;
    LineageView* view_;
    QTableView* table_;
    QStackedWidget* stack_;
    QLabel* instead_;
    bool choosing_ = false;
};

}  // namespace planewright
