// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/pipeline/apply_edits.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "core/pipeline/classify_planes.h"
#include "core/planes/refit_segments.h"

namespace planewright {

namespace {

constexpr std::array<std::string_view, 7> kWhat{"naming", "class", "hiding", "deletion", "merge", "split", "locking"};

/// An edit for people: "the merge of planes 3, 7".
std::string describe(const Edit& edit)
{
    std::string planes;
    for (const PlaneId id : edit.planes)
        planes += (planes.empty() ? "" : ", ") + std::to_string(id);
    return "the " + std::string{kWhat[static_cast<std::size_t>(edit.kind)]} +
           (edit.planes.size() == 1 ? " of plane " : " of planes ") + planes;
}

/// The planes while edits are applied to them.
class Editor {
public:
    Editor(const Snapshot& snapshot, const ScanDescription& description, const Parameters& parameters)
        : refit_{snapshot, description, parameters}
    {
        for (const auto& plane : snapshot.planes) {
            planes_.push_back({plane, {}, {}, false, false});
            nextId_ = std::max(nextId_, plane->id + 1);
        }
    }

    void apply(const Edit& edit)
    {
        std::string failed = check(edit);
        if (failed.empty())
            failed = change(edit);
        if (!failed.empty())
            problems_.push_back(describe(edit) + " is not applied: " + failed);
    }

    EditedPlanes finish() &&;

private:
    std::vector<EditedPlane>::iterator find(PlaneId id)
    {
        return std::find_if(planes_.begin(), planes_.end(),
                            [id](const EditedPlane& plane) { return plane.plane->id == id; });
    }

    std::string check(const Edit& edit);
    std::string change(const Edit& edit);
    std::string merge(const Edit& edit);
    std::string split(const Edit& edit);
    void remove(const std::vector<PlaneId>& ids)
    {
        std::erase_if(planes_, [&](const EditedPlane& plane) {
            return std::find(ids.begin(), ids.end(), plane.plane->id) != ids.end();
        });
    }

    Refit refit_;
    std::vector<EditedPlane> planes_;
    std::vector<std::string> problems_;
    PlaneId nextId_ = kFirstEditedPlane;
};

/// What keeps an edit from being applied; empty if nothing does.
std::string Editor::check(const Edit& edit)
{
    if (edit.planes.empty() || (edit.kind == Edit::Kind::Merge && edit.planes.size() < 2))
        return "it names too few planes";
    for (const PlaneId id : edit.planes) {
        const auto plane = find(id);
        if (plane == planes_.end())
            return "there is no plane " + std::to_string(id);
        if (plane->locked && edit.kind != Edit::Kind::Lock)
            return "plane " + std::to_string(id) + " is locked";
    }
    return {};
}

std::string Editor::change(const Edit& edit)
{
    switch (edit.kind) {
        case Edit::Kind::Merge:
            return merge(edit);
        case Edit::Kind::Split:
            return split(edit);
        case Edit::Kind::Delete:
            remove(edit.planes);
            return {};
        default:
            break;
    }
    for (const PlaneId id : edit.planes) {
        EditedPlane& plane = *find(id);
        if (edit.kind == Edit::Kind::Rename)
            plane.name = edit.text;
        else if (edit.kind == Edit::Kind::Classify)
            plane.className = edit.text;
        else if (edit.kind == Edit::Kind::Hide)
            plane.hidden = edit.on;
        else
            plane.locked = edit.on;
    }
    return {};
}

std::string Editor::merge(const Edit& edit)
{
    std::vector<SegmentId> segments;
    EditedPlane merged = *find(edit.planes.front());
    int bornStep = merged.plane->bornStep;
    int changedStep = merged.plane->changedStep;
    for (const PlaneId id : edit.planes) {
        const Plane& plane = *find(id)->plane;
        segments.insert(segments.end(), plane.segments.begin(), plane.segments.end());
        bornStep = std::min(bornStep, plane.bornStep);
        changedStep = std::max(changedStep, plane.changedStep);
    }
    auto plane = refitPlane(segments, refit_);
    if (!plane)
        return "the planes have no plane in common";
    plane->id = nextId_++;
    plane->bornStep = bornStep;
    plane->changedStep = changedStep;
    plane->lineage = {Lineage::Kind::Merged, edit.planes};
    merged.plane = std::make_shared<const Plane>(std::move(*plane));
    remove(edit.planes);
    planes_.push_back(std::move(merged));
    return {};
}

std::string Editor::split(const Edit& edit)
{
    if (edit.planes.size() != 1)
        return "one plane is split at a time";
    const EditedPlane whole = *find(edit.planes.front());
    std::vector<Plane> parts = searchPlanes(whole.plane->segments, refit_);
    if (parts.size() < 2)
        return "no second plane is found in plane " + std::to_string(whole.plane->id);
    remove(edit.planes);
    for (Plane& part : parts) {
        part.id = nextId_++;
        part.bornStep = whole.plane->bornStep;
        part.changedStep = whole.plane->changedStep;
        part.lineage = {Lineage::Kind::Split, edit.planes};
        planes_.push_back({std::make_shared<const Plane>(std::move(part)), {}, {}, whole.hidden, false});
    }
    return {};
}

EditedPlanes Editor::finish() &&
{
    std::sort(planes_.begin(), planes_.end(),
              [](const EditedPlane& a, const EditedPlane& b) { return a.plane->id < b.plane->id; });
    std::vector<std::shared_ptr<const Plane>> plain;
    plain.reserve(planes_.size());
    for (const EditedPlane& plane : planes_)
        plain.push_back(plane.plane);
    const auto classes = classesOf(plain, refit_.snapshot.segments);
    for (std::size_t i = 0; i < planes_.size(); ++i) {
        if (planes_[i].className.empty())
            planes_[i].className = classes[i];
    }
    return {std::move(planes_), std::move(problems_)};
}

}  // namespace

EditedPlanes applyEdits(const Snapshot& snapshot, std::span<const Edit> edits, const ScanDescription& description,
                        const Parameters& parameters)
{
    Editor editor{snapshot, description, parameters};
    for (const Edit& edit : edits)
        editor.apply(edit);
    return std::move(editor).finish();
}

Snapshot withPlanes(const Snapshot& snapshot, const EditedPlanes& edited)
{
    Snapshot changed = snapshot;
    changed.planes.clear();
    for (const EditedPlane& plane : edited.planes)
        changed.planes.push_back(plane.plane);
    return changed;
}

}  // namespace planewright
