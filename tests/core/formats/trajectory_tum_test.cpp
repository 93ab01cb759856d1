// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/trajectory_tum.h"

#include <sstream>

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class TrajectoryTumTest : public QObject {
    Q_OBJECT

private slots:
    void aTrajectoryComesBackAsItWas();
    void commentsAndBlanksArePassedOver();
    void whatIsWrongIsNamed_data();
    void whatIsWrongIsNamed();
};

void TrajectoryTumTest::aTrajectoryComesBackAsItWas()
{
    // A half turn about z, given with qw < 0.
    const std::vector<StampedPose> poses{{0.0, {}}, {1.5, {{-0.6, 0.0, 0.0, 0.8}, {1.25, -2.0, 0.001}}}};
    std::ostringstream out;

    QVERIFY(writeTrajectoryTum(out, poses));

    QCOMPARE(out.str(), std::string("# timestamp tx ty tz qx qy qz qw\n"
                                    "0 0 0 0 0 0 0 1\n"
                                    "1.5 1.25 -2 0.001 0 0 -0.8 0.6\n"));
    std::istringstream in(out.str());
    const auto read = readTrajectoryTum(in, "a.txt");
    QVERIFY(read);
    QCOMPARE(read->size(), std::size_t(2));
    QCOMPARE((*read)[1].time, 1.5);
    QVERIFY((*read)[1].pose.translation == Eigen::Vector3d(1.25, -2.0, 0.001));
    QVERIFY((*read)[1].pose.rotation.isApprox(Eigen::Quaterniond(0.6, 0.0, 0.0, -0.8), 1e-12));
}

void TrajectoryTumTest::commentsAndBlanksArePassedOver()
{
    std::istringstream in("# by hand\r\n\n  7\t1 2 3   0 0 0 1.0005\r\n# end");

    const auto read = readTrajectoryTum(in, "a.txt");

    QVERIFY(read);
    QCOMPARE(read->size(), std::size_t(1));
    QVERIFY(std::abs(read->front().pose.rotation.norm() - 1.0) < 1e-15);
}

void TrajectoryTumTest::whatIsWrongIsNamed_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("message");
    const auto row = [](const char* name, const char* text, const char* message) {
        QTest::newRow(name) << QByteArray(text) << QByteArray(message);
    };
    row("nothing", "", "p.txt: there is no pose in it; a line has timestamp tx ty tz qx qy qz qw");
    row("only comments", "# a\n", "p.txt: there is no pose in it; a line has timestamp tx ty tz qx qy qz qw");
    row("short", "0 0 0 0 0 0 0\n", "p.txt: line 1: qw is missing; a line has timestamp tx ty tz qx qy qz qw");
    row("long", "0 0 0 0 0 0 0 1 5\n", "p.txt: line 1: more than the 8 values timestamp tx ty tz qx qy qz qw");
    row("word", "# x\n0 1 two 0 0 0 0 1\n", "p.txt: line 2: ty is 'two', which is no number within its limits");
    row("comma", "0 0,5 0 0 0 0 0 1\n", "p.txt: line 1: tx is '0,5', which is no number within its limits");
    row("infinite", "0 inf 0 0 0 0 0 1\n", "p.txt: line 1: tx is 'inf', which is no number within its limits");
    row("not a number", "0 0 0 nan 0 0 0 1\n", "p.txt: line 1: tz is 'nan', which is no number within its limits");
    row("far", "0 0 2e9 0 0 0 0 1\n", "p.txt: line 1: ty is '2e9', which is no number within its limits");
    row("quaternion", "0 0 0 0 0 0 0 0\n", "p.txt: line 1: the quaternion qx qy qz qw is not of length 1; correct it");
    row("backwards", "2 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n",
        "p.txt: line 2: the time runs backwards; put the poses in their order");
}

void TrajectoryTumTest::whatIsWrongIsNamed()
{
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, message);
    std::istringstream in(text.toStdString());

    const auto read = readTrajectoryTum(in, "p.txt");

    QVERIFY(!read);
    QVERIFY(read.error().code == ErrorCode::Unreadable);
    QCOMPARE(QByteArray::fromStdString(read.error().message), message);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::TrajectoryTumTest)
#include "trajectory_tum_test.moc"
