// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/pipeline/plane_extractor.h"

#include <utility>

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

StepReport PlaneExtractor::advance(const ScanSlice& slice)  // Table I
{
    StepReport report;
    report.step = slice.step;
    report.tilt = slice.tilt;
    StepRecorder recorder(report, options_.clock, options_.explain);

    recorder.begin(Phase::Extract);
    report.counts.returns = method_->extractLineSegments(slice, sensor_, parameters_);
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
    return report;
}

StepReport PlaneExtractor::conclude()
{
    StepReport report;
    report.step = -1;
    StepRecorder recorder(report, options_.clock, options_.explain);
    recorder.begin(Phase::Finish);
    method_->finish(parameters_, recorder);
    recorder.end();
    method_->count(report.counts);
    report.counts.segments = report.counts.assigned = report.counts.clustered = 0;
    return report;
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
