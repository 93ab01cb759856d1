// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/benchmarks/scoring.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tests/benchmarks/plane_information.h"

namespace planewright {

MatchCounts& MatchCounts::operator+=(const MatchCounts& other)
{
    correct += other.correct;
    groups += other.groups;
    regions += other.regions;
    return *this;
}

MatchCounts countsOf(const LabelComparison& compared)
{
    return {static_cast<double>(compared.correct.size()), static_cast<double>(compared.groups),
            static_cast<double>(compared.regions)};
}

std::vector<Eigen::Matrix3d> trueInformation(const Scene& scene, const SimulatedScan& scan,
                                             const SimulationNoise& noise)
{
    const SensorModel sensor = sensorOf(scan.recording.description);
    std::vector<PlaneInformation> information;
    for (const TruePlane& plane : scene.planes)
        information.emplace_back(KnownPlane{plane.normal, plane.distance}, noise, sensor);
    for (std::size_t k = 0; k < scan.recording.slices.size(); ++k) {
        const ScanSlice& slice = scan.recording.slices[k];
        for (std::size_t i = 0; i < slice.ranges.size(); ++i) {
            const int label = scan.labels[k][i];
            if (label >= 0)
                information[static_cast<std::size_t>(label)].add(slice.ranges[i], slice.bearing(i), slice.tiltAt(i));
        }
        for (PlaneInformation& plane : information)
            plane.endSlice();
    }
    std::vector<Eigen::Matrix3d> matrices;
    for (const PlaneInformation& plane : information)
        matrices.push_back(plane.information());
    return matrices;
}

Judge::Judge(const Scene& scene, const SimulatedScan& scan, const SimulationNoise& noise, std::int64_t minReturns)
    : scene_(scene), scan_(scan), minReturns_(minReturns), information_(trueInformation(scene, scan, noise))
{
    for (const TruePlane& plane : scene.planes)
        truth_.push_back({plane.id, plane.normal, plane.distance});
}

Score Judge::judge(const LabelGrid& labels, const std::vector<ComparedPlane>& planes) const
{
    const LabelComparison at50 = *compareLabels(labels, scan_.labels, planes, truth_, {0.5, minReturns_});
    const LabelComparison at80 = *compareLabels(labels, scan_.labels, planes, truth_, {0.8, minReturns_});
    Score score{countsOf(at50), countsOf(at80), {}};
    for (const RegionMatch& match : at50.correct) {
        if (match.b.size() > 1)
            continue;  // coplanar ones may differ by what the noise cannot tell
        const TruePlane& truth = scene_.planes[static_cast<std::size_t>(match.b.front())];
        const auto plane =
            std::find_if(planes.begin(), planes.end(), [&](const ComparedPlane& p) { return p.id == match.a; });
        const PlaneDifference difference = differenceOf(*plane, truth_[static_cast<std::size_t>(truth.id)]);
        const Eigen::Vector3d error = errorOf({plane->normal, plane->distance}, {truth.normal, truth.distance});
        score.found.push_back({truth.id, difference.angle, difference.distance,
                               error.dot(information_[static_cast<std::size_t>(truth.id)] * error)});
    }
    std::sort(score.found.begin(), score.found.end(),
              [](const FoundPlane& a, const FoundPlane& b) { return a.truth < b.truth; });
    return score;
}

double median(std::vector<double> values)
{
    if (values.empty())
        return 0.0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double errorOverBound(std::vector<double> squared)
{
    return std::sqrt(median(std::move(squared)) / kMedianChi3);
}

double errorOverBound(const std::vector<FoundPlane>& found)
{
    std::vector<double> squared;
    for (const FoundPlane& plane : found)
        squared.push_back(plane.squared);
    return errorOverBound(std::move(squared));
}

}  // namespace planewright
