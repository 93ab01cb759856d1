// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "core/evaluation/compare_labels.h"
#include "core/formats/labels.h"
#include "core/pipeline/complete_labels.h"
#include "core/pipeline/plane_extractor.h"
#include "core/simulation/nodding_scanner.h"

namespace planewright {

/// A simulated scan and the room it was made in.
struct SimulatedRoom {
    Scene scene;
    SimulatedScan scan;
};

inline SimulatedRoom scanOf(Scene scene, std::string_view noise, std::uint64_t seed,
                            std::string_view settings = "table8")
{
    SimulatedRoom room{std::move(scene), {}};
    room.scan = simulate(room.scene, *acquisitionSettings(settings), *simulationNoise(noise), seed);
    return room;
}

inline SimulatedRoom scanOf(std::string_view scene, std::string_view noise, std::uint64_t seed,
                            std::string_view settings = "table8")
{
    return scanOf(*makeScene(scene, seed), noise, seed, settings);
}

/// Feeds all slices and finishes.
inline std::shared_ptr<const Snapshot> extracted(const Recording& recording, const Parameters& parameters = {},
                                                 const ExtractionOptions& options = {})
{
    PlaneExtractor extractor(sensorOf(recording.description), parameters, options);
    for (const ScanSlice& slice : recording.slices)
        extractor.step(slice);
    return extractor.finish();
}

/// Compares what was found with the truth, as `planewright-cli compare --labels` does.
inline LabelComparison comparedWithTruth(const SimulatedRoom& room, const Snapshot& found, std::int64_t minReturns,
                                         const Parameters& parameters = {})
{
    Labels labels = labelsOf(found, room.scan.recording);
    completeLabels(labels, found, room.scan.recording, parameters);
    std::vector<ComparedPlane> planes;
    for (const auto& plane : found.planes)
        planes.push_back({plane->id, plane->normal, plane->distance});
    std::vector<ComparedPlane> truth;
    for (const TruePlane& plane : room.scene.planes)
        truth.push_back({plane.id, plane.normal, plane.distance});
    return *compareLabels(labels, room.scan.labels, planes, truth, {0.5, minReturns});
}

/// What was found in several rooms.
struct RoomTotals {
    std::size_t truePlanes = 0;
    std::size_t foundPlanes = 0;
    std::size_t correct = 0;

    RoomTotals& operator+=(const LabelComparison& room)
    {
        truePlanes += room.groups;
        foundPlanes += room.regions;
        correct += room.correct.size();
        return *this;
    }
};

}  // namespace planewright
