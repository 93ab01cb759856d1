// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <utility>

#include <QPainter>
#include <QWidget>

namespace planewright {

/// A sheet of glass over the picture of a presenter, on which its names, legend and state are written. The pointer goes
/// through it.
class OverlayWidget : public QWidget {
    Q_OBJECT

public:
    OverlayWidget(std::function<void(QPainter&)> paint, QWidget* parent) : QWidget(parent), paint_(std::move(paint))
    {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setAttribute(Qt::WA_NoSystemBackground);
        setFocusPolicy(Qt::NoFocus);
    }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        paint_(painter);
    }

private:
    std::function<void(QPainter&)> paint_;
};

}  // namespace planewright
