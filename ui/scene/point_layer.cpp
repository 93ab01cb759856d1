// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/scene/point_layer.h"

#include <algorithm>
#include <cmath>
#include <vtkIdTypeArray.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

namespace planewright {

namespace {

constexpr std::size_t kSlicesOfChunk = 16;

/// The point cloud of an actor: coordinates and colours as they are.
void givePoints(vtkActor* actor, vtkFloatArray* coordinates, vtkUnsignedCharArray* colours)
{
    const vtkIdType count = coordinates->GetNumberOfTuples();
    vtkNew<vtkIdTypeArray> ids;
    ids->SetNumberOfValues(count);
    for (vtkIdType i = 0; i < count; ++i)
        ids->SetValue(i, i);
    vtkNew<vtkIdTypeArray> offsets;  // one cell of all points
    offsets->SetNumberOfValues(2);
    offsets->SetValue(0, 0);
    offsets->SetValue(1, count);
    vtkNew<vtkCellArray> verts;
    verts->SetData(offsets, ids);
    vtkNew<vtkPoints> points;
    points->SetData(coordinates);
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->GetPointData()->SetScalars(colours);
    if (count > 0)
        data->SetVerts(verts);
    static_cast<vtkPolyDataMapper*>(actor->GetMapper())->SetInputData(data);
}

}  // namespace

struct PointLayer::Chunk {
    std::vector<std::shared_ptr<const ScanSlice>> slices;
    std::vector<std::vector<int>> owners;  ///< of the segments, as its colours were made of
    std::uint64_t settingsVersion = 0;
    vtkNew<vtkFloatArray> coordinates;
    vtkNew<vtkUnsignedCharArray> colours;
    vtkSmartPointer<vtkActor> actor = makeActor();
};

void PointLayer::rebuild(Chunk& chunk, std::size_t number, const ShownMap& map, const SegmentOwners& owners,
                         const Colouring& colouring)
{
    chunk.coordinates->Initialize();
    chunk.coordinates->SetNumberOfComponents(3);
    chunk.colours->Initialize();
    chunk.colours->SetNumberOfComponents(3);
    for (std::size_t i = 0; i < chunk.slices.size(); ++i) {
        const ScanSlice& slice = *chunk.slices[i];
        const std::size_t place = number * kSlicesOfChunk + i;
        const Segments* segments = place < owners.slices() ? &map.snapshot->segments.slice(place) : nullptr;
        BeamDirection direction{0.0, 1.0, std::sin(slice.tilt), std::cos(slice.tilt)};
        std::size_t next = 0;
        for (std::size_t beam = 0; beam < slice.ranges.size(); ++beam) {
            const double range = slice.ranges[beam];
            if (!map.sensor.hasEcho(range))
                continue;
            while (segments != nullptr && next < segments->size() &&
                   (*segments)[next].lastBeam < static_cast<int>(beam))
                ++next;
            const bool inSegment =
                segments != nullptr && next < segments->size() && (*segments)[next].firstBeam <= static_cast<int>(beam);
            const int owner = inSegment ? owners.planeAt(place, next) : -1;
            if (owner >= 0 && map.planes[static_cast<std::size_t>(owner)].hidden)
                continue;
            direction.sinBearing = std::sin(slice.bearing(beam));
            direction.cosBearing = std::cos(slice.bearing(beam));
            if (slice.tiltEnd) {
                direction.sinTilt = std::sin(slice.tiltAt(beam));
                direction.cosTilt = std::cos(slice.tiltAt(beam));
            }
            const Eigen::Vector3d point = toCartesian(range, direction, map.sensor);
            const Rgb colour =
                colouring.of(owner, inSegment ? owners.clusterAt(place, next) : kNoCluster, slice.step, point.z());
            chunk.coordinates->InsertNextTuple3(point.x(), point.y(), point.z());
            chunk.colours->InsertNextTuple3(colour.red, colour.green, colour.blue);
        }
    }
    givePoints(chunk.actor, chunk.coordinates, chunk.colours);
}

void PointLayer::update(const ShownMap& map, const SegmentOwners& owners, const Colouring& colouring,
                        const LayerSettings& settings, std::uint64_t settingsVersion)
{
    style_ = settings[Layer::Points];
    rebuilt_ = 0;
    const std::size_t needed = (map.slices.size() + kSlicesOfChunk - 1) / kSlicesOfChunk;
    while (chunks_.size() > needed) {
        renderer_->RemoveActor(chunks_.back()->actor);
        chunks_.pop_back();
        thinnedIsOld_ = true;
    }
    while (chunks_.size() < needed) {
        chunks_.push_back(std::make_shared<Chunk>());
        renderer_->AddActor(chunks_.back()->actor);
    }
    for (std::size_t i = 0; i < chunks_.size() && style_.visible; ++i) {
        Chunk& chunk = *chunks_[i];
        const std::size_t first = i * kSlicesOfChunk;
        const std::size_t end = std::min(first + kSlicesOfChunk, map.slices.size());
        const auto from = map.slices.begin() + static_cast<std::ptrdiff_t>(first);
        std::vector<std::shared_ptr<const ScanSlice>> slices(from, from + static_cast<std::ptrdiff_t>(end - first));
        std::vector<std::vector<int>> ownersOfSlices;
        for (std::size_t place = first; place < std::min(end, owners.slices()); ++place) {
            std::vector<int>& named = ownersOfSlices.emplace_back(owners.planesOf(place));
            for (int& owner : named) {
                if (owner >= 0) {
                    const ShownPlane& plane = map.planes[static_cast<std::size_t>(owner)];
                    owner = 2 * plane.plane->id + (plane.hidden ? 1 : 0);
                }
            }
        }
        if (chunk.settingsVersion == settingsVersion && chunk.slices == slices && chunk.owners == ownersOfSlices)
            continue;
        chunk.settingsVersion = settingsVersion;
        chunk.slices = std::move(slices);
        chunk.owners = std::move(ownersOfSlices);
        rebuild(chunk, i, map, owners, colouring);
        thinnedIsOld_ = true;
        ++rebuilt_;
    }
    show();
}

void PointLayer::setBudget(std::size_t budget)
{
    budget_ = budget;
    show();
}

std::size_t PointLayer::points() const
{
    std::size_t count = 0;
    for (const auto& chunk : chunks_)
        count += static_cast<std::size_t>(chunk->coordinates->GetNumberOfTuples());
    return count;
}

std::vector<vtkActor*> PointLayer::parts() const
{
    std::vector<vtkActor*> actors;
    for (const auto& chunk : chunks_)
        actors.push_back(chunk->actor);
    return actors;
}

/// Every n-th point of all chunks.
void PointLayer::makeThinned()
{
    const auto stride = static_cast<vtkIdType>(std::max<std::size_t>(1, (points() + budget_ - 1) / budget_));
    vtkNew<vtkFloatArray> coordinates;
    coordinates->SetNumberOfComponents(3);
    vtkNew<vtkUnsignedCharArray> colours;
    colours->SetNumberOfComponents(3);
    vtkIdType next = 0;
    for (const auto& chunk : chunks_) {
        const vtkIdType count = chunk->coordinates->GetNumberOfTuples();
        for (; next < count; next += stride) {
            coordinates->InsertNextTuple(next, chunk->coordinates);
            colours->InsertNextTuple(next, chunk->colours);
        }
        next -= count;
    }
    if (!thinned_) {
        thinned_ = makeActor();
        renderer_->AddActor(thinned_);
    }
    givePoints(thinned_, coordinates, colours);
    thinnedIsOld_ = false;
}

void PointLayer::show()
{
    const bool thin = style_.visible && budget_ > 0 && points() > budget_;
    if (thin && thinnedIsOld_)
        makeThinned();
    const auto style = [this](vtkActor* actor, bool visible) {
        actor->SetVisibility(visible);
        actor->GetProperty()->SetPointSize(static_cast<float>(style_.size));
        actor->GetProperty()->SetOpacity(style_.opacity);
    };
    for (const auto& chunk : chunks_)
        style(chunk->actor, style_.visible && !thin);
    if (thinned_)
        style(thinned_, thin);
}

}  // namespace planewright
