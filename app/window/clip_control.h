// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QObject>

#include "app/window/window_parts.h"

namespace planewright {

/// The clip box: the action, its panel and the view agree. A box that nobody has set takes the upper part of the scan
/// away, so that one looks into the room from above.
class ClipControl : public QObject {
    Q_OBJECT

public:
    explicit ClipControl(WindowParts& parts);

private:
    void use(bool on);
    void show(const Eigen::AlignedBox3d& box);
    /// The scan's bounds with some air, up to a share of its height; empty without a scan.
    Eigen::AlignedBox3d around(double shareOfHeight) const;

    WindowParts& parts_;
    bool isSet_ = false;  ///< the panel holds a box of this scan
};

}  // namespace planewright
