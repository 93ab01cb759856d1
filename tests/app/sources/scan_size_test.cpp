// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/sources/scan_size.h"

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class ScanSizeTest : public QObject {
    Q_OBJECT

private slots:
    void pointsAndTimeAreTold_data();
    void pointsAndTimeAreTold();
};

void ScanSizeTest::pointsAndTimeAreTold_data()
{
    QTest::addColumn<int>("slices");
    QTest::addColumn<int>("beams");
    QTest::addColumn<double>("seconds");
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("Table VIII") << 137 << 721 << 3.425
                                << QByteArray("137 slices of 721 beams, 98,777 points, about 3.4 s");
    QTest::newRow("one") << 1 << 1081 << 0.025 << QByteArray("1 slice of 1,081 beams, 1,081 points, about 0.0 s");
    QTest::newRow("long") << 65536 << 1081 << 1638.4
                          << QByteArray("65,536 slices of 1,081 beams, 70,844,416 points, about 27.3 min");
}

void ScanSizeTest::pointsAndTimeAreTold()
{
    QFETCH(int, slices);
    QFETCH(int, beams);
    QFETCH(double, seconds);
    QFETCH(QByteArray, text);
    FittedPlan plan;
    plan.beams = beams;
    plan.points = static_cast<double>(slices) * beams;
    plan.time = std::chrono::duration<double>{seconds};

    QCOMPARE(QByteArray::fromStdString(scanSizeText(plan, slices)), text);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ScanSizeTest)
#include "scan_size_test.moc"
