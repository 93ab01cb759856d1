// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

// What the covariance in a planes file means: the errors of the planes in that file, along the tangents in that file.

#include <cmath>
#include <sstream>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>

#include "core/formats/planes_csv.h"
#include "core/formats/planes_json.h"
#include "core/simulation/scene_builder.h"
#include "core/types/angle.h"
#include "simulated_room.h"
#include "tests/core/params/preset_parameters.h"
#include "tests/test_program.h"

using namespace planewright;

namespace {

/// A plane as a reader of the JSON knows it.
struct ReadPlane {
    Eigen::Vector3d normal;
    double distance = 0.0;
    double normalSigma = 0.0;  ///< [deg]
    double distanceSigma = 0.0;
    Eigen::Matrix3d covariance;
    Eigen::Matrix<double, 3, 2> tangents;
};

Eigen::Vector3d vectorOf(const QJsonArray& numbers)
{
    return {numbers[0].toDouble(), numbers[1].toDouble(), numbers[2].toDouble()};
}

std::vector<ReadPlane> throughJson(const Snapshot& found)
{
    std::ostringstream out;
    if (!writePlanesJson(out, planeResults(found), precise(), "test"))
        return {};
    std::vector<ReadPlane> planes;
    const QJsonDocument document = QJsonDocument::fromJson(QByteArray::fromStdString(out.str()));
    for (const QJsonValue& value : document.object()["planes"].toArray()) {
        const QJsonObject plane = value.toObject();
        ReadPlane read;
        read.normal = {plane["nx"].toDouble(), plane["ny"].toDouble(), plane["nz"].toDouble()};
        read.distance = plane["d"].toDouble();
        read.normalSigma = plane["sigma_normal_deg"].toDouble();
        read.distanceSigma = plane["sigma_d_m"].toDouble();
        for (int row = 0; row < 3; ++row)
            read.covariance.row(row) = vectorOf(plane["covariance"].toArray()[row].toArray());
        for (int i = 0; i < 2; ++i)
            read.tangents.col(i) = vectorOf(plane["tangents"].toArray()[i].toArray());
        planes.push_back(read);
    }
    return planes;
}

/// A free-standing surface and the scan of it: 100 slices of 241 beams, half a degree apart, that meet it or nothing.
SimulatedRoom scanOfOne(const Eigen::Vector3d& corner, const Eigen::Vector3d& edgeU, const Eigen::Vector3d& edgeV,
                        std::uint64_t seed)
{
    SceneBuilder builder("one surface");
    builder.rectangle("surface", corner, edgeU, edgeV);
    SimulatedRoom room{builder.build({}), {}};
    AcquisitionSettings settings;
    settings.firstTilt = degrees(20.0);
    settings.tiltStep = degrees(1.16);
    settings.slices = 100;
    settings.firstBearing = degrees(30.0);
    settings.bearingStep = degrees(0.5);
    settings.beams = 241;
    SimulationNoise noise = *simulationNoise("default");
    noise.mixedPixels = false;
    room.scan = simulate(room.scene, settings, noise, seed);
    return room;
}

}  // namespace

class ExportedCovarianceTest : public QObject {
    Q_OBJECT

private slots:
    void errorsAreAsLargeAsTheFileSays_data();
    void errorsAreAsLargeAsTheFileSays();
    void sigmasAreThoseOfTheCovariance();
    void tangentsAreOrthonormalWithTheNormal();
    void csvAndJsonSayTheSame();
};

void ExportedCovarianceTest::errorsAreAsLargeAsTheFileSays_data()
{
    QTest::addColumn<QVector<double>>("rectangle");

    QTest::newRow("oblique wall") << QVector<double>{3.5, 2.0, -1.0, -4.0, 3.0, 0.0, 0.0, 0.0, 2.5};
    QTest::newRow("floor") << QVector<double>{-1.5, 1.0, -1.0, 3.0, 0.0, 0.0, 0.0, 4.0, 0.0};
    QTest::newRow("leaning board") << QVector<double>{-1.0, 3.0, -0.8, 2.0, 0.3, 0.0, 0.1, 0.6, 1.5};
}

void ExportedCovarianceTest::errorsAreAsLargeAsTheFileSays()
{
    QFETCH(const QVector<double>, rectangle);
    const Eigen::Map<const Eigen::Matrix3d> columns(rectangle.constData());
    constexpr int kScans = 400;
    double sum = 0.0;
    Eigen::Vector3d squares = Eigen::Vector3d::Zero();
    for (std::uint64_t seed = 1; seed <= kScans; ++seed) {
        const SimulatedRoom room = scanOfOne(columns.col(0), columns.col(1), columns.col(2), seed);
        const std::vector<ReadPlane> planes = throughJson(*extracted(room.scan.recording, precise()));
        QCOMPARE(planes.size(), std::size_t(1));
        const ReadPlane& plane = planes.front();
        const TruePlane& truth = room.scene.planes.front();

        const double side = plane.normal.dot(truth.normal) < 0.0 ? -1.0 : 1.0;
        Eigen::Vector3d error;
        error.head<2>() = plane.tangents.transpose() * (plane.normal - side * truth.normal);
        error[2] = plane.distance - side * truth.distance;
        sum += error.dot(plane.covariance.inverse() * error);
        squares += error.cwiseAbs2().cwiseQuotient(plane.covariance.diagonal());
    }

    // A chi-square of three degrees of freedom has mean 3 and variance 6, and one of one degree mean 1 and variance 2:
    // means of 400 scatter by 0.122 and 0.071. Four of these are allowed.
    QVERIFY2(std::abs(sum / kScans - 3.0) < 4.0 * std::sqrt(6.0 / kScans), qPrintable(QString::number(sum / kScans)));
    for (int i = 0; i < 3; ++i)
        QVERIFY2(std::abs(squares[i] / kScans - 1.0) < 4.0 * std::sqrt(2.0 / kScans),
                 qPrintable(QString("%1: %2").arg(i).arg(squares[i] / kScans)));
}

void ExportedCovarianceTest::sigmasAreThoseOfTheCovariance()
{
    const SimulatedRoom room = scanOf("office", "default", 1);

    const std::vector<ReadPlane> planes = throughJson(*extracted(room.scan.recording, precise()));

    QVERIFY(planes.size() > 10);
    for (const ReadPlane& plane : planes) {
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> angles(plane.covariance.topLeftCorner<2, 2>());
        QVERIFY(plane.covariance.isApprox(plane.covariance.transpose(), 1e-8));
        QVERIFY(angles.eigenvalues()[0] > 0.0 && plane.covariance.determinant() > 0.0);
        // Nine significant digits of each, and the eigenvalue loses one or two.
        const double normalSigma = toDegrees(std::sqrt(angles.eigenvalues()[1]));
        QVERIFY(std::abs(plane.normalSigma - normalSigma) < 1e-6 * normalSigma);
        QVERIFY(std::abs(plane.distanceSigma - std::sqrt(plane.covariance(2, 2))) < 1e-8 * plane.distanceSigma);
    }
}

void ExportedCovarianceTest::tangentsAreOrthonormalWithTheNormal()
{
    const SimulatedRoom room = scanOf("office", "default", 1);

    for (const ReadPlane& plane : throughJson(*extracted(room.scan.recording, precise()))) {
        QVERIFY((plane.tangents.transpose() * plane.tangents).isIdentity(1e-8));
        QVERIFY((plane.tangents.transpose() * plane.normal).norm() < 1e-8);
    }
}

void ExportedCovarianceTest::csvAndJsonSayTheSame()
{
    const SimulatedRoom room = scanOf("hall", "default", 1);
    const auto found = extracted(room.scan.recording, precise());
    const std::vector<ReadPlane> planes = throughJson(*found);

    std::ostringstream out;
    QVERIFY(writePlanesCsv(out, planeResults(*found)));

    const QStringList lines = QString::fromStdString(out.str()).split('\n', Qt::SkipEmptyParts);
    const QStringList columns = lines[1].split(',');
    QCOMPARE(static_cast<std::size_t>(lines.size()), planes.size() + 2);
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const QStringList cells = lines[static_cast<qsizetype>(i) + 2].split(',');
        QCOMPARE(cells[columns.indexOf("sigma_normal_deg")].toDouble(), planes[i].normalSigma);
        QCOMPARE(cells[columns.indexOf("sigma_d_m")].toDouble(), planes[i].distanceSigma);
    }
}

PLANEWRIGHT_TEST(ExportedCovarianceTest)
#include "exported_covariance_test.moc"
