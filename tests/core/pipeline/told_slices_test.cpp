// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/core/pipeline/raw_slice.h"
#include "tests/core/pipeline/traced_scan.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

/// How far two neighbouring echoes are from each other, by the law of cosines.
double gapBetween(const ScanSlice& slice, int before, int after)
{
    const double a = slice.ranges[static_cast<std::size_t>(before)];
    const double b = slice.ranges[static_cast<std::size_t>(after)];
    return std::sqrt(a * a + b * b - 2.0 * a * b * std::cos((after - before) * slice.bearingStep));
}

/// D_o of Eq. (3), by the range of the echo before.
double gapLimit(const ScanSlice& slice, int before, double angle, const Parameters& p)
{
    const double range = slice.ranges[static_cast<std::size_t>(before)];
    const double sigma = std::hypot(p.noise.rangeConstant, p.noise.rangeProportional * range);
    return range * std::sin(angle) / std::sin(p.segments.incidenceLimit - angle) + p.segments.breakpointSigmas * sigma;
}

/// The same where up to eight beams may be without echo, and no beams count as closer than 0.25°.
double bridgedLimit(const ScanSlice& slice, int before, int after, const Parameters& p)
{
    const int beams = after - before > 8 ? 1 : after - before;
    return gapLimit(slice, before, std::max(degrees(0.25), beams * slice.bearingStep), p);
}

/// Whether 1/ρ goes on in about the same slope in a gap and in one beside it, as on a wall that is met at a shallow
/// angle; `at` counts among the echoes.
bool goesOnBeside(const ScanSlice& slice, const std::vector<int>& echoes, std::size_t at)
{
    const auto slopeBefore = [&](std::size_t i) {
        const auto a = static_cast<std::size_t>(echoes[i - 1]);
        const auto b = static_cast<std::size_t>(echoes[i]);
        return (1.0 / slice.ranges[b] - 1.0 / slice.ranges[a]) / static_cast<double>(echoes[i] - echoes[i - 1]);
    };
    const auto isLike = [&](std::size_t other) {
        if (other < 1 || other >= echoes.size())
            return false;
        const double here = slopeBefore(at);
        const double there = slopeBefore(other);
        return here * there > 0.0 &&
               std::abs(here - there) < 0.51 * std::max(std::abs(here), std::abs(there));  // a half, but for rounding
    };
    return isLike(at - 1) || isLike(at + 1);
}

}  // namespace

/// What *Slice 2D* shows of runs, breakpoints and pieces, worked out anew from the raw ranges.
class ToldSlicesTest : public QObject {
    Q_OBJECT

private slots:
    void runsEndAtGapsAsWideAsTold_data() { scans(); }
    void runsEndAtGapsAsWideAsTold();
    void piecesHaveTheLengthAndPointsThatAreTold_data() { scans(); }
    void piecesHaveTheLengthAndPointsThatAreTold();

private:
    static void scans()
    {
        QTest::addColumn<QString>("preset");
        QTest::addColumn<QString>("scene");
        for (const char* preset : {"paper", "precise"}) {
            for (const char* scene : {"corridor", "office", "clutter", "hall", "hostile"})
                QTest::addRow("%s, %s", preset, scene) << preset << scene;
        }
    }
};

void ToldSlicesTest::runsEndAtGapsAsWideAsTold()
{
    QFETCH(QString, preset);
    QFETCH(QString, scene);
    const TracedScan traced(preset, scene);
    Recomputed recomputed;
    bool isRight = true;
    traced.visit(
        [&](const ToldPhase& phase, const ScanSlice& slice, const Parameters& parameters, const SliceTrace& trace) {
            const std::vector<int> echoes = beamsWithEcho(slice, traced.sensor);
            const auto check = [&](bool claim, int beam) {
                if (!claim)
                    qWarning("%s, beam %d", phase.text().c_str(), beam);
                isRight = isRight && claim;
            };
            check(trace.runs.size() == trace.breaks.size() + (echoes.empty() ? 0 : 1), 0);
            auto run = trace.runs.begin();
            auto told = trace.breaks.begin();
            int first = 0;
            for (std::size_t i = 0; i < echoes.size(); ++i) {
                const bool isLast = i + 1 == echoes.size();
                const int before = echoes[i];
                const int after = isLast ? before : echoes[i + 1];
                const bool isTold = told != trace.breaks.end() && told->before == before;
                const bool missing = traced.isPrecise ? after - before > 8 : after - before > 1;
                const double gap = gapBetween(slice, before, after);
                const double limit = traced.isPrecise ? bridgedLimit(slice, before, after, parameters)
                                                      : gapLimit(slice, before, slice.bearingStep, parameters);
                if (isTold) {
                    check(told->after == after && told->missing == missing, before);
                    check(missing || told->gap >= told->limit, before);
                    // Its ranges are floats: a micrometre of several metres.
                    const double tolerance = traced.isPrecise ? 1e-4 : 1e-9;
                    check(recomputed.agree(phase, "gap", told->gap, gap, tolerance), before);
                    check(recomputed.agree(phase, "limit", told->limit, limit, traced.isPrecise ? 1e-5 : 1e-9), before);
                    ++told;
                } else if (!isLast) {
                    const bool isBridged =
                        gap < limit * (1.0 + 1e-5) || (traced.isPrecise && goesOnBeside(slice, echoes, i + 1));
                    check(!missing && isBridged, before);
                }
                if (isTold || isLast) {
                    check(run != trace.runs.end() && run->firstBeam == echoes[static_cast<std::size_t>(first)] &&
                              run->lastBeam == before,
                          before);
                    check(recomputed.agree(phase, "run", run->points, static_cast<double>(i) + 1.0 - first), before);
                    first = static_cast<int>(i) + 1;
                    ++run;
                }
            }
        });
    QVERIFY(isRight);
    QVERIFY2(recomputed.counts["gap"] >= 20, qPrintable(QString::number(recomputed.counts["gap"])));
}

void ToldSlicesTest::piecesHaveTheLengthAndPointsThatAreTold()
{
    QFETCH(QString, preset);
    QFETCH(QString, scene);
    const TracedScan traced(preset, scene);
    Recomputed recomputed;
    // Of beams 0.5° apart the precise method asks for three points.
    const double fewest = traced.isPrecise ? 3.0 : 7.0;
    int whole = 0;
    bool isRight = true;
    traced.visit(
        [&](const ToldPhase& phase, const ScanSlice& slice, const Parameters& parameters, const SliceTrace& trace) {
            for (const TracedPiece& piece : trace.pieces) {
                const double length = (pointOf(slice, piece.firstBeam) - pointOf(slice, piece.lastBeam)).norm();
                const double echoes = echoesIn(slice, traced.sensor, piece.firstBeam, piece.lastBeam);
                isRight = isRight && recomputed.agree(phase, "length of a piece", piece.length, length);
                // Points far off the line of a kept piece may be left out: less than half of them.
                const bool isClipped =
                    traced.isPrecise && piece.segment >= 0 && piece.points < echoes && 2.0 * piece.points >= echoes;
                isRight = isRight && (isClipped || recomputed.agree(phase, "points of a piece", piece.points, echoes));
                whole += isClipped ? 0 : 1;
                for (const Test& test : piece.tests) {
                    if (test.name == "length")
                        isRight = isRight && recomputed.agree(phase, test, length, parameters.segments.minLength);
                    if (test.name == "points" && piece.segment >= 0)
                        isRight = isRight && test.pass() && test.value == piece.points &&
                                  recomputed.agree(phase, "limit of points", test.limit, fewest);
                }
            }
        });
    QVERIFY(isRight);
    QVERIFY2(recomputed.counts["limit of points"] > 100 && 10 * whole > 8 * recomputed.counts["length of a piece"],
             qPrintable(QString("%1, %2 of %3")
                            .arg(recomputed.counts["limit of points"])
                            .arg(whole)
                            .arg(recomputed.counts["length of a piece"])));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ToldSlicesTest)
#include "told_slices_test.moc"
