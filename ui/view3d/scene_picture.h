// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QImage>

#include "ui/opengl/any_gl_window.h"
#include "ui/scene/map_scene.h"

namespace planewright {

/// Draws a scene into a window of VTK in one go.
void drawScene(MapScene& scene, AnyGlWindow& window);

/// What a window of VTK shows.
QImage pictureOf(AnyGlWindow& window);

/// Draws a scene in full detail, at rest, a part of the points at a time, so that nothing else waits long.
///
/// The window keeps its colours and depths between the parts; its picture is whole only after the last.
class PartwiseDrawing {
public:
    PartwiseDrawing(MapScene& scene, AnyGlWindow& window) : scene_(&scene), window_(&window) {}

    /// Begins anew, with so many points a part.
    void begin(std::size_t pointsOfPart);
    /// Draws the next part. True once the picture is whole.
    bool drawNext();
    /// Forgets a drawing that is not whole.
    void stop();
    bool isRunning() const { return running_; }
    /// The picture is whole after the next part.
    bool nextIsLast() const;

private:
    std::size_t endOfNext() const;

    MapScene* scene_;
    AnyGlWindow* window_;
    bool running_ = false;
    std::size_t next_ = 0;
    std::size_t pointsOfPart_ = 0;
};

}  // namespace planewright
