// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <set>
#include <vector>
#include <vtkRenderer.h>

#include "ui/common/segment_owners.h"
#include "ui/scene/colouring.h"
#include "ui/scene/scene_geometry.h"

namespace planewright {

/// Line segments: those of planes, those of clusters, those left over (dashed), those new in this step (thick) and
/// those selected; and on request the uncertainty of a selection's end points (Fig. 8b).
class SegmentLayer {
public:
    explicit SegmentLayer(vtkRenderer* renderer);

    void update(const ShownMap& map, const SegmentOwners& owners, const Colouring& colouring,
                const LayerSettings& settings, Theme theme, const std::set<SegmentId>& selected, double pixelRatio);

private:
    vtkSmartPointer<vtkActor> fitted_;
    vtkSmartPointer<vtkActor> clustered_;
    vtkSmartPointer<vtkActor> unfitted_;
    vtkSmartPointer<vtkActor> fresh_;
    vtkSmartPointer<vtkActor> selected_;
    vtkSmartPointer<vtkActor> selectedInner_;
    vtkSmartPointer<vtkActor> ellipsoids_;
};

}  // namespace planewright
