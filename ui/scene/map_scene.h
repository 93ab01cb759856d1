// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>
#include <vtkPlane.h>
#include <vtkRenderer.h>

#include <Eigen/Geometry>

#include "ui/common/beam_run.h"
#include "ui/common/segment_owners.h"
#include "ui/scene/camera_motion.h"
#include "ui/scene/marks_layer.h"
#include "ui/scene/plane_layer.h"
#include "ui/scene/point_layer.h"
#include "ui/scene/segment_layer.h"
#include "ui/scene/trajectory_layer.h"

namespace planewright {

/// What is marked in the scene.
struct SceneSelection {
    std::set<PlaneId> planes;
    std::set<SegmentId> segments;
    std::set<BeamRun> pieces = {};
    PlaneId hovered = kNoPlane;

    friend bool operator==(const SceneSelection&, const SceneSelection&) = default;
};

/// A text at a place in space.
struct SceneLabel {
    Eigen::Vector3d place;
    std::string text;
    Rgb colour;
    bool selected = false;
    double seen = 0.0;  ///< how large the plane appears from the camera [sr], in parallel views [m²]
};

/// A scan, or a map of several stops, as a picture: layers of actors in one renderer of VTK, which whoever shows it
/// puts into a window.
class MapScene {
public:
    MapScene();

    vtkRenderer* renderer() { return renderer_; }

    /// Shows a map; actors of what did not change stay.
    void setMap(std::shared_ptr<const ShownMap> map);
    void setLayers(const LayerSettings& settings);
    void setTheme(Theme theme);
    void setSelection(const SceneSelection& selection);
    void setMeasurements(const std::vector<MeasuredLine>& lines);
    /// Shows only what is in a box; none shows all.
    void setClipBox(const std::optional<Eigen::AlignedBox3d>& box);
    /// Pixels of the picture for each pixel of the desktop: widths and sizes grow with it.
    void setPixelRatio(double ratio);
    void setCamera(const ViewCamera& camera);

    const ShownMap& map() const { return *map_; }
    const SegmentOwners& owners() const { return owners_; }
    const LayerSettings& layers() const { return layers_; }
    Theme theme() const { return theme_; }
    const SceneSelection& selection() const { return selection_; }
    const ViewCamera& camera() const { return camera_; }
    const std::optional<Eigen::AlignedBox3d>& clipBox() const { return clipBox_; }
    /// Of all that was scanned and of all planes [m]; empty before the first slice.
    const Eigen::AlignedBox3d& bounds() const { return bounds_; }
    /// What a picture of the scan shows: all planes that are not hidden and 98 % of the segments' ends along each axis
    /// [m]. Single far echoes, as through a window, do not make the room small. Empty before the first slice.
    const Eigen::AlignedBox3d& framing() const { return framing_; }

    /// Of what is selected [m]; empty without it.
    Eigen::AlignedBox3d selectedBounds() const;

    /// Brings the actors up to date; without this the renderer shows what it showed before.
    void update();

    /// Draws about so many points while the camera moves; 0 draws all.
    void setPointBudget(std::size_t budget) { points_.setBudget(budget); }
    PointLayer& points() { return points_; }

    /// Names of planes at their centres, those that appear largest first; of a map of several stops those selected,
    /// and the numbers of the stops.
    std::vector<SceneLabel> labels() const;
    std::vector<LegendEntry> legend(std::size_t most) const;

private:
    void clip();

    vtkNew<vtkRenderer> renderer_;
    std::shared_ptr<const ShownMap> map_ = std::make_shared<ShownMap>();
    SegmentOwners owners_;
    LayerSettings layers_;
    Theme theme_ = Theme::Light;
    SceneSelection selection_;
    std::vector<MeasuredLine> measured_;
    std::optional<Eigen::AlignedBox3d> clipBox_;
    double pixelRatio_ = 1.0;
    ViewCamera camera_;
    Eigen::AlignedBox3d bounds_;
    Eigen::AlignedBox3d framing_;
    std::uint64_t coloursVersion_ = 1;
    bool changed_ = true;
    PointLayer points_;
    SegmentLayer segments_;
    MarksLayer marks_;
    TrajectoryLayer trajectory_;
    PlaneLayer planes_;
};

}  // namespace planewright
