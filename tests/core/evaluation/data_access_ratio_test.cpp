// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/evaluation/data_access_ratio.h"

#include <cmath>

#include <QTest>

#include "tests/test_program.h"

using namespace planewright;

class DataAccessRatioTest : public QObject {
    Q_OBJECT

private slots:
    void givesTheFiguresOfTableIX_data();
    void givesTheFiguresOfTableIX();
    void isZeroForAScanWithoutPoints();
};

void DataAccessRatioTest::givesTheFiguresOfTableIX_data()
{
    QTest::addColumn<int>("segments");
    QTest::addColumn<double>("printed");
    QTest::newRow("scan 5") << 652 << 1.32;
    QTest::newRow("scan 13") << 920 << 1.86;
    QTest::newRow("scan 39") << 1000 << 2.02;
    QTest::newRow("scan 63") << 1941 << 3.93;
}

void DataAccessRatioTest::givesTheFiguresOfTableIX()
{
    QFETCH(int, segments);
    QFETCH(double, printed);

    const double ratio = dataAccessRatio(static_cast<std::size_t>(segments), 137 * 721);

    QVERIFY(std::abs(ratio - printed) < 0.005);
}

void DataAccessRatioTest::isZeroForAScanWithoutPoints()
{
    QCOMPARE(dataAccessRatio(0, 0), 0.0);
}

PLANEWRIGHT_TEST(DataAccessRatioTest)
#include "data_access_ratio_test.moc"
