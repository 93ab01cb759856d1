// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>

#include <QWidget>

#include "ui/models/map_selection.h"
#include "ui/models/slice_model.h"

class QLabel;
class QTableView;
class QToolButton;

namespace planewright {

class SliceView;

/// One slice as its segmentation saw it: the drawing, and beside it a list with the reasons.
class SlicePanel : public QWidget {
    Q_OBJECT

public:
    /// The selection must live as long as this.
    explicit SlicePanel(MapSelection& selection, QWidget* parent = nullptr);

    /// Null for none.
    void setSketch(std::shared_ptr<const SliceSketch> sketch);

    SliceView* view() const { return view_; }
    QTableView* list() const { return list_; }
    SliceModel& model() { return model_; }
    /// Whether the list stands beside the drawing, or in its place where there is no room for both.
    void showList(bool shown);
    QString summary() const;

signals:
    /// It can be seen now, or its theme is another: a slice that was not brought up to date is wanted.
    void shown();

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void arrange();
    void take(int row, bool add);
    void takeSelection();
    void giveRow();

    MapSelection& selection_;
    SliceModel model_;
    QLabel* summary_;
    QToolButton* listButton_;
    SliceView* view_;
    QTableView* list_;
    bool isNarrow_ = false;
    bool taking_ = false;  // a selection from elsewhere is on its way into the list
};

}  // namespace planewright
