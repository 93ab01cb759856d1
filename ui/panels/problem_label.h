// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QLabel>

namespace planewright {

/// A sentence about what is wrong, in the colour of that; hidden while nothing is.
class ProblemLabel : public QLabel {
    Q_OBJECT

public:
    explicit ProblemLabel(QWidget* parent = nullptr);

    /// Shows a sentence; an empty one hides the label.
    void tell(const QString& problem);

protected:
    void changeEvent(QEvent* event) override;

private:
    void colour();
};

}  // namespace planewright
