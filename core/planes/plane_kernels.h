// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "core/planes/plane_estimate.h"

namespace planewright {

/// Segments that the kernels work on in one go.
inline constexpr int kBatch = 32;

/// Segments that are asked about one plane together, in order: those of a slice one after another.
class SegmentBatch {
public:
    /// A segment and the frame of its slice; they must stay where they are.
    struct Placed {
        const SegmentStatistics* statistics;
        const SliceFrame* frame;
    };
    /// The numbers of so many segments, one row for each number.
    struct Block {
        double u[kBatch], v[kBatch];
        double directionU[kBatch], directionV[kBatch];
        double offsetInformation[kBatch], slopeInformation[kBatch];
        double length[kBatch];
        double aheadY[kBatch], aheadZ[kBatch];
        double originY[kBatch], originZ[kBatch];
    };

    /// Makes it one of `count` segments, which `place(i)` gives.
    template <class Place>
    void fill(std::size_t count, Place place)
    {
        placed_.resize(count);
        blocks_.resize(std::max(blocks_.size(), (count + kBatch - 1) / kBatch));
        for (std::size_t i = 0; i < count; ++i) {
            placed_[i] = place(i);
            write(placed_[i], blocks_[i / kBatch], i % kBatch);
        }
    }

    int size() const { return static_cast<int>(placed_.size()); }
    const Placed& operator[](int i) const { return placed_[static_cast<std::size_t>(i)]; }
    /// The block of the segments from `first` on, which is a multiple of kBatch; what is past the end has any numbers.
    const Block& block(int first) const { return blocks_[static_cast<std::size_t>(first / kBatch)]; }

private:
    static void write(const Placed& placed, Block& block, std::size_t i)
    {
        const SegmentStatistics& s = *placed.statistics;
        const SliceFrame& frame = *placed.frame;
        block.u[i] = s.u;
        block.v[i] = s.v;
        block.directionU[i] = s.directionU;
        block.directionV[i] = s.directionV;
        block.offsetInformation[i] = s.offsetInformation;
        block.slopeInformation[i] = s.slopeInformation;
        block.length[i] = s.length();
        block.aheadY[i] = frame.ahead.y();
        block.aheadZ[i] = frame.ahead.z();
        block.originY[i] = frame.origin.y();
        block.originZ[i] = frame.origin.z();
    }

    std::vector<Placed> placed_;
    std::vector<Block> blocks_;  // at least as many as are in use
};

/// The plane that segments are asked about, by the numbers of its estimate.
struct AskedPlane {
    const Eigen::Vector3d& start;
    double startDistance;
    const Eigen::Matrix<double, 3, 2>& tangents;
    const Eigen::Vector3d& step;
    const Eigen::Matrix3d* covariance;  ///< none where its own variance does not count
};

/// The sums of so many segments, number by number.
struct SumColumns {
    static constexpr int kNumbers = 15;
    double of[kNumbers][kBatch];
};

/// The inner loops over segments, for one kind of processor, with the same bits on all: each segment is a lane of its
/// own, and nothing is added up across them.
///
/// The first `count` segments of a block; all kBatch numbers may be written. Segments whose line noise directs are
/// given NaN, to be worked out one by one. Pitch errors are those of whole slices (`noise.pitchCommon`).
struct PlaneKernels {
    const char* name;

    /// PlaneEstimate::joinChi, or residualChi without a covariance.
    void (*chis)(const AskedPlane& plane, const SegmentBatch::Block& block, int count, const NoiseParameters& noise,
                 double floor, double limit, double* chis);
    /// PlaneEstimate::pitchEvidence.
    void (*evidences)(const AskedPlane& plane, const SegmentBatch::Block& block, int count,
                      const NoiseParameters& noise, double floor, double* informations, double* gradients);
    /// SegmentSums of the segments, with a floor [m].
    void (*sums)(const AskedPlane& plane, const SegmentBatch::Block& block, int count, const NoiseParameters& noise,
                 double floor, SumColumns& sums);
};

/// All kinds that this processor can run, the fastest last.
std::span<const PlaneKernels> availablePlaneKernels();

}  // namespace planewright
