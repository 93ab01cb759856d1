// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/params/presets.h"
#include "tests/core/pipeline/raw_slice.h"
#include "tests/core/pipeline/traced_scan.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

/// Divisions one within the other before a piece is halved.
constexpr int kHalvedFrom = 48;

/// The divisions of a run by chords, gone through from the whole run to its parts as its numbers say.
class ChordTwin {
public:
    ChordTwin(const ScanSlice& slice, const Parameters& parameters, std::vector<int> beams, const SliceTrace& trace)
        : parameters_(parameters), beams_(std::move(beams))
    {
        for (const int beam : beams_)
            points_.push_back(pointOf(slice, beam));
        for (const TracedSplit& split : trace.splits) {
            const auto at = std::lower_bound(beams_.begin(), beams_.end(), split.beam);
            if (at != beams_.end() && *at == split.beam && split.test.name != "two_lines_gain")
                told_[static_cast<int>(at - beams_.begin())] = split.test;
        }
    }

    /// Whether all that was told is what the ranges say.
    bool agrees(const ToldPhase& phase, Recomputed& recomputed)
    {
        const bool isSame = follow(0, static_cast<int>(points_.size()) - 1, 0, phase, recomputed);
        return isSame && told_.empty();
    }

    /// Intervals that stayed whole although a point is farther than it may be: for few points, or because one line
    /// explains both parts.
    struct Whole {
        int points = 0;
        double share = 0.0;  ///< of the distance in what it may be
    };
    const std::vector<Whole>& whole() const { return whole_; }

private:
    struct Farthest {
        int point = -1;
        double distance = 0.0;
        double limit = 1.0;
    };

    double distanceOf(int point, int from, int to) const
    {
        const Eigen::Vector2d along = at(to) - at(from);
        const Eigen::Vector2d aside = at(point) - at(from);
        return std::abs(along.x() * aside.y() - along.y() * aside.x()) / along.norm();
    }

    double limitOf(int point, int from, int to) const
    {
        const Eigen::Vector2d along = (at(to) - at(from)).normalized();
        const double variance = varianceAcross({-along.y(), along.x()}, at(point), parameters_.noise);
        return std::max(parameters_.segments.splitDistance, parameters_.segments.splitSigmas * std::sqrt(variance));
    }

    /// Of the points beyond what each may be off the chord the one that is farthest.
    Farthest farthest(int from, int to) const
    {
        Farthest found;
        for (int point = from + 1; point < to; ++point) {
            const double distance = distanceOf(point, from, to);
            const double limit = limitOf(point, from, to);
            if (distance > limit && distance > found.distance)
                found = {point, distance, limit};
        }
        return found;
    }

    bool follow(int from, int to, int depth, const ToldPhase& phase, Recomputed& recomputed)
    {
        const Farthest expected = farthest(from, to);
        const auto first = told_.upper_bound(from);
        if (first == told_.end() || first->first >= to) {
            if (expected.point >= 0)
                whole_.push_back({to - from + 1, expected.distance / expected.limit});
            return true;
        }
        if (expected.point < 0)
            return false;
        int point = depth >= kHalvedFrom ? (from + to) / 2 : expected.point;
        // Two points as far off as floats tell: either may be taken.
        for (auto near = first; depth < kHalvedFrom && near != told_.end() && near->first < to; ++near) {
            if (std::abs(distanceOf(near->first, from, to) - expected.distance) < 2e-6)
                point = near->first;
        }
        const auto told = told_.find(point);
        if (told == told_.end())
            return false;
        const Test test = told->second;
        told_.erase(told);
        if (depth >= kHalvedFrom) {
            if (test.name != "divisions" || !recomputed.agree(phase, test, depth, kHalvedFrom))
                return false;
        } else if (test.name != "chord_distance" ||
                   // A centimetre of floats of several metres.
                   !recomputed.agree(phase, test, distanceOf(point, from, to), limitOf(point, from, to), 2e-4)) {
            return false;
        }
        return follow(from, point, depth + 1, phase, recomputed) && follow(point, to, depth + 1, phase, recomputed);
    }

    const Eigen::Vector2d& at(int point) const { return points_[static_cast<std::size_t>(point)]; }

    const Parameters& parameters_;
    std::vector<int> beams_;
    std::vector<Eigen::Vector2d> points_;
    std::map<int, Test> told_;  // by the place of its point
    std::vector<Whole> whole_;
};

std::vector<int> beamsOf(const TracedRun& run, const std::vector<int>& echoes)
{
    return {std::lower_bound(echoes.begin(), echoes.end(), run.firstBeam),
            std::upper_bound(echoes.begin(), echoes.end(), run.lastBeam)};
}

/// A piece that two lines explain better than one, from beam to beam.
struct BendTwin {
    double gain = 0.0;   ///< in variances
    double limit = 0.0;  ///< 16 where one variance serves all points, or 25; of their scatter, but 25 variances at most

    BendTwin(const ScanSlice& slice, const SensorModel& sensor, int first, int border, int last,
             const Parameters& parameters)
    {
        const RawLine one(slice, sensor, first, last);
        const double apart =
            RawLine(slice, sensor, first, border - 1).across + RawLine(slice, sensor, border, last).across;
        const double variance = varianceAcross(one.normal, one.middle, parameters.noise);
        gain = (one.across - apart) / variance;
        const auto isEven = [&](int beam) {
            return varianceAcross(one.normal, pointOf(slice, beam), parameters.noise) < 1.5 * variance;
        };
        const double wanted = isEven(first) && isEven(last) ? 16.0 : 25.0;
        const double scatter = std::max(variance, apart / (one.count - 4.0));
        limit = std::min(25.0, wanted * scatter / variance);
    }
};

/// Where pieces begin, or end, as far as the trace shows: at kept and dropped ones, and where two were joined again.
std::vector<int> bordersOf(const SliceTrace& trace, const TracedRun& run, bool isFirst)
{
    std::vector<int> borders{isFirst ? run.firstBeam : run.lastBeam};
    for (const TracedPiece& piece : trace.pieces)
        borders.push_back(isFirst ? piece.firstBeam : piece.lastBeam);
    for (const TracedJoin& join : trace.joins)
        borders.push_back(isFirst ? join.after : join.before);
    std::erase_if(borders, [&](int beam) { return beam < run.firstBeam || beam > run.lastBeam; });
    return borders;
}

/// Points left out at the end of a piece after it was divided.
constexpr int kLeftOut = 2;

}  // namespace

/// Where *Slice 2D* shows that runs were divided, and why, worked out anew from the raw ranges.
class ToldSliceSplitsTest : public QObject {
    Q_OBJECT

private slots:
    void chordsAreAsFarAsTold_data();
    void chordsAreAsFarAsTold();
    void twoLinesGainWhatIsTold();
    void manyDivisionsAreCounted_data();
    void manyDivisionsAreCounted();
};

void ToldSliceSplitsTest::chordsAreAsFarAsTold_data()
{
    QTest::addColumn<QString>("preset");
    QTest::addColumn<QString>("scene");
    for (const char* preset : {"paper", "precise"}) {
        for (const char* scene : {"corridor", "office", "stairs", "clutter", "curved"})
            QTest::addRow("%s, %s", preset, scene) << preset << scene;
    }
}

void ToldSliceSplitsTest::chordsAreAsFarAsTold()
{
    QFETCH(QString, preset);
    QFETCH(QString, scene);
    const TracedScan traced(preset, scene);
    Recomputed recomputed;
    bool isRight = true;
    traced.visit(
        [&](const ToldPhase& phase, const ScanSlice& slice, const Parameters& parameters, const SliceTrace& trace) {
            const std::vector<int> echoes = beamsWithEcho(slice, traced.sensor);
            std::size_t splits = 0;
            for (const TracedSplit& split : trace.splits)
                splits += split.test.name == "two_lines_gain" ? 0 : 1;
            const auto before = static_cast<std::size_t>(recomputed.counts["chord_distance"]);
            for (const TracedRun& run : trace.runs) {
                ChordTwin twin(slice, parameters, beamsOf(run, echoes), trace);
                isRight = isRight && twin.agrees(phase, recomputed);
                for (const ChordTwin::Whole& whole : twin.whole()) {
                    // The paper divides at every such point; the precise method only where it is no chance.
                    const bool mayBeWhole = traced.isPrecise && (whole.points <= 3 || whole.share < 2.01);
                    if (!mayBeWhole)
                        qWarning("%s: %d points stayed whole", phase.text().c_str(), whole.points);
                    isRight = isRight && mayBeWhole;
                }
            }
            // Value and limit of each.
            isRight = isRight && static_cast<std::size_t>(recomputed.counts["chord_distance"]) - before == 2 * splits;
        });
    QVERIFY(isRight);
    QVERIFY2(recomputed.counts["chord_distance"] > 100,
             qPrintable(QString::number(recomputed.counts["chord_distance"])));
}

/// Of a piece that was bent the ends are not told: those of what it gave are tried, with the points that these lost.
void ToldSliceSplitsTest::twoLinesGainWhatIsTold()
{
    int bends = 0;
    int found = 0;
    for (const char* scene : {"curved", "clutter", "office"}) {
        const TracedScan traced("precise", scene);
        traced.visit([&](const ToldPhase&, const ScanSlice& slice, const Parameters& parameters,
                         const SliceTrace& trace) {
            for (const TracedSplit& split : trace.splits) {
                if (split.test.name != "two_lines_gain")
                    continue;
                const TracedRun& run = *std::find_if(trace.runs.begin(), trace.runs.end(), [&](const TracedRun& r) {
                    return r.firstBeam <= split.beam && split.beam <= r.lastBeam;
                });
                const auto agrees = [&](int first, int last) {
                    if (echoesIn(slice, traced.sensor, first, split.beam - 1) < 3 ||
                        echoesIn(slice, traced.sensor, split.beam, last) < 3)
                        return false;
                    const BendTwin twin(slice, traced.sensor, first, split.beam, last, parameters);
                    return std::abs(twin.gain - split.test.value) < 2e-3 * twin.gain &&
                           std::abs(twin.limit - split.test.limit) < 2e-3 * twin.limit;
                };
                bool isFound = false;
                for (const int begin : bordersOf(trace, run, true)) {
                    for (const int end : bordersOf(trace, run, false)) {
                        for (int left = 0; left <= kLeftOut; ++left) {
                            for (int right = 0; right <= kLeftOut && begin <= split.beam && split.beam <= end; ++right)
                                isFound = isFound || agrees(std::max(run.firstBeam, begin - left),
                                                            std::min(run.lastBeam, end + right));
                        }
                    }
                }
                ++bends;
                found += isFound ? 1 : 0;
            }
        });
    }
    QVERIFY2(bends > 50 && 10 * found >= 9 * bends, qPrintable(QString("%1 of %2").arg(found).arg(bends)));
}

void ToldSliceSplitsTest::manyDivisionsAreCounted_data()
{
    QTest::addColumn<QString>("preset");
    QTest::newRow("paper") << "paper";
    QTest::newRow("precise") << "precise";
}

/// A wall 10 m ahead that zigzags, by less and less: each of its points is farthest from the chord in turn.
void ToldSliceSplitsTest::manyDivisionsAreCounted()
{
    QFETCH(QString, preset);
    Parameters parameters;
    apply(*findPreset(methodPresets(), preset.toStdString()), parameters);
    parameters.noise.rangeConstant = parameters.noise.rangeProportional = 0.001;
    ScanSlice slice;
    slice.firstBearing = degrees(75.0);
    slice.bearingStep = degrees(0.25);
    for (int i = 0; i < 121; ++i)
        slice.ranges.push_back((10.0 + 0.1 * std::pow(-0.985, i)) /
                               std::sin(slice.bearing(static_cast<std::size_t>(i))));
    const SensorModel sensor;
    ToldPhase phase;
    phase.after = std::make_shared<const Snapshot>();

    const SliceTrace trace = traceSlice(slice, sensor, parameters);

    QCOMPARE(trace.runs.size(), std::size_t(1));
    Recomputed recomputed;
    QVERIFY(ChordTwin(slice, parameters, beamsOf(trace.runs[0], beamsWithEcho(slice, sensor)), trace)
                .agrees(phase, recomputed));
    QVERIFY(recomputed.counts["chord_distance"] >= 2 * kHalvedFrom);
    QVERIFY(recomputed.counts["divisions"] > 4);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ToldSliceSplitsTest)
#include "told_slice_splits_test.moc"
