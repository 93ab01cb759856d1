// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <QWidget>

#include "ui/charts/chart_table_model.h"
#include "ui/charts/chart_view.h"

class QAction;
class QComboBox;
class QGridLayout;
class QScrollArea;
class QStackedWidget;
class QTableView;
class QToolButton;

namespace planewright {

/// The charts of a scan: one of them large, or as many beside each other as there is room for; as a table, too.
class ChartsPanel : public QWidget {
    Q_OBJECT

public:
    explicit ChartsPanel(QWidget* parent = nullptr);

    /// Always as many as the first time.
    void setCharts(const std::vector<Chart>& charts);
    /// The place in the history that the cursor is at; −1 for none.
    void setPlace(int place);

    /// The number of the chart that is shown alone; −1 for all.
    int chosen() const;
    void choose(int chart);
    bool showsTable() const;
    void showTable(bool shown);

    const std::vector<ChartView*>& views() const { return views_; }
    QTableView* table() const { return table_; }
    /// "Copy data", Ctrl+C while the panel has the keyboard.
    QAction* copyAction() const { return copy_; }

    /// The numbers of what is shown, as text with tabs.
    QString dataText() const;
    /// What is shown as a picture: as SVG where the name ends so, else as PNG. False where it cannot be written.
    bool savePicture(const QString& file) const;

signals:
    void placeChosen(int place);
    /// A file is wanted for the picture.
    void saveRequested();
    /// It can be seen now: charts that were not brought up to date while it was hidden are wanted.
    void shown();

protected:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    QToolButton* addButton(const char* name, const QString& text, const QString& tip);
    void makeViews(const std::vector<Chart>& charts);
    void arrange();
    void fillTable();
    std::vector<Chart> shownCharts() const;
    void paintShown(QPainter& painter, const QSize& size) const;

    QComboBox* chooser_;
    QToolButton* tableButton_;
    QAction* copy_;
    QStackedWidget* pages_;
    QScrollArea* scroll_;
    QWidget* board_;
    QGridLayout* grid_;
    QTableView* table_;
    ChartTableModel* model_;
    std::vector<ChartView*> views_;
    int columns_ = 0;
    int laidOut_ = -2;
};

}  // namespace planewright
