// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <utility>
#include <vector>

#include <QFrame>
#include <QLabel>
#include <QPushButton>

namespace planewright {

/// A line below the tool bar for what happened to the user: what it was, what is safe, and what can be done. It takes
/// no focus and stops nothing.
class Banner : public QFrame {
    Q_OBJECT

public:
    enum class Kind { Notice, Problem };
    using Choice = std::pair<QString, std::function<void()>>;

    explicit Banner(QWidget* parent = nullptr);

    /// Shows a text with at most two choices; taking one hides the banner.
    void showMessage(Kind kind, const QString& text, const std::vector<Choice>& choices = {});
    QString text() const;

private:
    QLabel* text_;
    QPushButton* first_;
    QPushButton* second_;
    QPushButton* dismiss_;
};

}  // namespace planewright
