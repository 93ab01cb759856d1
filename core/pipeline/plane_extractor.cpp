// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/pipeline/plane_extractor.h"

#include <string>
#include <utility>
#include <variant>

#include "core/pipeline/end_point_method.h"
#include "core/pipeline/likelihood_method.h"

namespace planewright {

std::unique_ptr<ExtractionMethod> makeMethod(const Parameters& parameters)
{
    if (parameters.method.estimator == Estimator::Likelihood)
        return std::make_unique<LikelihoodMethod>();
    return std::make_unique<EndPointMethod>();
}

PlaneExtractor::PlaneExtractor(const SensorModel& sensor, const Parameters& parameters, ExtractionOptions options)
    : sensor_(sensor), parameters_(parameters), options_(std::move(options)), method_(makeMethod(parameters))
{
}

std::shared_ptr<const Snapshot> PlaneExtractor::step(const ScanSlice& slice)
{
    return makeSnapshot(advance(slice));
}

std::shared_ptr<const Snapshot> PlaneExtractor::finish()
{
    return makeSnapshot(conclude());
}

StepReport PlaneExtractor::advance(const ScanSlice& slice)
{
    StepReport report;
    StepRecorder recorder(report, options_.clock, options_.explain);
    work(slice, report, recorder);
    return report;
}

StepReport PlaneExtractor::conclude()
{
    StepReport report;
    StepRecorder recorder(report, options_.clock, options_.explain);
    workLast(report, recorder);
    return report;
}

PhasedStep PlaneExtractor::stepByPhases(const ScanSlice& slice)
{
    return byPhases([&](StepReport& report, StepRecorder& recorder) { work(slice, report, recorder); });
}

PhasedStep PlaneExtractor::finishByPhases()
{
    return byPhases([&](StepReport& report, StepRecorder& recorder) { workLast(report, recorder); });
}

Result<void> PlaneExtractor::mustBeThere(const Operand& operand) const
{
    constexpr const char* kAdvice = "Choose one of this step, or another step.";
    if (const auto* plane = std::get_if<PlaneRef>(&operand); plane != nullptr && !method_->hasPlane(plane->id))
        return fail(ErrorCode::Usage, "There is no plane " + std::to_string(plane->id) + " at this step. " + kAdvice);
    if (const auto* segment = std::get_if<SegmentId>(&operand); segment != nullptr && !method_->ownerOf(*segment))
        return fail(ErrorCode::Usage, "There is no segment " + std::to_string(segment->step) + "." +
                                          std::to_string(segment->index) + " at this step. " + kAdvice);
    return {};
}

Result<WhyNot> PlaneExtractor::whyNot(const Operand& a, const Operand& b)
{
    const bool planeIsFirst = std::holds_alternative<PlaneRef>(a);
    const auto* plane = std::get_if<PlaneRef>(planeIsFirst ? &a : &b);
    const Operand& with = planeIsFirst ? b : a;
    if (plane == nullptr || std::holds_alternative<ClusterRef>(with))
        return fail(ErrorCode::Usage, "Choose two planes, or a segment and a plane.");
    for (const Operand& operand : {a, b}) {
        if (const Result<void> there = mustBeThere(operand); !there)
            return tl::unexpected{there.error()};
    }
    WhyNot answer{{a, b}, false, {}};
    if (const auto* other = std::get_if<PlaneRef>(&with)) {
        if (other->id == plane->id)
            return fail(ErrorCode::Usage, "Both are the same plane. Choose two planes, or a segment and a plane.");
        answer.ways = method_->waysOfMerging(plane->id, other->id, parameters_);
        return answer;
    }
    const SegmentId segment = std::get<SegmentId>(with);
    answer.together = method_->ownerOf(segment) == plane->id;
    answer.ways = method_->waysOfJoining(segment, plane->id, parameters_);
    return answer;
}

void PlaneExtractor::work(const ScanSlice& slice, StepReport& report, StepRecorder& recorder)  // Table I
{
    report.step = slice.step;
    report.tilt = slice.tilt;

    recorder.begin(Phase::Extract);
    report.counts.returns = method_->extractLineSegments(slice, sensor_, parameters_, recorder);
    recorder.begin(Phase::Assign);
    method_->assignToPlanes(parameters_, recorder);
    recorder.begin(Phase::Cluster);
    method_->addToClusters(parameters_, recorder);

    if (parameters_.schedule.fitsPlanesAt(slice.step)) {
        recorder.begin(Phase::Fit);
        method_->fitPlanes(parameters_, recorder);
    }
    if (parameters_.schedule.splitsAndMergesAt(slice.step)) {
        recorder.begin(Phase::SplitMerge);
        method_->splitAndMerge(parameters_, recorder);
    }
    if (parameters_.schedule.fitsRemainingAt(slice.step)) {
        recorder.begin(Phase::Remaining);
        method_->fitRemainingSegments(parameters_, recorder);
    }
    recorder.end();
    method_->count(report.counts);
}

void PlaneExtractor::workLast(StepReport& report, StepRecorder& recorder)
{
    report.step = -1;
    method_->finish(parameters_, recorder);
    recorder.end();
    method_->count(report.counts);
    report.counts.segments = report.counts.assigned = report.counts.clustered = 0;
}

template <class Work>
PhasedStep PlaneExtractor::byPhases(Work work)
{
    PhasedStep step;
    StepReport whole;
    std::size_t told = 0;  // decisions of the phases before
    auto timesBefore = whole.times;
    const PhaseListener listener = [&](Phase phase, std::string_view pass) {
        std::vector<Decision> decisions = std::exchange(whole.decisions, {});
        StepReport report = whole;
        report.decisions.assign(decisions.begin() + static_cast<std::ptrdiff_t>(told), decisions.end());
        told = decisions.size();
        whole.decisions = std::move(decisions);
        for (std::size_t i = 0; i < kPhases; ++i)
            report.times[i] -= timesBefore[i];
        timesBefore = whole.times;
        method_->count(report.counts);
        if (phase == Phase::Finish)
            report.counts.segments = 0;
        // What the method counts of the newest slice is of the slice before until the phase has run.
        if (phase == Phase::Extract || phase == Phase::Finish)
            report.counts.assigned = 0;
        if (phase == Phase::Extract || phase == Phase::Assign || phase == Phase::Finish)
            report.counts.clustered = 0;
        step.phases.push_back({phase, pass, makeSnapshot(std::move(report))});
    };
    StepRecorder recorder(whole, options_.clock, true, &listener);
    work(whole, recorder);
    step.snapshot = makeSnapshot(std::move(whole));
    return step;
}

std::shared_ptr<const Snapshot> PlaneExtractor::makeSnapshot(StepReport report)
{
    auto snapshot = std::make_shared<Snapshot>();
    snapshot->noise = {parameters_.noise.rangeConstant, parameters_.noise.rangeProportional, parameters_.noise.pitch,
                       false};
    method_->publish(*snapshot);
    snapshot->report = std::move(report);
    return snapshot;
}

}  // namespace planewright
