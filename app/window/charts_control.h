// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QObject>
#include <QTimer>

#include "app/window/window_parts.h"

namespace planewright {

class ChartsPanel;

/// Shows the charts of the scan with a cursor at the playhead, and goes to the steps that are clicked.
///
/// They grow with the scan, a few times a second at most and only while they can be seen.
class ChartsControl : public QObject {
    Q_OBJECT

public:
    explicit ChartsControl(WindowParts& parts);

    ChartsPanel& panel() { return *panel_; }

private:
    void request();
    void update();
    void save();

    WindowParts& parts_;
    ChartsPanel* panel_;
    QTimer due_;
    bool isOld_ = true;  // there are steps that the charts do not have
};

}  // namespace planewright
