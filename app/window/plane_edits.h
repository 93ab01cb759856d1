// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QObject>

#include "app/window/window_parts.h"

namespace planewright {

/// Actions of planes: what the operator says of them, each of which can be taken back.
class PlaneEdits : public QObject {
    Q_OBJECT

public:
    explicit PlaneEdits(WindowParts& parts);

private:
    void connectActions();
    void connectTable();
    void edit(Edit::Kind kind, std::vector<PlaneId> planes, const QString& text = {}, bool on = true);
    void take(const Result<void>& result);
    void refresh();
    void showHistory();
    std::vector<PlaneId> selected() const;
    /// Planes that are hidden, or are not.
    std::vector<PlaneId> planesThat(bool hidden) const;

    WindowParts& parts_;
};

}  // namespace planewright
