// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QDialog>
#include <QList>
#include <QPair>

namespace planewright {

/// What the program is, which versions it consists of, and its licence.
class AboutDialog : public QDialog {
    Q_OBJECT

public:
    /// `parts` are names and versions: the program's own first, then Qt, VTK, the renderer…
    explicit AboutDialog(const QList<QPair<QString, QString>>& parts, QWidget* parent = nullptr);
};

}  // namespace planewright
