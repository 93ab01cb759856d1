// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <QFrame>
#include <QPointer>

class QLabel;
class QPushButton;

namespace planewright {

/// Call-outs that point at parts of a window, one after the other. Escape ends them; whatever else somebody does goes
/// on beneath.
class Tour : public QFrame {
    Q_OBJECT

public:
    struct Stop {
        QPointer<QWidget> target;  ///< passed over while it cannot be seen
        QString text;
    };

    explicit Tour(QWidget* window);

    void start(std::vector<Stop> stops);
    void end();
    /// From 0; the number of stops where it is over.
    std::size_t stop() const { return current_; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void goOn();
    void place();

    QLabel* text_;
    QLabel* count_;
    QPushButton* next_;
    QFrame* ring_;  ///< around what is pointed at
    std::vector<Stop> stops_;
    std::size_t current_ = 0;
};

}  // namespace planewright
