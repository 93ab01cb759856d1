// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QTimer>
#include <QToolButton>

namespace planewright {

/// What a button of the timeline does, drawn in the colour of text: the fonts of a system may lack these signs.
enum class TimelineGlyph { First, Back, Play, Forward, Last, Loop, Earlier, Later };

/// A button with a sign; its name and its tip with the shortcut are the action's.
class TimelineButton : public QToolButton {
    Q_OBJECT

public:
    TimelineButton(TimelineGlyph glyph, QAction* action, QWidget* parent = nullptr);

    QSize sizeHint() const override;

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    TimelineGlyph glyph_;
};

/// The button that goes back to what is newest: amber while somebody looks back at a scan that goes on, and pulsing,
/// unless motion is to be reduced.
class LiveButton : public QToolButton {
    Q_OBJECT

public:
    explicit LiveButton(QAction* action, QWidget* parent = nullptr);

    /// Whether the scan goes on behind the back of whoever looks at it.
    void setCalling(bool calls);
    bool isCalling() const { return calls_; }
    bool pulses() const { return pulse_.isActive(); }

    QSize sizeHint() const override;

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    bool calls_ = false;
    int beat_ = 0;
    QTimer pulse_;
};

}  // namespace planewright
