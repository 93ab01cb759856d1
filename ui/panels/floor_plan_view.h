// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QWidget>

#include "core/formats/floor_plan_sketch.h"
#include "ui/common/palette.h"

namespace planewright {

/// A plan seen from above, as large as fits: walls, stops with their numbers, a grid of whole metres and a bar.
class FloorPlanView : public QWidget {
    Q_OBJECT

public:
    explicit FloorPlanView(QWidget* parent = nullptr);

    void setSketch(FloorPlanSketch sketch);
    const FloorPlanSketch& sketch() const { return sketch_; }
    QSize sizeHint() const override { return {360, 300}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    FloorPlanSketch sketch_;
};

}  // namespace planewright
