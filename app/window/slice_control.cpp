// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/slice_control.h"

#include <string>

#include "core/types/plane_words.h"
#include "ui/common/segment_owners.h"
#include "ui/panels/slice_panel.h"
#include "ui/scene/colouring.h"
#include "ui/theme/theme.h"

namespace planewright {

namespace {

/// Between two slices that are shown.
constexpr std::chrono::milliseconds kSlicePause{120};

}  // namespace

SliceControl::SliceControl(WindowParts& parts) : QObject(&parts), parts_(parts), panel_(new SlicePanel(parts.selection))
{
    parts_.window->addBottomPanel(panel_, tr("Slice 2D"));
    due_.setSingleShot(true);
    due_.setInterval(kSlicePause);
    connect(&due_, &QTimer::timeout, this, &SliceControl::update);
    connect(&parts_, &WindowParts::mapShown, this, &SliceControl::request);
    connect(&parts_, &WindowParts::layersChanged, this, &SliceControl::request);
    connect(&parts_, &WindowParts::preferencesChanged, this, &SliceControl::request);
    connect(panel_, &SlicePanel::shown, this, &SliceControl::update);
    connect(parts_.window->actions()[QStringLiteral("actShowSlice")], &QAction::triggered, panel_, [this] {
        parts_.window->showBottomPanel(panel_->objectName());
        panel_->setFocus();
    });
}

/// A timer that runs already is left alone, so that something is shown while steps come faster than they are drawn.
void SliceControl::request()
{
    if (panel_->isVisible() && !due_.isActive())
        due_.start();
}

void SliceControl::update()
{
    due_.stop();
    if (panel_->isVisible())
        panel_->setSketch(sketch());
}

std::shared_ptr<const SliceSketch> SliceControl::sketch() const
{
    const ShownMap& map = *parts_.shown;
    if (!map.snapshot || map.slices.empty())
        return nullptr;
    auto sketch = std::make_shared<SliceSketch>();
    sketch->slice = map.slices.back();
    sketch->sensor = map.sensor;
    const int step = sketch->slice->step;
    const std::vector<ExtractedStep>& history = parts_.session.history();
    const int place = parts_.playhead.placeOf(step);
    Parameters parameters = parts_.session.parameters();
    if (place >= 0 && static_cast<std::size_t>(place) < history.size()) {
        const ExtractedStep& extracted = history[static_cast<std::size_t>(place)];
        parameters = withNoise(extracted.parameters ? *extracted.parameters : parameters, extracted.snapshot->noise);
    }
    sketch->trace = traceSlice(*sketch->slice, sketch->sensor, parameters);

    const SegmentOwners owners(map);
    const Colouring colouring(map, parts_.layers, themeOf(panel_->palette()));
    const std::size_t slice = map.snapshot->segments.find(step);
    const bool isThere = slice < owners.slices();
    const std::size_t count = isThere ? map.snapshot->segments.slice(slice).size() : 0;
    for (const TracedPiece& piece : sketch->trace.pieces) {
        const auto index = static_cast<std::size_t>(piece.segment);
        const bool isKnown = piece.segment >= 0 && index < count;
        const int plane = isKnown ? owners.planeAt(slice, index) : -1;
        const ClusterId cluster = isKnown ? owners.clusterAt(slice, index) : kNoCluster;
        const double height = isKnown ? map.snapshot->segments.slice(slice)[index].midpoint().z() : 0.0;
        sketch->colours.push_back(colouring.of(plane, cluster, step, height));
        sketch->owners.push_back(plane >= 0 ? planeLabel(map.planes[static_cast<std::size_t>(plane)].plane->id)
                                 : cluster != kNoCluster ? "C" + std::to_string(cluster)
                                                         : std::string{});
    }
    return sketch;
}

}  // namespace planewright
