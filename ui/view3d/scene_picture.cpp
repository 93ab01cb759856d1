// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/view3d/scene_picture.h"

#include <algorithm>
#include <cstring>
#include <vector>
#include <vtkActorCollection.h>
#include <vtkMapper.h>
#include <vtkUnsignedCharArray.h>

namespace planewright {

void drawScene(MapScene& scene, AnyGlWindow& window)
{
    scene.update();
    window.Render();
}

QImage pictureOf(AnyGlWindow& window)
{
    const int* size = window.GetSize();
    const int width = size[0];
    const int height = size[1];
    vtkNew<vtkUnsignedCharArray> pixels;
    window.GetPixelData(0, 0, width - 1, height - 1, 1, pixels.Get(), 0);
    QImage image(width, height, QImage::Format_RGB888);
    const auto rowSize = static_cast<std::size_t>(3 * width);
    for (int row = 0; row < height; ++row)
        std::memcpy(image.scanLine(height - 1 - row), pixels->GetPointer(static_cast<vtkIdType>(row) * 3 * width),
                    rowSize);
    return image;
}

void PartwiseDrawing::begin(std::size_t pointsOfPart)
{
    stop();
    scene_->update();
    running_ = true;
    next_ = 0;
    pointsOfPart_ = pointsOfPart;
}

void PartwiseDrawing::stop()
{
    running_ = false;
    scene_->renderer()->PreserveColorBufferOff();
    scene_->renderer()->PreserveDepthBufferOff();
}

std::size_t PartwiseDrawing::endOfNext() const
{
    const std::vector<vtkActor*> points = scene_->points().parts();
    std::size_t count = 0;
    std::size_t end = next_;
    while (end < points.size() && (end == next_ || count < pointsOfPart_)) {
        count += static_cast<std::size_t>(points[end]->GetMapper()->GetInput()->GetNumberOfPoints());
        ++end;
    }
    return end;
}

bool PartwiseDrawing::nextIsLast() const
{
    return endOfNext() == scene_->points().parts().size();
}

/// Points come first, part by part, and all else with the last of them: what is translucent must see what is behind it.
bool PartwiseDrawing::drawNext()
{
    const std::vector<vtkActor*> points = scene_->points().parts();
    const std::size_t end = endOfNext();
    const bool last = end == points.size();

    vtkRenderer* renderer = scene_->renderer();
    std::vector<std::pair<vtkActor*, int>> before;
    vtkActorCollection* actors = renderer->GetActors();
    actors->InitTraversal();
    while (vtkActor* actor = actors->GetNextActor()) {
        before.emplace_back(actor, actor->GetVisibility());
        const auto place = std::find(points.begin(), points.end(), actor) - points.begin();
        const bool isPoints = place < static_cast<std::ptrdiff_t>(points.size());
        const bool due =
            isPoints ? static_cast<std::size_t>(place) >= next_ && static_cast<std::size_t>(place) < end : last;
        if (!due)
            actor->SetVisibility(false);
    }
    renderer->SetPreserveColorBuffer(next_ > 0);
    renderer->SetPreserveDepthBuffer(next_ > 0);
    window_->Render();
    for (const auto& [actor, visible] : before)
        actor->SetVisibility(visible);
    next_ = end;
    if (last)
        stop();
    return last;
}

}  // namespace planewright
