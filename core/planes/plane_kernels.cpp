// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/plane_kernels.h"

#include <array>
#include <limits>

#include "core/planes/segment_formulas.h"
#include "core/segments/beam_kernels.h"

// One body each, inlined into a function per kind of processor.
#define PLANEWRIGHT_BODY [[gnu::always_inline]] inline

namespace planewright {

namespace {

template <int Width>
struct Doubles;
template <>
struct Doubles<2> {
    using Number [[gnu::vector_size(16)]] = double;
};
template <>
struct Doubles<4> {
    using Number [[gnu::vector_size(32)]] = double;
};
template <>
struct Doubles<8> {
    using Number [[gnu::vector_size(64)]] = double;
};

/// A frame's numbers; those of its derivatives by the tilt are the same turned round.
template <class Number>
struct FrameNumbers {
    Number aheadY, aheadZ;
    Number originY, originZ;
};

template <class Number>
PLANEWRIGHT_BODY void load(const double* from, Number& numbers)
{
    using Anywhere [[gnu::vector_size(sizeof(Number)), gnu::aligned(8), gnu::may_alias]] = double;
    numbers = *reinterpret_cast<const Anywhere*>(from);
}

template <class Number>
PLANEWRIGHT_BODY void store(const Number& numbers, double* to)
{
    using Anywhere [[gnu::vector_size(sizeof(Number)), gnu::aligned(8), gnu::may_alias]] = double;
    *reinterpret_cast<Anywhere*>(to) = numbers;
}

/// A register's worth of segments from one on, with their frames.
template <class Number>
PLANEWRIGHT_BODY void load(const SegmentBatch::Block& block, int i, SegmentNumbers<Number>& s,
                           FrameNumbers<Number>& frame)
{
    load(block.u + i, s.u);
    load(block.v + i, s.v);
    load(block.directionU + i, s.directionU);
    load(block.directionV + i, s.directionV);
    load(block.offsetInformation + i, s.offsetInformation);
    load(block.slopeInformation + i, s.slopeInformation);
    load(block.length + i, s.length);
    load(block.aheadY + i, frame.aheadY);
    load(block.aheadZ + i, frame.aheadZ);
    load(block.originY + i, frame.originY);
    load(block.originZ + i, frame.originZ);
}

/// Product of a vector with one that has no x.
template <class Number>
PLANEWRIGHT_BODY void takeDot(double x, double y, double z, const Number& otherY, const Number& otherZ, Number& dot)
{
    dot = x * 0.0 + y * otherY + z * otherZ;
}

/// PlaneEstimate::look, in the same order.
template <class Number>
PLANEWRIGHT_BODY void look(const AskedPlane& plane, const FrameNumbers<Number>& frame, PlaneInSliceOf<Number>& seen)
{
    const auto& n = plane.start;
    const auto& t = plane.tangents;
    seen.distance.u = Number{} + n[0];
    takeDot(n[0], n[1], n[2], frame.aheadY, frame.aheadZ, seen.distance.v);
    takeDot(n[0], n[1], n[2], frame.originY, frame.originZ, seen.distance.constant);
    seen.distance.constant -= plane.startDistance;
    seen.first.u = Number{} + t(0, 0);
    takeDot(t(0, 0), t(1, 0), t(2, 0), frame.aheadY, frame.aheadZ, seen.first.v);
    takeDot(t(0, 0), t(1, 0), t(2, 0), frame.originY, frame.originZ, seen.first.constant);
    seen.second.u = Number{} + t(0, 1);
    takeDot(t(0, 1), t(1, 1), t(2, 1), frame.aheadY, frame.aheadZ, seen.second.v);
    takeDot(t(0, 1), t(1, 1), t(2, 1), frame.originY, frame.originZ, seen.second.constant);
    seen.pitch.u = Number{};
    takeDot<Number>(n[0], n[1], n[2], -frame.aheadZ, frame.aheadY, seen.pitch.v);
    takeDot<Number>(n[0], n[1], n[2], -frame.originZ, frame.originY, seen.pitch.constant);
    const Number steepness = seen.distance.u * seen.distance.u + seen.distance.v * seen.distance.v;
    seen.steepness = steepness > kLeastSteepness ? steepness : Number{} + kLeastSteepness;
}

/// What all of the loops need of a register of segments.
template <class Number>
struct Seen {
    PlaneInSliceOf<Number> plane;
    SegmentNumbers<Number> segment;
    SegmentRow<Number> row;
    SegmentVariances<Number> variances;  // NaN where noise directs the line
};

template <int Width>
PLANEWRIGHT_BODY void see(const AskedPlane& plane, const SegmentBatch::Block& block, int i,
                          const NoiseParameters& noise, Seen<typename Doubles<Width>::Number>& seen)
{
    using Number = typename Doubles<Width>::Number;
    FrameNumbers<Number> frame;
    load(block, i, seen.segment, frame);
    look(plane, frame, seen.plane);
    takeRow(seen.plane, seen.segment, seen.row);
    Number aside;
    Number least;
    takeExtent(seen.segment, noise, aside, least);
    const Number steepness = aside < least ? Number{} + std::numeric_limits<double>::quiet_NaN() : seen.plane.steepness;
    seen.variances.place = steepness / seen.segment.offsetInformation;
    seen.variances.slope = steepness / seen.segment.slopeInformation;
}

template <int Width>
PLANEWRIGHT_BODY void chisBody(const AskedPlane& plane, const SegmentBatch::Block& block, int count,
                               const NoiseParameters& noise, double floor, double limit, double* chis)
{
    using Number = typename Doubles<Width>::Number;
    const double pitch = noise.pitch * noise.pitch;
    for (int i = 0; i < count; i += Width) {
        Seen<Number> seen;
        see<Width>(plane, block, i, noise, seen);
        addFloor<Number>(seen.segment, floor * floor * seen.plane.steepness, seen.variances);
        Number distance, inclination, place, chi;
        takeResidual(seen.row, plane.step, distance, inclination);
        takePlaceVariance(seen.row, seen.variances, pitch, plane.covariance, place);
        takeChi(seen.row, seen.variances, pitch, plane.covariance, place, distance, inclination, chi);
        const Number infinite = Number{} + std::numeric_limits<double>::infinity();
        chi = distance * distance >= limit * place ? infinite : chi;
        chi = seen.plane.steepness <= kLeastSteepness ? infinite : chi;
        store(chi, chis + i);
    }
}

template <int Width>
PLANEWRIGHT_BODY void evidencesBody(const AskedPlane& plane, const SegmentBatch::Block& block, int count,
                                    const NoiseParameters& noise, double floor, double* informations, double* gradients)
{
    using Number = typename Doubles<Width>::Number;
    for (int i = 0; i < count; i += Width) {
        Seen<Number> seen;
        see<Width>(plane, block, i, noise, seen);
        addFloor<Number>(seen.segment, Number{} + floor * floor, seen.variances);
        Number distance, inclination, information, gradient;
        takeResidual(seen.row, plane.step, distance, inclination);
        takeEvidence(seen.row, seen.variances, distance, inclination, information, gradient);
        store(information, informations + i);
        store(gradient, gradients + i);
    }
}

template <int Width>
PLANEWRIGHT_BODY void sumsBody(const AskedPlane& plane, const SegmentBatch::Block& block, int count,
                               const NoiseParameters& noise, double floor, SumColumns& columns)
{
    using Number = typename Doubles<Width>::Number;
    for (int i = 0; i < count; i += Width) {
        Seen<Number> seen;
        see<Width>(plane, block, i, noise, seen);
        if (floor * floor > 0.0)
            addFloor<Number>(seen.segment, Number{} + floor * floor, seen.variances);
        SegmentSums<Number> sums;
        takeSums(seen.row, seen.variances, sums);
        const Number* const numbers[] = {
            &sums.i00,          &sums.i01, &sums.i02, &sums.i11, &sums.i12, &sums.i22, &sums.g0,
            &sums.g1,           &sums.g2,  &sums.c0,  &sums.c1,  &sums.c2,  &sums.chi, &sums.pitchInformation,
            &sums.pitchGradient};
        for (int k = 0; k < SumColumns::kNumbers; ++k)
            store(*numbers[k], columns.of[k] + i);
    }
}

// A function of each body for one kind of processor.
// NOLINTBEGIN(bugprone-macro-parentheses): TARGET is an attribute of a function, which takes no parentheses.
#define PLANEWRIGHT_KERNELS(KIND, WIDTH, TARGET)                                                                     \
    TARGET void chis##KIND(const AskedPlane& plane, const SegmentBatch::Block& block, int count,                     \
                           const NoiseParameters& noise, double floor, double limit, double* chis)                   \
    {                                                                                                                \
        chisBody<WIDTH>(plane, block, count, noise, floor, limit, chis);                                             \
    }                                                                                                                \
    TARGET void evidences##KIND(const AskedPlane& plane, const SegmentBatch::Block& block, int count,                \
                                const NoiseParameters& noise, double floor, double* informations, double* gradients) \
    {                                                                                                                \
        evidencesBody<WIDTH>(plane, block, count, noise, floor, informations, gradients);                            \
    }                                                                                                                \
    TARGET void sums##KIND(const AskedPlane& plane, const SegmentBatch::Block& block, int count,                     \
                           const NoiseParameters& noise, double floor, SumColumns& columns)                          \
    {                                                                                                                \
        sumsBody<WIDTH>(plane, block, count, noise, floor, columns);                                                 \
    }                                                                                                                \
    constexpr PlaneKernels k##KIND{#KIND, chis##KIND, evidences##KIND, sums##KIND};
// NOLINTEND(bugprone-macro-parentheses)

PLANEWRIGHT_KERNELS(Baseline, 2, )
#ifdef __x86_64__
PLANEWRIGHT_KERNELS(Avx2, 4, [[gnu::target("avx2")]])
PLANEWRIGHT_KERNELS(Avx512, 8, [[gnu::target("avx512f,avx512bw,avx512vl,avx512dq")]])
constexpr std::array kKinds{kBaseline, kAvx2, kAvx512};
#else
constexpr std::array kKinds{kBaseline};
#endif

}  // namespace

std::span<const PlaneKernels> availablePlaneKernels()
{
    // The same processors as the loops over scan points.
    return std::span{kKinds}.first(availableBeamKernels().size());
}

const PlaneKernels& planeKernels()
{
    return availablePlaneKernels().back();
}

}  // namespace planewright
