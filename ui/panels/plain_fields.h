// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QSlider>

class QScrollArea;

namespace planewright {

/// A box of choices that the wheel passes by unless it has the keyboard: a panel is scrolled without changing anything.
class QuietComboBox : public QComboBox {
    Q_OBJECT

public:
    explicit QuietComboBox(QWidget* parent = nullptr);

protected:
    void wheelEvent(QWheelEvent* event) override;
};

/// The same for a slider.
class QuietSlider : public QSlider {
    Q_OBJECT

public:
    explicit QuietSlider(QWidget* parent = nullptr);

protected:
    void wheelEvent(QWheelEvent* event) override;
};

/// A box of numbers with a decimal point in every locale, no more zeros than needed, and quiet as well.
class PlainSpinBox : public QDoubleSpinBox {
    Q_OBJECT

public:
    explicit PlainSpinBox(QWidget* parent = nullptr);

    QString textFromValue(double value) const override;

protected:
    void wheelEvent(QWheelEvent* event) override;
};

/// A widget that scrolls up and down where it does not fit, and is as wide as the place that it has.
QScrollArea* scrolling(QWidget* content, QWidget* parent);

}  // namespace planewright
