// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <memory>
#include <vector>
#include <vtkRenderer.h>

#include "ui/common/segment_owners.h"
#include "ui/scene/colouring.h"
#include "ui/scene/scene_geometry.h"

namespace planewright {

/// Scan points, in chunks of slices: only chunks in which something changed are made anew.
class PointLayer {
public:
    explicit PointLayer(vtkRenderer* renderer) : renderer_(renderer) {}

    /// Shows the points of the map's slices. `settingsVersion` changes whenever colours change for another reason than
    /// that points change owner.
    void update(const ShownMap& map, const SegmentOwners& owners, const Colouring& colouring,
                const LayerSettings& settings, std::uint64_t settingsVersion);

    /// Draws a part of the points while the camera moves: about this many; 0 draws all.
    void setBudget(std::size_t budget);

    /// Actors of all points, each of which can be drawn by itself.
    std::vector<vtkActor*> parts() const;

    std::size_t points() const;

    /// The chunks that the last update made anew, for whoever watches the cost.
    int rebuiltChunks() const { return rebuilt_; }

private:
    struct Chunk;

    void rebuild(Chunk& chunk, std::size_t number, const ShownMap& map, const SegmentOwners& owners,
                 const Colouring& colouring);
    void makeThinned();
    void show();

    vtkRenderer* renderer_;
    std::vector<std::shared_ptr<Chunk>> chunks_;
    vtkSmartPointer<vtkActor> thinned_;
    std::size_t budget_ = 0;
    bool thinnedIsOld_ = true;
    LayerStyle style_;
    int rebuilt_ = 0;
};

}  // namespace planewright
