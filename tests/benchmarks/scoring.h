// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "core/evaluation/compare_labels.h"
#include "core/simulation/nodding_scanner.h"

namespace planewright {

/// Regions that are planes of the truth, planes of the truth, and regions.
struct MatchCounts {
    double correct = 0.0;
    double groups = 0.0;
    double regions = 0.0;

    double recall() const { return groups > 0.0 ? correct / groups : 1.0; }
    double precision() const { return regions > 0.0 ? correct / regions : 1.0; }
    double f1() const { return groups + regions > 0.0 ? 2.0 * correct / (groups + regions) : 1.0; }
    MatchCounts& operator+=(const MatchCounts& other);
};

/// A true plane that was found at 50 % overlap, and how well.
struct FoundPlane {
    int truth = 0;          ///< id of the TruePlane
    double angle = 0.0;     ///< of the normals [rad]
    double distance = 0.0;  ///< |d − d'| [m]
    double squared = 0.0;   ///< e'Fe, F the information of all true points: 3 is the bound's expectation
};

MatchCounts countsOf(const LabelComparison& compared);

/// What an extractor made of a scan, held against the truth.
struct Score {
    MatchCounts at50;
    MatchCounts at80;
    std::vector<FoundPlane> found;  ///< those that are alone in their geometric plane, in order of truth
};

/// Median of a χ² with three degrees of freedom: what e'Fe of estimates at the bound has.
inline constexpr double kMedianChi3 = 2.366;

/// Information that all points of each true plane have of it, in order of their ids.
std::vector<Eigen::Matrix3d> trueInformation(const Scene& scene, const SimulatedScan& scan,
                                             const SimulationNoise& noise);

/// A simulated scan with what its planes tell at best.
class Judge {
public:
    Judge(const Scene& scene, const SimulatedScan& scan, const SimulationNoise& noise, std::int64_t minReturns);

    /// Labels per slice and beam, and the planes that they name.
    Score judge(const LabelGrid& labels, const std::vector<ComparedPlane>& planes) const;

private:
    const Scene& scene_;
    const SimulatedScan& scan_;
    std::int64_t minReturns_;
    std::vector<ComparedPlane> truth_;
    std::vector<Eigen::Matrix3d> information_;  // of each true plane
};

/// Median; 0 of nothing.
double median(std::vector<double> values);

/// Error in units of the Cramér-Rao bound: root of the median of e'Fe over that of a χ² with three degrees of freedom.
double errorOverBound(std::vector<double> squared);
double errorOverBound(const std::vector<FoundPlane>& found);

}  // namespace planewright
