// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/view_control.h"

#include <array>
#include <cmath>

#include <QActionGroup>

#include "app/window/view_text.h"
#include "ui/models/preferences_store.h"
#include "ui/theme/theme.h"

namespace planewright {

namespace {

constexpr std::array<std::pair<const char*, Layer>, kLayers> kLayerActions{{{"actLayerPoints", Layer::Points},
                                                                            {"actLayerSegments", Layer::FittedSegments},
                                                                            {"actLayerClusters", Layer::Clusters},
                                                                            {"actLayerPlanes", Layer::Planes},
                                                                            {"actLayerUnfitted", Layer::Unfitted},
                                                                            {"actLayerUncertainty", Layer::Uncertainty},
                                                                            {"actLayerSensor", Layer::Sensor}}};

}  // namespace

ViewControl::ViewControl(WindowParts& parts, ThemeFollower& follower)
    : QObject(&parts), parts_(parts), follower_(follower)
{
    connectCameras();
    connectLayers();
    connectColours();
    connectTheme();
    connectSelection();
    applyLayers();
    applyDrawing();
    connect(&parts_, &WindowParts::preferencesChanged, this, &ViewControl::applyDrawing);
}

void ViewControl::applyDrawing()
{
    constexpr double kThousand = 1000.0;
    parts_.window->view().setPointBudget(static_cast<std::size_t>(kThousand * parts_.preferences.pointBudget));
    parts_.window->view().setSmoothEdges(parts_.preferences.antiAliasing);
}

void ViewControl::connectCameras()
{
    WindowActions& actions = parts_.window->actions();
    View3d& view = parts_.window->view();
    constexpr std::array<std::pair<const char*, NamedView>, 5> kViews{{{"actViewTop", NamedView::Top},
                                                                       {"actViewFront", NamedView::Front},
                                                                       {"actViewSide", NamedView::Side},
                                                                       {"actViewIso", NamedView::Iso},
                                                                       {"actViewSensor", NamedView::Sensor}}};
    for (const auto& [name, named] : kViews)
        connect(actions[QLatin1String(name)], &QAction::triggered, this,
                [this, named = named] { parts_.window->shownView().showNamed(named); });
    connect(actions[QStringLiteral("actViewFit")], &QAction::triggered, this,
            [this] { parts_.window->shownView().fitAll(); });
    connect(actions[QStringLiteral("actViewFitSelection")], &QAction::triggered, this,
            [this] { parts_.window->shownView().fitSelection(); });
    connect(actions[QStringLiteral("actParallel")], &QAction::toggled, this,
            [this](bool on) { parts_.window->shownView().setParallel(on); });
    connect(&view, &View3d::cameraChanged, this, [this, &actions] {
        actions[QStringLiteral("actParallel")]->setChecked(parts_.window->view().camera().parallel);
    });
    connect(actions[QStringLiteral("actWalkMode")], &QAction::toggled, &view, &View3d::setWalkMode);
    for (int i = 1; i <= 9; ++i) {
        const QString key = QStringLiteral("views/%1").arg(i);
        const auto* store = parts_.window->findChild<QAction*>(QStringLiteral("actStoreView%1").arg(i));
        const auto* recall = parts_.window->findChild<QAction*>(QStringLiteral("actRecallView%1").arg(i));
        connect(store, &QAction::triggered, this, [this, key, i] {
            parts_.settings.setValue(key, textOf(parts_.window->view().camera()));
            parts_.say(tr("View %1 is saved.").arg(i));
        });
        connect(recall, &QAction::triggered, this, [this, key, i] {
            if (const auto camera = cameraOf(parts_.settings.value(key).toString()))
                parts_.window->view().setCamera(*camera);
            else
                parts_.say(tr("No view was saved as %1 yet: Ctrl+%1 saves one.").arg(i));
        });
    }
    connect(&view, &View3d::pointerMoved, this, [this](const std::optional<Eigen::Vector3d>& place) {
        parts_.window->setStatus(QStringLiteral("stCoord"), place ? QStringLiteral("X %1 Y %2 Z %3 m")
                                                                        .arg(place->x(), 0, 'f', 3)
                                                                        .arg(place->y(), 0, 'f', 3)
                                                                        .arg(place->z(), 0, 'f', 3)
                                                                  : QString());
    });
}

void ViewControl::connectLayers()
{
    for (const auto& [name, layer] : kLayerActions) {
        connect(parts_.window->actions()[QLatin1String(name)], &QAction::toggled, this, [this, layer = layer](bool on) {
            if (parts_.layers[layer].visible == on)
                return;
            parts_.layers[layer].visible = on;
            applyLayers();
        });
    }
    connect(parts_.layersPanel, &LayersPanel::settingsChanged, this, &ViewControl::setLayers);
    connect(parts_.planesPanel, &PlanesPanel::parameterRequested, this,
            [this](const QString& key) { parts_.showParameter(key.toStdString()); });
    connect(parts_.planesPanel, &PlanesPanel::showUnfittedRequested, this, [this] {
        parts_.layers[Layer::Unfitted].visible = true;
        applyLayers();
        parts_.segmentsPanel->showUnfittedOnly(true);
        parts_.window->showBottomPanel(QStringLiteral("segmentsPanel"));
    });
}

void ViewControl::connectColours()
{
    QMenu* menu = parts_.window->actions().submenu(QStringLiteral("colourBy"));
    auto* group = new QActionGroup(this);
    for (std::size_t i = 0; i < kColourings; ++i) {
        QAction* action = menu->addAction(QString::fromUtf8(kColourByNames[i].data()));
        action->setObjectName(QStringLiteral("actColourBy%1").arg(i));
        action->setCheckable(true);
        group->addAction(action);
        connect(action, &QAction::triggered, this, [this, i] {
            parts_.layers.colourBy = static_cast<ColourBy>(i);
            applyLayers();
        });
    }
    connect(parts_.window->actions()[QStringLiteral("actNextColourBy")], &QAction::triggered, this, [this] {
        parts_.layers.colourBy =
            static_cast<ColourBy>((static_cast<std::size_t>(parts_.layers.colourBy) + 1) % kColourings);
        applyLayers();
    });
}

void ViewControl::setLayers(const LayerSettings& settings)
{
    const PlanePalette palette = parts_.layers.palette;
    parts_.layers = settings;
    parts_.layers.palette = palette;
    applyLayers();
}

void ViewControl::applyLayers()
{
    for (const auto& [name, layer] : kLayerActions)
        parts_.window->actions()[QLatin1String(name)]->setChecked(parts_.layers[layer].visible);
    const QList<QAction*> colourings = parts_.window->actions().submenu(QStringLiteral("colourBy"))->actions();
    colourings[static_cast<qsizetype>(parts_.layers.colourBy)]->setChecked(true);
    parts_.layersPanel->setSettings(parts_.layers);
    parts_.window->view().setLayers(parts_.layers);
    emit parts_.layersChanged();
}

void ViewControl::connectTheme()
{
    struct Choice {
        const char* text;
        ThemeChoice choice;
    };
    constexpr std::array<Choice, 3> kChoices{
        {{"As the &system", ThemeChoice::System}, {"&Light", ThemeChoice::Light}, {"&Dark", ThemeChoice::Dark}}};
    QMenu* menu = parts_.window->actions().submenu(QStringLiteral("theme"));
    auto* group = new QActionGroup(this);
    for (const Choice& choice : kChoices) {
        QAction* action = menu->addAction(tr(choice.text));
        action->setObjectName(QStringLiteral("actTheme%1").arg(static_cast<int>(choice.choice)));
        action->setCheckable(true);
        action->setChecked(choice.choice == parts_.preferences.theme);
        group->addAction(action);
        connect(action, &QAction::triggered, this, [this, kind = choice.choice] {
            parts_.preferences.theme = kind;
            savePreferences(parts_.preferences, parts_.settings);
            emit parts_.preferencesChanged();
        });
    }
    connect(&parts_, &WindowParts::preferencesChanged, this, [this, menu] {
        menu->actions()[static_cast<qsizetype>(parts_.preferences.theme)]->setChecked(true);
        follower_.setChoice(parts_.preferences.theme);
        parts_.layers.palette = parts_.preferences.palette;
        applyLayers();
        applyTheme(follower_.theme());
    });
    connect(&follower_, &ThemeFollower::themeChanged, this, &ViewControl::applyTheme);
    follower_.setChoice(parts_.preferences.theme);
    applyTheme(follower_.theme());
}

void ViewControl::applyTheme(Theme theme)
{
    planewright::applyTheme(theme);
    parts_.window->view().setTheme(theme);
    parts_.planes.setColours(parts_.preferences.palette, theme);
    parts_.planes.setLengthStyle(parts_.preferences.lengths);
    parts_.segments.setLengthStyle(parts_.preferences.lengths);
    parts_.measurements.setLengthStyle(parts_.preferences.lengths);
}

void ViewControl::connectSelection()
{
    MapSelection& selection = parts_.selection;
    View3d& view = parts_.window->view();
    connect(&view, &View3d::clicked, this, &ViewControl::select);
    connect(&view, &View3d::hovered, &selection, &MapSelection::hover);
    connect(&selection, &MapSelection::changed, this, [&selection, &view] {
        view.setSelection({selection.planes(), selection.segments(), selection.pieces(), selection.hovered()});
    });
    connect(parts_.planesPanel, &PlanesPanel::zoomRequested, this, [this, &view](PlaneId plane) {
        parts_.selection.select({plane});
        view.fitSelection();
    });
    WindowActions& actions = parts_.window->actions();
    connect(actions[QStringLiteral("actSelectAll")], &QAction::triggered, this,
            [this] { parts_.selection.selectAll(*parts_.shown); });
    connect(actions[QStringLiteral("actSelectInvert")], &QAction::triggered, this,
            [this] { parts_.selection.invert(*parts_.shown); });
    connect(actions[QStringLiteral("actSelectNone")], &QAction::triggered, &selection, &MapSelection::clear);
    connect(actions[QStringLiteral("actFindPlane")], &QAction::triggered, parts_.planesPanel,
            &PlanesPanel::focusFilter);
}

void ViewControl::select(const std::optional<Picked>& picked, bool add)
{
    MapSelection& selection = parts_.selection;
    if (!picked) {
        if (!add)
            selection.clear();
    } else if (picked->plane != kNoPlane) {
        if (add)
            selection.togglePlane(picked->plane);
        else
            selection.select({picked->plane});
    } else if (picked->segment) {
        if (add)
            selection.toggleSegment(*picked->segment);
        else
            selection.select({}, {*picked->segment});
    }
}

}  // namespace planewright
