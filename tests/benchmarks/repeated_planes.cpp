// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/benchmarks/repeated_planes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

#include "core/evaluation/compare_labels.h"
#include "core/formats/labels.h"
#include "core/geometry/tangents.h"
#include "core/pipeline/plane_extractor.h"

namespace planewright {

namespace {

std::shared_ptr<const Plane> planeOf(int id, const Snapshot& found)
{
    return *std::find_if(found.planes.begin(), found.planes.end(), [id](const auto& plane) { return plane->id == id; });
}

std::vector<ComparedPlane> comparedOf(const Snapshot& found)
{
    std::vector<ComparedPlane> planes;
    for (const auto& plane : found.planes)
        planes.push_back({plane->id, plane->normal, plane->distance});
    return planes;
}

/// The labels of those slices of an extraction that are next to a slice of another one, one for each of these.
LabelGrid labelsNextTo(const Extracted& other, const Extracted& extracted)
{
    const Labels labels = labelsOf(*extracted.found, extracted.recording);
    const std::vector<ScanSlice>& slices = extracted.recording.slices;
    LabelGrid grid;
    for (const ScanSlice& wanted : other.recording.slices) {
        const auto after = std::lower_bound(slices.begin(), slices.end(), wanted.step,
                                            [](const ScanSlice& slice, int step) { return slice.step < step; });
        const auto nearest = after == slices.end() ? slices.end() - 1 : after;
        grid.push_back(labels[static_cast<std::size_t>(nearest - slices.begin())]);
    }
    return grid;
}

}  // namespace

double RepeatedPlane::angleSigma() const
{
    const double middle = 0.5 * (covariance(0, 0) + covariance(1, 1));
    return std::sqrt(middle + std::hypot(0.5 * (covariance(0, 0) - covariance(1, 1)), covariance(0, 1)));
}

Extracted extractFrom(const Recording& recording, Slices slices, const Parameters& parameters)
{
    Extracted extracted;
    extracted.recording.description = recording.description;
    PlaneExtractor extractor(sensorOf(recording.description), parameters);
    for (std::size_t i = 0; i < recording.slices.size(); ++i) {
        if (slices != Slices::All && (i % 2 == 0) != (slices == Slices::Even))
            continue;
        extractor.advance(recording.slices[i]);
        extracted.recording.slices.push_back(recording.slices[i]);
    }
    extracted.found = extractor.finish();
    return extracted;
}

std::optional<RepeatedPlane> movedBetween(std::shared_ptr<const Plane> first, std::shared_ptr<const Plane> second,
                                          Share share)
{
    RepeatedPlane repeated;
    const double side = first->normal.dot(second->normal) < 0.0 ? -1.0 : 1.0;
    repeated.moved.head<2>() = first->tangents.transpose() * (side * second->normal - first->normal);
    repeated.moved[2] = side * second->distance - first->distance;
    // A turn of both normals to the other side turns all three unknowns: covariances stay what they are.
    const Eigen::Matrix3d toFirst = betweenTangents(second->tangents, first->tangents);
    const Eigen::Matrix3d seconds = toFirst * second->covariance * toFirst.transpose();
    repeated.covariance = share == Share::Nothing ? Eigen::Matrix3d(first->covariance + seconds)
                                                  : Eigen::Matrix3d(first->covariance - seconds);
    const Eigen::LLT<Eigen::Matrix3d> factor(repeated.covariance);
    if (factor.info() != Eigen::Success)
        return std::nullopt;
    repeated.squared = repeated.moved.dot(factor.solve(repeated.moved));
    repeated.first = std::move(first);
    repeated.second = std::move(second);
    return repeated;
}

Repetition repeatedPlanes(const Extracted& first, const Extracted& second, Share share, double overlap, int minPoints)
{
    const LabelGrid firsts = labelsOf(*first.found, first.recording);
    const LabelGrid seconds = labelsNextTo(first, second);
    const auto compared =
        compareLabels(firsts, seconds, comparedOf(*first.found), comparedOf(*second.found), {overlap, 0});
    Repetition repetition;
    if (!compared)
        return repetition;
    for (const RegionMatch& match : compared->correct) {
        if (match.b.size() > 1)
            continue;  // of coplanar pieces none is the same plane
        auto plane = planeOf(match.a, *first.found);
        if (plane->points < minPoints)
            continue;
        if (auto moved = movedBetween(std::move(plane), planeOf(match.b.front(), *second.found), share))
            repetition.planes.push_back(std::move(*moved));
        else
            ++repetition.withoutCovariance;
    }
    return repetition;
}

}  // namespace planewright
