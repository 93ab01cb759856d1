// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/core/pipeline/raw_slice.h"
#include "tests/core/pipeline/told_step.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

/// More points at the end of a piece are not in question when its border is settled, with those beyond it.
constexpr int kMostInQuestion = 14;

/// What a slice was divided into, kept or not, by first and last beam.
std::vector<std::pair<int, int>> partsOf(const ToldPhase& phase)
{
    std::vector<std::pair<int, int>> parts;
    for (const LineSegment& segment : phase.after->segments.slice(phase.after->segments.find(phase.step)))
        parts.emplace_back(segment.firstBeam, segment.lastBeam);
    for (const Decision& decision : phase.decisions()) {
        const PieceRef piece = pieceOf(decision.operands[0]);
        parts.emplace_back(piece.firstBeam, piece.lastBeam);
    }
    return parts;
}

}  // namespace

/// Why pieces of slices became no segments, worked out anew from the raw ranges.
class ToldDiscardedTest : public QObject {
    Q_OBJECT

private slots:
    void piecesAreAsLongAndHaveAsManyPointsAsTold_data() { scans(); }
    void piecesAreAsLongAndHaveAsManyPointsAsTold();
    void strangersAreAsFarOffAsTold_data() { scans(); }
    void strangersAreAsFarOffAsTold();

private:
    static void scans()
    {
        QTest::addColumn<QString>("preset");
        QTest::addColumn<QString>("scene");
        for (const char* preset : {"paper", "precise"}) {
            for (const char* scene : {"corridor", "office", "stairs", "clutter"})
                QTest::addRow("%s, %s", preset, scene) << preset << scene;
        }
    }
};

void ToldDiscardedTest::piecesAreAsLongAndHaveAsManyPointsAsTold()
{
    QFETCH(QString, preset);
    QFETCH(QString, scene);
    const bool isPrecise = preset == "precise";
    const ToldScan scan(preset.toStdString(), scene.toStdString(), 3);
    const SensorModel sensor = sensorOf(scan.recording.description);
    const SegmentParameters& p = scan.parameters.segments;
    const int fewest = std::max(3, p.minPoints);
    const double step = scan.recording.description.bearingStep;
    const double limit = isPrecise
                             ? std::clamp(std::round(fewest * degrees(0.25) / step), 3.0, static_cast<double>(fewest))
                             : p.minPoints;
    Recomputed recomputed;
    int dropped = 0;
    int whole = 0;
    for (const ToldPhase& phase : scan.phases) {
        if (phase.phase != Phase::Extract)
            continue;
        const ScanSlice& slice = scan.sliceOf(phase.step);
        for (const Decision& decision : phase.decisions()) {
            const PieceRef piece = pieceOf(decision.operands[0]);
            const double echoes = echoesIn(slice, sensor, piece.firstBeam, piece.lastBeam);
            for (const Test& test : decision.tests) {
                if (test.name == "points" && !isPrecise)
                    QVERIFY(recomputed.agree(phase, test, echoes, limit));
                if (test.name == "length")
                    QVERIFY(recomputed.agree(phase, test,
                                             (pointOf(slice, piece.firstBeam) - pointOf(slice, piece.lastBeam)).norm(),
                                             p.minLength));
                if (test.name == "points_of_run")
                    QVERIFY(recomputed.agree(phase, test, 1.0, 2.0) && echoes == 1.0);
                // Of what was dropped for its few points neighbours may have taken some since.
                const bool isFew = test.name == "points_of_line" || (test.name == "points" && isPrecise);
                if (!isFew)
                    continue;
                ++dropped;
                whole += test.value == echoes ? 1 : 0;
                QVERIFY(test.value >= echoes && test.value < test.limit);
                QVERIFY(recomputed.agree(phase, test.name, test.limit, isPrecise ? limit : 4.0));
            }
        }
    }
    QVERIFY(recomputed.counts["points"] > 10);
    QVERIFY(2 * whole > dropped);
}

/// A stranger was held against the line of a piece beside it, without the few points at its end that were in question:
/// how many these were is not told, so that each number is tried.
void ToldDiscardedTest::strangersAreAsFarOffAsTold()
{
    QFETCH(QString, preset);
    QFETCH(QString, scene);
    const bool isPrecise = preset == "precise";
    const ToldScan scan(preset.toStdString(), scene.toStdString(), 3);
    const SensorModel sensor = sensorOf(scan.recording.description);
    const SegmentParameters& p = scan.parameters.segments;
    int strangers = 0;
    int recomputed = 0;
    for (const ToldPhase& phase : scan.phases) {
        if (phase.phase != Phase::Extract)
            continue;
        const ScanSlice& slice = scan.sliceOf(phase.step);
        NoiseParameters noise = scan.parameters.noise;
        noise.rangeConstant = phase.after->noise.rangeConstant;
        noise.rangeProportional = phase.after->noise.rangeProportional;
        const std::vector<std::pair<int, int>> parts = partsOf(phase);
        for (const Decision& decision : phase.decisions()) {
            const Test& test = decision.tests.front();
            if (test.name != "line_distance" && test.name != "line_chi2")
                continue;
            QCOMPARE(test.name, std::string_view(isPrecise ? "line_chi2" : "line_distance"));
            const int beam = pieceOf(decision.operands[0]).firstBeam;
            QCOMPARE(pieceOf(decision.operands[0]).lastBeam, beam);
            const Eigen::Vector2d point = pointOf(slice, beam);
            const auto agrees = [&](int firstBeam, int lastBeam) {
                if (echoesIn(slice, sensor, firstBeam, lastBeam) < 3)
                    return false;
                const RawLine line(slice, sensor, firstBeam, lastBeam);
                double value = line.distanceOf(point);
                double limit =
                    std::max(p.splitDistance, p.splitSigmas * std::sqrt(varianceAcross(line.normal, point, noise)));
                if (isPrecise) {
                    const bool ofLine = test.limit == 6.25;  // 2.5 sigmas, with what the line itself is unsure of
                    const double along = Eigen::Vector2d{line.normal.y(), -line.normal.x()}.dot(point - line.middle);
                    const double leverage = ofLine ? 1.0 + 1.0 / line.count + along * along / line.along : 1.0;
                    value = value * value / (leverage * varianceAcross(line.normal, line.middle, noise));
                    limit = ofLine ? 6.25 : 9.0;
                }
                return std::abs(value - test.value) < 0.02 * test.value &&
                       std::abs(limit - test.limit) < 0.02 * test.limit;
            };
            bool found = false;
            for (const auto& [first, last] : parts) {
                const bool isBefore = last < beam && last >= beam - kMostInQuestion;
                const bool isAfter = first > beam && first <= beam + kMostInQuestion;
                for (int left = 0; left <= kMostInQuestion && (isBefore || isAfter) && !found; ++left)
                    found = isBefore ? agrees(first, last - left) : agrees(first + left, last);
            }
            ++strangers;
            recomputed += found ? 1 : 0;
        }
    }
    QVERIFY(strangers > 0);
    // What is beside many of them was divided, joined or left out afterwards: then its line is another.
    QVERIFY2(5 * recomputed > 2 * strangers, qPrintable(QString("%1 of %2").arg(recomputed).arg(strangers)));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ToldDiscardedTest)
#include "told_discarded_test.moc"
