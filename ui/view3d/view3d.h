// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>

#include <QTimer>
#include <QWidget>

#include "ui/scene/map_scene.h"
#include "ui/scene/scene_pick.h"
#include "ui/view3d/overlay_painter.h"
#include "ui/view3d/place_handles.h"
#include "ui/view3d/presenter.h"
#include "ui/view3d/walk_keys.h"

namespace planewright {

class OverlayWidget;

/// The 3D view: shows a map, lets one look around in it and choose in it.
///
/// Left drag rotates about what is under the pointer, middle or Shift with left shifts, the wheel zooms to the pointer,
/// a double click centres. A click selects, with Ctrl adds. What is being placed has handles, which left drag moves.
class View3d : public QWidget {
    Q_OBJECT

public:
    /// Empty until present() has made something that draws.
    explicit View3d(QWidget* parent = nullptr);
    ~View3d() override;

    /// Errors: NoRenderer; the view then stays empty.
    Result<void> present(const PresenterSettings& settings);
    /// What it was made to draw with, for another view that is to look alike.
    const PresenterSettings& presented() const { return presented_; }

    void setPointBudget(std::size_t points);
    void setSmoothEdges(bool smooth);

    MapScene& scene() { return scene_; }
    Presenter* presenter() { return presenter_.get(); }

    void setMap(std::shared_ptr<const ShownMap> map);
    void setLayers(const LayerSettings& settings);
    void setTheme(Theme theme);
    void setSelection(const SceneSelection& selection);
    void setMeasurements(const std::vector<MeasuredLine>& lines);
    void setClipBox(const std::optional<Eigen::AlignedBox3d>& box);
    /// Its corner is that of keepCornerFree().
    void setOverlay(const OverlayContent& content);
    /// Nothing is written where something stands over the top right of the view [px], but in pictures of it alone.
    void keepCornerFree(QSize corner);
    const OverlayContent& overlay() const { return overlay_; }
    void setCamera(const ViewCamera& camera);
    const ViewCamera& camera() const { return scene_.camera(); }

    void showNamed(NamedView view);
    void fitAll();
    void fitSelection();
    void setParallel(bool parallel);
    /// Keys W A S D Q E walk while this is on.
    void setWalkMode(bool on);
    bool walkMode() const { return walking_; }
    /// While this is on, a click gives pointPicked() and selects nothing.
    void setMeasuring(bool on);

    /// Shows something that is being placed, with handles to move it; none shows none.
    void setPlaced(const std::optional<PlacedShape>& shape);
    const PlaceHandles& handles() const { return handles_; }

    /// The view at any size, with what is written over it [pixels].
    QImage picture(QSize size, double pixelRatio);

signals:
    void clicked(const std::optional<planewright::Picked>& picked, bool add);
    void hovered(planewright::PlaneId plane);
    void pointPicked(const planewright::Picked& picked);
    void cameraChanged();
    /// By itself the camera went to where all of the scan is in sight.
    void cameraFitted();
    void clipBoxChanged();
    /// Somebody takes hold of a handle of what is being placed, and moves it so since then.
    void handleTaken();
    void handleMoved(const planewright::Pose& motion);
    void pointerMoved(const std::optional<Eigen::Vector3d>& place);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    enum class Drag { None, Rotate, Pan, Handle };

    double aspect() const;
    Eigen::Vector2d inPicture(const QPointF& place) const;
    Ray rayAt(const QPointF& place) const;
    double tolerance(double pixels) const;
    std::optional<Picked> pickedAt(const QPointF& place) const;
    void moveCamera(const ViewCamera& camera);
    void hoverNow();
    void fitUnasked();
    void request(Detail detail);

    MapScene scene_;
    std::unique_ptr<Presenter> presenter_;
    PresenterSettings presented_;
    OverlayWidget* glass_;
    OverlayContent overlay_;
    PlaceHandles handles_;
    Drag drag_ = Drag::None;
    bool dragged_ = false;
    QPointF pressed_;
    QPointF last_;
    std::optional<Eigen::Vector3d> pivot_;
    bool walking_ = false;
    bool measuring_ = false;
    bool framed_ = false;  ///< the camera was moved by someone, or has been fitted to the scan
    QTimer restTimer_;
    QTimer hoverTimer_;
    WalkKeys walkKeys_;
};

}  // namespace planewright
