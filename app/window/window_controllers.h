// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "app/window/charts_control.h"
#include "app/window/clip_control.h"
#include "app/window/compare_control.h"
#include "app/window/device_control.h"
#include "app/window/file_control.h"
#include "app/window/history_control.h"
#include "app/window/inspector_control.h"
#include "app/window/kept_view.h"
#include "app/window/lineage_control.h"
#include "app/window/map_control.h"
#include "app/window/measure_control.h"
#include "app/window/plane_edits.h"
#include "app/window/program_control.h"
#include "app/window/scan_control.h"
#include "app/window/slice_control.h"
#include "app/window/source_control.h"
#include "app/window/timeline_control.h"
#include "app/window/view_control.h"

namespace planewright {

/// All that connects the window's parts.
struct WindowControllers {
    WindowControllers(WindowParts& parts, ThemeFollower& follower)
        : view(parts, follower),
          clip(parts),
          scan(parts),
          history(parts),
          charts(parts),
          slice(parts),
          compare(parts, scan, follower),
          timeline(parts, history),
          inspector(parts, history),
          lineage(parts, inspector.tabs()),
          devices(parts, scan),
          source(parts, scan, devices),
          edits(parts),
          measure(parts),
          files(parts, scan),
          map(parts, files, follower),
          program(parts),
          kept(parts)
    {
        QObject::connect(&history, &HistoryControl::phaseShown, &scan, &ScanControl::setSeenPhase);
        QObject::connect(&kept, &KeptView::layersRead, &view, &ViewControl::setLayers);
    }

    ViewControl view;
    ClipControl clip;
    ScanControl scan;
    HistoryControl history;
    ChartsControl charts;
    SliceControl slice;
    CompareControl compare;
    TimelineControl timeline;
    InspectorControl inspector;
    LineageControl lineage;
    DeviceControl devices;
    SourceControl source;
    PlaneEdits edits;
    MeasureControl measure;
    FileControl files;
    MapControl map;
    ProgramControl program;
    KeptView kept;
};

}  // namespace planewright
