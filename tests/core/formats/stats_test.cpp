// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/stats.h"

#include <sstream>

#include <QtTest>

#include "core/types/angle.h"
#include "tests/test_program.h"

using namespace planewright;
using namespace std::chrono_literals;

class StatsTest : public QObject {
    Q_OBJECT

private slots:
    void writesEveryKeyInOrder();
    void aFullDiskIsNotSilent();
};

void StatsTest::writesEveryKeyInOrder()
{
    Stats stats;
    stats.points = 98777;
    stats.returns = 98000;
    stats.segments = 1508;
    stats.fitted = 1400;
    stats.unfitted = 108;
    stats.planes = 35;
    stats.splits = 3;
    stats.merges = 2;
    stats.meanError = 0.39;
    stats.dataAccessRatio = 2.0 * 1508 / 98777 * 100.0;
    stats.noise = {0.008, 0.0015, degrees(0.125), true};
    stats.total = 12500us;
    stats.phases = {1us, 2us, 3us, 4us, 5us, 6us, 7us};
    stats.stepMedian = 91234ns;
    stats.step99 = 800us;
    stats.stepMax = 1ms;
    stats.repeats = 9;
    std::ostringstream out;

    QVERIFY(writeStats(out, stats).has_value());

    // 2 · 1508 / 98777 = 3.05334238 %
    QCOMPARE(
        out.str(),
        std::string(R"({"format":"planewright-stats 1","points":98777,"returns":98000,"segments":1508,)"
                    R"("fitted":1400,"unfitted":108,"planes":35,"splits":3,"merges":2,"mean_error":0.39,)"
                    R"("dar_percent":3.05334238,"noise":{"range_constant_m":0.008,"range_proportional":0.0015,)"
                    R"("pitch_deg":0.125,"estimated":true},"time_ms":{"total":12.5,"extract":0.001,"assign":0.002,)"
                    R"("cluster":0.003,"fit":0.004,"split_merge":0.005,"remaining":0.006,"finish":0.007},)"
                    R"("step_ms":{"p50":0.091234,"p99":0.8,"max":1},"repeats":9})"
                    "\n"));
}

void StatsTest::aFullDiskIsNotSilent()
{
    std::ostringstream out;
    out.setstate(std::ios::badbit);

    QCOMPARE(writeStats(out, {}).error().code, ErrorCode::NotWritten);
}

PLANEWRIGHT_TEST(StatsTest)
#include "stats_test.moc"
