// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/floor_plan_svg.h"

#include <cmath>
#include <sstream>

#include <QRegularExpression>
#include <QXmlStreamReader>
#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class FloorPlanSvgTest : public QObject {
    Q_OBJECT

private slots:
    void aWallIsAsLongAsTheScaleSays_data();
    void aWallIsAsLongAsTheScaleSays();
    void stopsCarryTheirNumbers();
    void withoutAnythingItIsAnEmptyPlan();
};

namespace {

/// A wall of 10 m along x at y = 4, from the floor to 2.5 m.
PlaneResult wallOfTenMetres()
{
    auto plane = std::make_shared<Plane>();
    plane->normal = Eigen::Vector3d::UnitY();
    plane->distance = 4.0;
    PlaneResult wall;
    wall.plane = plane;
    wall.className = "wall";
    wall.outline.parts = {{{{-3.0, 4.0, 0.0}, {7.0, 4.0, 0.0}, {7.0, 4.0, 2.5}, {-3.0, 4.0, 2.5}}, {}}};
    wall.outline.area = 25.0;
    return wall;
}

QString drawn(std::span<const PlaneResult> planes, double scale, std::span<const PlanStop> stops = {})
{
    std::ostringstream out;
    if (!writeFloorPlanSvg(out, planes, 1.0, scale, stops))
        qFatal("The plan could not be written.");
    return QString::fromStdString(out.str());
}

bool isXml(const QString& text)
{
    QXmlStreamReader reader(text);
    while (!reader.atEnd())
        reader.readNext();
    return !reader.hasError();
}

}  // namespace

void FloorPlanSvgTest::aWallIsAsLongAsTheScaleSays_data()
{
    QTest::addColumn<double>("scale");
    QTest::addColumn<double>("millimetres");
    QTest::newRow("1:100") << 100.0 << 100.0;
    QTest::newRow("1:50") << 50.0 << 200.0;
    QTest::newRow("1:1000") << 1000.0 << 10.0;
}

void FloorPlanSvgTest::aWallIsAsLongAsTheScaleSays()
{
    QFETCH(double, scale);
    QFETCH(double, millimetres);
    const std::vector<PlaneResult> planes{wallOfTenMetres()};

    const QString plan = drawn(planes, scale);

    QVERIFY(isXml(plan));
    const QRegularExpression headPattern(R"re(viewBox="0 0 ([0-9.]+) [0-9.]+" width="([0-9.]+)mm")re");
    const QRegularExpression wallPattern(R"re(class="wall cut" d="M([0-9.]+) ([0-9.]+)L([0-9.]+) ([0-9.]+)")re");
    const auto head = headPattern.match(plan);
    QVERIFY(head.hasMatch());
    const double unit = head.captured(2).toDouble() / head.captured(1).toDouble();  // [mm]
    const auto wall = wallPattern.match(plan);
    QVERIFY(wall.hasMatch());
    const double length = std::hypot(wall.captured(3).toDouble() - wall.captured(1).toDouble(),
                                     wall.captured(4).toDouble() - wall.captured(2).toDouble());
    QVERIFY2(std::abs(unit * length - millimetres) < 0.01, qPrintable(plan));
}

void FloorPlanSvgTest::stopsCarryTheirNumbers()
{
    const std::vector<PlaneResult> planes{wallOfTenMetres()};
    const std::vector<PlanStop> stops{{{0.0, 0.0}, 0}, {{2.0, -3.0}, 7}};

    const QString plan = drawn(planes, 100.0, stops);

    QCOMPARE(plan.count("class=\"stop\""), 2);
    QVERIFY(plan.contains(">0</text>") && plan.contains(">7</text>"));
    QVERIFY(plan.contains("<title>Plan 1:100</title>"));
}

void FloorPlanSvgTest::withoutAnythingItIsAnEmptyPlan()
{
    const QString plan = drawn({}, 100.0);

    QVERIFY(isXml(plan));
    QVERIFY(!plan.contains("cut\" d="));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::FloorPlanSvgTest)
#include "floor_plan_svg_test.moc"
