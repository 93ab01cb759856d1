// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/view3d/presenter.h"

#include "ui/view3d/gl_presenter.h"
#include "ui/view3d/image_presenter.h"

namespace planewright {

Result<std::unique_ptr<Presenter>> makePresenter(MapScene& scene, const PresenterSettings& settings, QWidget* parent)
{
    if (!settings.image)
        return std::make_unique<GlPresenter>(scene, settings.pointBudget, parent);
    auto window = OffscreenWindow::open(settings.offscreen, 16, 16);
    if (!window)
        return tl::unexpected{window.error()};
    return std::make_unique<ImagePresenter>(scene, *window, settings.pointBudget, parent);
}

}  // namespace planewright
