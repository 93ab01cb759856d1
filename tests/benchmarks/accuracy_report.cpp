// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

// How many planes of simulated rooms are found, how far they are from the theoretical bound, and how long it takes.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/LU>

#include "core/evaluation/compare_labels.h"
#include "core/formats/labels.h"
#include "core/params/presets.h"
#include "core/params/registry.h"
#include "core/pipeline/complete_labels.h"
#include "core/pipeline/plane_extractor.h"
#include "core/planes/end_point_cost.h"
#include "core/simulation/nodding_scanner.h"

using namespace planewright;

namespace {

using SteadyClock = std::chrono::steady_clock;

struct Counts {
    double correct = 0, groups = 0, regions = 0;
    double recall() const { return groups > 0 ? correct / groups : 1; }
    double precision() const { return regions > 0 ? correct / regions : 1; }
    double f1() const { return 2 * correct / std::max(1.0, groups + regions); }
};

struct Tally {
    Counts at50, at80;
    std::vector<double> squares;  // e'Fe of each plane found
    std::vector<double> honest;   // e'C⁻¹e
    std::vector<double> times;
};

double median(std::vector<double> v)
{
    if (v.empty())
        return 0;
    std::sort(v.begin(), v.end());
    return v[v.size() / 2];
}

/// Fisher information of all true points of a plane in (tangents of its true normal, d).
Eigen::Matrix3d informationOf(const SimulatedScan& scan, const std::vector<int>& ids, const TruePlane& plane,
                              const SimulationNoise& noise, const SensorModel& sensor)
{
    const Eigen::Matrix<double, 3, 2> tangents = tangentsOf(plane.normal);
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    for (std::size_t k = 0; k < scan.recording.slices.size(); ++k) {
        const ScanSlice& slice = scan.recording.slices[k];
        Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
        Eigen::Vector3d v = Eigen::Vector3d::Zero();
        double g2 = 0;
        for (std::size_t i = 0; i < slice.ranges.size(); ++i) {
            if (std::find(ids.begin(), ids.end(), scan.labels[k][i]) == ids.end())
                continue;
            const double theta = slice.bearing(i);
            const Eigen::Vector3d p = toCartesian(slice.ranges[i], theta, slice.tiltAt(i), sensor);
            const Eigen::Matrix3d j = cartesianJacobian(slice.ranges[i], theta, slice.tiltAt(i), sensor);
            const Eigen::Vector3d a{tangents.col(0).dot(p), tangents.col(1).dot(p), -1.0};
            const Eigen::Vector3d n = j.transpose() * plane.normal;
            const double s = noise.rangeSigma(slice.ranges[i]);
            const double variance = n[0] * n[0] * s * s + n[1] * n[1] * noise.bearing * noise.bearing;
            sum += a * a.transpose() / variance;
            v += n[2] / variance * a;
            g2 += n[2] * n[2] / variance;
        }
        const double p2 = noise.pitch * noise.pitch;
        information += sum - p2 / (1 + p2 * g2) * v * v.transpose();
    }
    return information;
}

Eigen::Vector3d errorOf(const Plane& plane, const TruePlane& truth)
{
    const double side = plane.normal.dot(truth.normal) < 0 ? -1 : 1;
    Eigen::Vector3d e;
    e.head<2>() = tangentsOf(truth.normal).transpose() * (side * plane.normal);
    e[2] = side * plane.distance - truth.distance;
    return e;
}

void add(Counts& counts, const LabelComparison& compared)
{
    counts.correct += static_cast<double>(compared.correct.size());
    counts.groups += static_cast<double>(compared.groups);
    counts.regions += static_cast<double>(compared.regions);
}

}  // namespace

int main(int argc, char** argv)
{
    std::string preset = "precise";
    std::string settingsName = "table8";
    std::string noiseName = "default";
    std::string scenes = "corridor office hall curved twelve stairs clutter";
    std::int64_t minReturns = 200;
    std::uint64_t from = 1, to = 5;
    double sigma = 0, pitch = 0;
    bool verbose = false;
    std::vector<std::string> assignments;
    for (int i = 1; i < argc; ++i) {
        const std::string_view a = argv[i];
        const auto next = [&] { return std::string(argv[++i]); };
        if (a == "--preset")
            preset = next();
        else if (a == "--settings")
            settingsName = next();
        else if (a == "--noise")
            noiseName = next();
        else if (a == "--scenes")
            scenes = next();
        else if (a == "--min-returns")
            minReturns = std::atoll(argv[++i]);
        else if (a == "--from")
            from = std::strtoull(argv[++i], nullptr, 10);
        else if (a == "--to")
            to = std::strtoull(argv[++i], nullptr, 10);
        else if (a == "--sigma")
            sigma = std::atof(argv[++i]);
        else if (a == "--pitch")
            pitch = std::atof(argv[++i]);
        else if (a == "-v")
            verbose = true;
        else if (a == "-P")
            assignments.push_back(next());
    }
    Parameters parameters;
    apply(*findPreset(methodPresets(), preset), parameters);
    for (const auto& assignment : assignments) {
        if (!setParameter(parameters, assignment)) {
            std::fprintf(stderr, "bad %s\n", assignment.c_str());
            return 2;
        }
    }
    SimulationNoise noise = *simulationNoise(noiseName);
    if (sigma > 0)
        noise.rangeConstant = sigma;
    if (pitch > 0)
        noise.pitch = degrees(pitch);

    std::printf("%-10s %7s %7s %7s %7s %7s %7s %8s\n", "scene", "rec50", "prec50", "F1@50", "F1@80", "xbound", "NEES",
                "ms");
    Tally all;
    std::vector<double> sceneTimes;
    for (std::size_t begin = 0; begin < scenes.size();) {
        const std::size_t end = std::min(scenes.find(' ', begin), scenes.size());
        const std::string name = scenes.substr(begin, end - begin);
        begin = end + 1;
        Tally tally;
        for (std::uint64_t seed = from; seed <= to; ++seed) {
            const Scene scene = *makeScene(name, seed);
            const SimulatedScan scan = simulate(scene, *acquisitionSettings(settingsName), noise, seed);
            const SensorModel sensor = sensorOf(scan.recording.description);
            std::shared_ptr<const Snapshot> found;
            std::vector<double> times;
            for (int repeat = 0; repeat < 5; ++repeat) {
                const auto start = SteadyClock::now();
                PlaneExtractor extractor(sensor, parameters);
                for (const ScanSlice& slice : scan.recording.slices)
                    extractor.advance(slice);
                found = extractor.finish();
                times.push_back(std::chrono::duration<double, std::milli>(SteadyClock::now() - start).count());
            }
            tally.times.push_back(median(times));
            std::vector<ComparedPlane> planes, truth;
            for (const auto& plane : found->planes)
                planes.push_back({plane->id, plane->normal, plane->distance});
            for (const TruePlane& plane : scene.planes)
                truth.push_back({plane.id, plane.normal, plane.distance});
            Labels labels = labelsOf(*found, scan.recording);
            completeLabels(labels, *found, scan.recording, parameters);
            const LabelComparison at50 = *compareLabels(labels, scan.labels, planes, truth, {0.5, minReturns});
            const LabelComparison at80 = *compareLabels(labels, scan.labels, planes, truth, {0.8, minReturns});
            add(tally.at50, at50);
            add(tally.at80, at80);
            if (verbose) {
                for (const PlaneGroup& g : at50.missed) {
                    std::int64_t returns = 0;
                    for (const auto& line : scan.labels)
                        for (const int label : line)
                            returns += std::find(g.begin(), g.end(), label) != g.end() ? 1 : 0;
                    std::printf("  %s %lu missed %s n=(%.2f %.2f %.2f) d=%.3f returns %ld\n", name.c_str(), seed,
                                scene.planes[static_cast<std::size_t>(g.front())].name.c_str(),
                                truth[static_cast<std::size_t>(g.front())].normal.x(),
                                truth[static_cast<std::size_t>(g.front())].normal.y(),
                                truth[static_cast<std::size_t>(g.front())].normal.z(),
                                truth[static_cast<std::size_t>(g.front())].distance, returns);
                }
                for (const int id : at50.noise) {
                    const auto plane = *std::find_if(found->planes.begin(), found->planes.end(),
                                                     [&](const auto& p) { return p->id == id; });
                    std::printf("  %s %lu false P%d n=(%.2f %.2f %.2f) d=%.3f points %d segments %zu error %.2f\n",
                                name.c_str(), seed, id, plane->normal.x(), plane->normal.y(), plane->normal.z(),
                                plane->distance, plane->points, plane->segments.size(), plane->fittingError);
                }
            }
            for (const RegionMatch& match : at50.correct) {
                const auto plane = *std::find_if(found->planes.begin(), found->planes.end(),
                                                 [&](const auto& p) { return p->id == match.a; });
                if (match.b.size() > 1)
                    continue;  // coplanar ones may differ by what the noise cannot tell
                const TruePlane& t = scene.planes[static_cast<std::size_t>(match.b.front())];
                const Eigen::Vector3d e = errorOf(*plane, t);
                const Eigen::Matrix3d f = informationOf(scan, match.b, t, noise, sensor);
                tally.squares.push_back(e.dot(f * e));
                // The error in the plane's own tangents.
                const double side = plane->normal.dot(t.normal) < 0 ? -1 : 1;
                Eigen::Vector3d own;
                own.head<2>() = plane->tangents.transpose() * (plane->normal - side * t.normal);
                own[2] = plane->distance - side * t.distance;
                tally.honest.push_back(own.dot(plane->covariance.inverse() * own));
                if (verbose && tally.squares.back() > 25)
                    std::printf("  %s %lu P%d %s e'Fe %.1f e'C-1e %.1f points %d segs %zu\n", name.c_str(), seed,
                                plane->id, t.name.c_str(), tally.squares.back(), tally.honest.back(), plane->points,
                                plane->segments.size());
            }
        }
        std::printf("%-10s %7.3f %7.3f %7.3f %7.3f %7.2f %7.2f %8.3f\n", name.c_str(), tally.at50.recall(),
                    tally.at50.precision(), tally.at50.f1(), tally.at80.f1(), std::sqrt(median(tally.squares) / 2.366),
                    median(tally.honest), median(tally.times));
        std::fflush(stdout);
        for (auto [sum, part] : {std::pair{&all.at50, &tally.at50}, std::pair{&all.at80, &tally.at80}}) {
            sum->correct += part->correct;
            sum->groups += part->groups;
            sum->regions += part->regions;
        }
        all.squares.insert(all.squares.end(), tally.squares.begin(), tally.squares.end());
        all.honest.insert(all.honest.end(), tally.honest.begin(), tally.honest.end());
        all.times.insert(all.times.end(), tally.times.begin(), tally.times.end());
    }
    double mean = 0;
    for (const double t : all.times)
        mean += t / static_cast<double>(all.times.size());
    std::printf("%-10s %7.3f %7.3f %7.3f %7.3f %7.2f %7.2f %8.3f (mean)\n", "all", all.at50.recall(),
                all.at50.precision(), all.at50.f1(), all.at80.f1(), std::sqrt(median(all.squares) / 2.366),
                median(all.honest), mean);
}
