// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>

#include <QImage>
#include <QWidget>

#include "core/types/error.h"
#include "ui/opengl/offscreen_context.h"
#include "ui/scene/map_scene.h"

namespace planewright {

/// How much of the scene a picture shows.
enum class Detail {
    Moving,  ///< a part of the points, while something moves
    Full,
};

/// Shows a scene inside a widget: by OpenGL, or as an image where there is none.
class Presenter {
public:
    virtual ~Presenter() = default;
    Presenter(const Presenter&) = delete;
    Presenter& operator=(const Presenter&) = delete;

    virtual QWidget& widget() = 0;

    /// The scene or the camera has changed: a picture with this detail is due.
    virtual void requestPicture(Detail detail) = 0;

    /// How many points are drawn while something moves, and whether edges are smooth where that is cheap.
    virtual void setPointBudget(std::size_t points) = 0;
    virtual void setSmoothEdges(bool smooth) = 0;

    /// A picture of the scene in full detail at this size [pixels], apart from what the widget shows.
    virtual QImage picture(QSize size, double pixelRatio) = 0;

    /// What draws, for bug reports: OpenGL's renderer and version.
    virtual QString rendererName() const = 0;

protected:
    Presenter() = default;
};

/// Points that are drawn while something moves.
inline constexpr std::size_t kDefaultPointBudget = 50'000;

/// What a presenter is made with.
struct PresenterSettings {
    OffscreenRenderer offscreen = OffscreenRenderer::Auto;
    bool image = false;  ///< without a display: an image drawn by the offscreen renderer
    std::size_t pointBudget = kDefaultPointBudget;
};

/// Makes a presenter. Errors: NoRenderer.
Result<std::unique_ptr<Presenter>> makePresenter(MapScene& scene, const PresenterSettings& settings, QWidget* parent);

}  // namespace planewright
