// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>

#include <QObject>
#include <QTimer>

#include "app/window/window_parts.h"
#include "ui/common/slice_sketch.h"

namespace planewright {

class SlicePanel;

/// Shows the slice at the playhead with what its segmentation did, in the colours of the 3D view.
///
/// A slice is traced again by the code and the parameters that it was extracted with, a few times a second at most and
/// only while the panel can be seen.
class SliceControl : public QObject {
    Q_OBJECT

public:
    explicit SliceControl(WindowParts& parts);

    SlicePanel& panel() { return *panel_; }

private:
    void request();
    void update();
    std::shared_ptr<const SliceSketch> sketch() const;

    WindowParts& parts_;
    SlicePanel* panel_;
    QTimer due_;
};

}  // namespace planewright
