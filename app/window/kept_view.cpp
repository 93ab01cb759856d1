// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/kept_view.h"

namespace planewright {

namespace {

constexpr std::array<std::string_view, 3> kKeys{"view", "layers", "selection"};
constexpr std::chrono::seconds kRest{1};

}  // namespace

KeptView::KeptView(WindowParts& parts) : QObject(&parts), parts_(parts)
{
    rest_.setSingleShot(true);
    rest_.setInterval(kRest);
    connect(&rest_, &QTimer::timeout, this, &KeptView::save);
    const auto changed = [this] { rest_.start(); };
    connect(&parts_.window->view(), &View3d::cameraChanged, this, changed);
    connect(&parts_, &WindowParts::layersChanged, this, changed);
    connect(&parts_.selection, &MapSelection::changed, this, changed);
    connect(&parts_.session, &ScanSession::projectChanged, this, &KeptView::load);
    connect(&parts_, &WindowParts::mapShown, this, &KeptView::takeShown);
}

std::optional<QString> KeptView::stored(Row row)
{
    const auto text = parts_.session.project()->setting(parts_.session.scanInProject(), kKeys[row]);
    return text && *text ? std::optional(QString::fromStdString(**text)) : std::nullopt;
}

void KeptView::load()
{
    rest_.stop();
    loaded_ = false;
    chosen_.reset();
    if (parts_.session.project() == nullptr)
        return;
    if (const auto text = stored(kCamera)) {
        if (const auto camera = cameraOf(*text))
            parts_.window->view().setCamera(*camera);
    }
    if (const auto text = stored(kLayerStyles)) {
        if (const auto layers = layersOf(*text))
            emit layersRead(*layers);
    }
    if (const auto text = stored(kSelection))
        chosen_ = chosenOf(*text);
}

/// What is shown when the scan has been worked in, is what the file said or what follows from the scan itself.
void KeptView::takeShown()
{
    if (loaded_ || !parts_.shown->finished)
        return;
    if (chosen_) {
        parts_.selection.select(chosen_->planes, chosen_->segments);
        parts_.selection.keepWhatIsIn(*parts_.shown);
    }
    loaded_ = true;
    written_ = texts();
    rest_.stop();
}

std::array<QString, KeptView::kRows> KeptView::texts() const
{
    return {textOf(parts_.window->view().camera()), textOf(parts_.layers),
            textOf(ChosenParts{parts_.selection.planes(), parts_.selection.segments()})};
}

void KeptView::save()
{
    rest_.stop();
    PwscanProject* project = parts_.session.project();
    const SessionState state = parts_.session.state();
    if (!writes_ || !loaded_ || project == nullptr || !project->readOnlyBecause().empty() ||
        state != SessionState::Review)
        return;
    const std::array<QString, kRows> now = texts();
    for (std::size_t row = 0; row < kRows; ++row) {
        if (now[row] == written_[row])
            continue;
        const auto done = project->setSetting(parts_.session.scanInProject(), kKeys[row], now[row].toStdString());
        if (!done)
            parts_.log(LogSeverity::Warning, tr("view"), QString::fromStdString(done.error().message));
        written_[row] = now[row];
    }
}

}  // namespace planewright
