// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/planes/plane_estimate.h"
#include "core/planes/plane_kernels.h"
#include "core/planes/segment_formulas.h"

namespace planewright {

namespace {

constexpr double kAskAlone = std::numeric_limits<double>::quiet_NaN();

SegmentSums<double> column(const SumColumns& columns, int i)
{
    const auto& of = columns.of;
    return {of[0][i], of[1][i], of[2][i],  of[3][i],  of[4][i],  of[5][i],  of[6][i], of[7][i],
            of[8][i], of[9][i], of[10][i], of[11][i], of[12][i], of[13][i], of[14][i]};
}

/// Calls `visit(first, count)` for the stretches of a batch that the kernels work on in one go.
template <class Visit>
void visitStretches(const SegmentBatch& batch, Visit visit)
{
    for (int first = 0; first < batch.size(); first += kBatch)
        visit(first, std::min(kBatch, batch.size() - first));
}

}  // namespace

AskedPlane PlaneEstimate::asked(bool withOwnVariance) const
{
    return {start_, startDistance_, tangents_, step_, withOwnVariance ? &covariance_ : nullptr};
}

void PlaneEstimate::chisOf(const SegmentBatch& batch, const NoiseParameters& noise, double floor, double limit,
                           bool withOwnVariance, std::span<double> chis, const PlaneKernels& kernels) const
{
    std::array<double, kBatch> lanes;
    lanes.fill(kAskAlone);
    visitStretches(batch, [&](int first, int count) {
        if (noise.pitchCommon)
            kernels.chis(asked(withOwnVariance), batch.block(first), count, noise, floor, limit, lanes.data());
        for (int i = 0; i < count; ++i) {
            double chi = lanes[static_cast<std::size_t>(i)];
            if (std::isnan(chi)) {
                const SegmentBatch::Placed& one = batch[first + i];
                chi = chiOf(inSlice(*one.frame), *one.statistics, noise, floor, limit, withOwnVariance);
            }
            chis[static_cast<std::size_t>(first + i)] = chi;
        }
    });
}

void PlaneEstimate::joinChis(const SegmentBatch& batch, const NoiseParameters& noise, double floor, double limit,
                             std::span<double> chis, const PlaneKernels& kernels) const
{
    chisOf(batch, noise, floor, limit, true, chis, kernels);
}

void PlaneEstimate::residualChis(const SegmentBatch& batch, const NoiseParameters& noise, double floor,
                                 std::span<double> chis, const PlaneKernels& kernels) const
{
    chisOf(batch, noise, floor, std::numeric_limits<double>::infinity(), false, chis, kernels);
}

void PlaneEstimate::pitchEvidences(const SegmentBatch& batch, const NoiseParameters& noise, double floor,
                                   std::span<PitchEvidence> evidences, const PlaneKernels& kernels) const
{
    std::array<double, kBatch> informations;
    std::array<double, kBatch> gradients;
    informations.fill(kAskAlone);
    visitStretches(batch, [&](int first, int count) {
        if (noise.pitchCommon)
            kernels.evidences(asked(true), batch.block(first), count, noise, floor, informations.data(),
                              gradients.data());
        for (int i = 0; i < count; ++i) {
            const auto lane = static_cast<std::size_t>(i);
            const SegmentBatch::Placed& one = batch[first + i];
            evidences[static_cast<std::size_t>(first + i)] =
                std::isnan(informations[lane]) ? pitchEvidence(inSlice(*one.frame), *one.statistics, noise, floor)
                                               : PitchEvidence{informations[lane], gradients[lane]};
        }
    });
}

void PlaneEstimate::accumulate(const SegmentBatch& batch, const NoiseParameters& noise, double floor,
                               const PlaneKernels& kernels)
{
    SumColumns columns;
    std::fill_n(columns.of[0], kBatch, kAskAlone);
    SegmentSums<double> sums{};
    const SliceFrame* slice = nullptr;  // that the sums are of
    visitStretches(batch, [&](int first, int count) {
        if (noise.pitchCommon)
            kernels.sums(asked(true), batch.block(first), count, noise, floor, columns);
        for (int i = 0; i < count; ++i) {
            const SegmentBatch::Placed& one = batch[first + i];
            const SegmentSums<double> own = std::isnan(columns.of[0][i])
                                                ? sumsOf(inSlice(*one.frame), *one.statistics, noise, floor)
                                                : column(columns, i);
            if (slice == one.frame) {
                sums += own;
                continue;
            }
            if (slice != nullptr)
                addSlice(sums, noise, 1.0);
            sums = own;
            slice = one.frame;
        }
    });
    if (slice != nullptr)
        addSlice(sums, noise, 1.0);
}

}  // namespace planewright
