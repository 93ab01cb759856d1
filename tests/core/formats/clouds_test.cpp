// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <bit>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include <QtTest>

#include "core/formats/cloud_pcd.h"
#include "core/formats/cloud_ptx.h"
#include "core/formats/cloud_recording.h"
#include "core/formats/cloud_uos.h"
#include "core/formats/little_endian.h"
#include "core/formats/lzf.h"
#include "core/formats/recording_csv.h"
#include "core/types/angle.h"
#include "tests/test_program.h"

namespace planewright {

namespace {

using Points = std::vector<Eigen::Vector3d>;

/// Four rows of five columns on a wall 2 m ahead of a depth camera (x right, y down, z ahead), one without a return.
Points cameraPoints()
{
    Points points;
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 5; ++column)
            points.emplace_back(0.5 * (column - 2), 0.5 * (row - 1.5), 2.0);
    }
    points[7].setConstant(std::nan(""));
    return points;
}

std::string pcdHeader(const std::string& data, const std::string& viewpoint = "0 0 0 1 0 0 0")
{
    return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS label x y z\nSIZE 2 4 8 4\nTYPE U F F F\n"
           "COUNT 2 1 1 1\nWIDTH 5\nHEIGHT 4\nVIEWPOINT " +
           viewpoint + "\nPOINTS 20\nDATA " + data + "\n";
}

/// Appends a field of a point: two labels, x and z as floats, y as a double.
void appendField(std::string& bytes, int field, const Eigen::Vector3d& point)
{
    if (field == 0) {
        appendLittleEndian(bytes, std::uint16_t{7});
        appendLittleEndian(bytes, std::uint16_t{8});
    } else if (field == 2) {
        appendLittleEndian(bytes, point.y());
    } else {
        appendLittleEndian(bytes, static_cast<float>(field == 1 ? point.x() : point.z()));
    }
}

std::string asciiPcd(const Points& points)
{
    std::ostringstream text;
    for (const Eigen::Vector3d& point : points)
        text << "7 8 " << point.x() << ' ' << point.y() << ' ' << point.z() << '\n';
    return pcdHeader("ascii") + text.str();
}

std::string binaryPcd(const Points& points)
{
    std::string bytes = pcdHeader("binary");
    for (const Eigen::Vector3d& point : points) {
        for (int field = 0; field < 4; ++field)
            appendField(bytes, field, point);
    }
    return bytes;
}

/// LZF of plain runs alone.
std::string compressedPcd(const Points& points)
{
    std::string plain;
    for (int field = 0; field < 4; ++field) {
        for (const Eigen::Vector3d& point : points)
            appendField(plain, field, point);
    }
    std::string packed;
    for (std::size_t at = 0; at < plain.size(); at += 32) {
        const std::string run = plain.substr(at, 32);
        packed += static_cast<char>(run.size() - 1);
        packed += run;
    }
    std::string bytes = pcdHeader("binary_compressed");
    appendLittleEndian(bytes, static_cast<std::uint32_t>(packed.size()));
    appendLittleEndian(bytes, static_cast<std::uint32_t>(plain.size()));
    return bytes + packed;
}

Result<CloudScan> readPcd(const std::string& bytes)
{
    std::istringstream in(bytes);
    return readCloudPcd(in, "a.pcd");
}

/// A published scan of nine points (LAStools, "Matrix transformation in LAStools").
const std::string kPublishedPtx =
    "3\n3\n0.000000 0.000000 0.000000\n1.000000 0.000000 0.000000\n0.000000 1.000000 0.000000\n"
    "0.000000 0.000000 1.000000\n-0.955179 0.296021 -0.002106 0.000000\n-0.296023 -0.955180 0.001152 0.000000\n"
    "-0.001670 0.001724 0.999997 0.000000\n3.847211 12.235314 -0.425777 1.000000\n"
    "1.111111 2.111111 3.111 0.111\n1.222222 2.222222 3.222 0.212\n0 0 0 0\n0 0 0 0 \n"
    "1.333333 2.333333 3.333 0.312\n1.444444 2.444444 3.444 0.423\n0 0 0 0\n1.555555 2.555555 3.555 0.534\n"
    "1.666666 2.666666 3.666 0.678\n";

}  // namespace

class CloudsTest : public QObject {
    Q_OBJECT

private slots:
    void aPcdIsTheSameInAllThreeEncodings();
    void aCameraIsTurnedToYAheadAndZUp();
    void aViewpointIsThePlaceOfTheScanner();
    void lzfCopiesReachIntoWhatTheyMake();
    void aPtxIsPlacedAsPublished();
    void theSecondScanOfAPtxIsReadToo();
    void aUosPoseIsRightHandedInOurFrame();
    void whatIsRecoveredIsTold();
    void pointsOffTheScannerAreLeftOut();
    void aRecordingOfACloudComesBackAsItWas();
    void geometryThatIsWrongIsNamed_data();
    void geometryThatIsWrongIsNamed();
    void theOfficeIsRecoveredToTheRoundingOfItsRanges();
};

void CloudsTest::aPcdIsTheSameInAllThreeEncodings()
{
    const Points points = cameraPoints();
    for (const std::string& bytes : {asciiPcd(points), binaryPcd(points), compressedPcd(points)}) {
        const auto cloud = readPcd(bytes);

        QVERIFY2(cloud, cloud ? "" : cloud.error().message.c_str());
        QCOMPARE(cloud->beams, 5);
        QCOMPARE(cloud->slices.size(), std::size_t(4));
        QCOMPARE(cloud->slices[0].size(), std::size_t(5));
        QCOMPARE(cloud->slices[1].size(), std::size_t(4));
        QCOMPARE(cloud->slices[1][2].beam, 3);
        QVERIFY(cloud->slices[1][2].place.isApprox(Eigen::Vector3f(0.5F, 2.0F, 0.25F), 1e-6F));
        QVERIFY(!cloud->pose);
    }
}

void CloudsTest::aCameraIsTurnedToYAheadAndZUp()
{
    Points upright = cameraPoints();
    for (Eigen::Vector3d& point : upright)
        point = {point.x(), point.z(), -point.y()};

    const auto turned = readPcd(asciiPcd(cameraPoints()));
    const auto asItIs = readPcd(asciiPcd(upright));

    QVERIFY(turned && asItIs);
    QCOMPARE(turned->notes.size(), std::size_t(1));
    QVERIFY(asItIs->notes.empty());
    for (std::size_t row = 0; row < 4; ++row) {
        for (std::size_t k = 0; k < turned->slices[row].size(); ++k)
            QCOMPARE((turned->slices[row][k].place - asItIs->slices[row][k].place).norm(), 0.0F);
    }
}

void CloudsTest::aViewpointIsThePlaceOfTheScanner()
{
    Points moved = cameraPoints();
    for (Eigen::Vector3d& point : moved)
        point += Eigen::Vector3d{1.0, 2.0, 3.0};
    std::string bytes = asciiPcd(moved);
    bytes.replace(bytes.find("0 0 0 1 0 0 0"), 5, "1 2 3");

    const auto cloud = readPcd(bytes);

    QVERIFY(cloud && cloud->pose);
    QVERIFY(cloud->slices[1][2].place.isApprox(Eigen::Vector3f(0.5F, 2.0F, 0.25F), 1e-6F));
    // Back to where the file has it: (0.5, -0.25, 2) from the viewpoint.
    QVERIFY((*cloud->pose * Eigen::Vector3d(0.5, 2.0, 0.25)).isApprox(Eigen::Vector3d(1.5, 1.75, 5.0), 1e-9));
}

void CloudsTest::lzfCopiesReachIntoWhatTheyMake()
{
    std::string plain;

    // "ab", then 5 from 2 back; then a long copy of 7 + 2 + 4 from 7 back.
    const bool done = decompressLzf(std::string_view{"\x01\x61\x62\x60\x01\xE0\x04\x06", 8}, 20, plain);

    QVERIFY(done);
    QCOMPARE(plain, std::string("abababaabababaababab"));
}

void CloudsTest::aPtxIsPlacedAsPublished()
{
    std::istringstream in(kPublishedPtx);

    const auto cloud = readCloudPtx(in, "sample.ptx", 0);

    QVERIFY2(cloud, cloud ? "" : cloud.error().message.c_str());
    QCOMPARE(cloud->beams, 3);
    QCOMPARE(cloud->slices.size(), std::size_t(3));
    QCOMPARE(cloud->slices[1].front().beam, 1);
    const Points published{{2.156, 10.553, 2.685}, {2.017, 10.480, 2.796}, {1.877, 10.407, 2.907},
                           {1.738, 10.334, 3.018}, {1.599, 10.261, 3.129}, {1.460, 10.188, 3.240}};
    Points found;
    for (const CloudSlice& slice : cloud->slices) {
        for (const CloudPoint& point : slice)
            found.push_back(*cloud->pose * point.place.cast<double>());
    }
    QCOMPARE(found.size(), published.size());
    for (std::size_t i = 0; i < found.size(); ++i)
        QVERIFY((found[i] - published[i]).cwiseAbs().maxCoeff() < 0.0006);
}

void CloudsTest::theSecondScanOfAPtxIsReadToo()
{
    std::string second = kPublishedPtx;
    second.replace(second.find("3.847211"), 8, "5.847211");
    const std::string text = kPublishedPtx + "\n" + second;
    std::istringstream counted(text);
    std::istringstream in(text);
    std::istringstream beyond(text);

    const auto scans = scansOfPtx(counted, "two.ptx");
    const auto cloud = readCloudPtx(in, "two.ptx", 1);
    const auto none = readCloudPtx(beyond, "two.ptx", 2);

    QVERIFY(scans);
    QCOMPARE(*scans, 2);
    QVERIFY(cloud);
    QCOMPARE(cloud->pose->translation.x(), 5.847211);
    QVERIFY(!none);
    QCOMPARE(none.error().code, ErrorCode::Usage);
}

void CloudsTest::aUosPoseIsRightHandedInOurFrame()
{
    // In 3DTK's frame (x right, y up, z ahead, left-handed) a turn of 90° about y takes what is ahead to the right.
    std::istringstream in("100 200 300\n0 90 0\n");

    const auto pose = readPoseUos(in, "scan000.pose");

    QVERIFY(pose);
    QVERIFY(pose->translation.isApprox(Eigen::Vector3d(1.0, 3.0, 2.0), 1e-12));
    QVERIFY((pose->rotation * Eigen::Vector3d::UnitY()).isApprox(Eigen::Vector3d::UnitX(), 1e-12));
    QVERIFY((pose->rotation * Eigen::Vector3d::UnitZ()).isApprox(Eigen::Vector3d::UnitZ(), 1e-12));

    // R = Rx Ry Rz of 3DTK, entry by entry, against ours: R' = S R S with y and z exchanged.
    std::istringstream all("0 0 0 10 -20 30");
    const auto turned = readPoseUos(all, "scan001.pose");
    QVERIFY(turned);
    const double sx = std::sin(degrees(10.0)), cx = std::cos(degrees(10.0));
    const double sy = std::sin(degrees(-20.0)), cy = std::cos(degrees(-20.0));
    const double sz = std::sin(degrees(30.0)), cz = std::cos(degrees(30.0));
    Eigen::Matrix3d theirs;
    theirs << cy * cz, -cy * sz, sy, sx * sy * cz + cx * sz, -sx * sy * sz + cx * cz, -sx * cy, -cx * sy * cz + sx * sz,
        cx * sy * sz + sx * cz, cx * cy;
    Eigen::Matrix3d swap;
    swap << 1, 0, 0, 0, 0, 1, 0, 1, 0;
    QVERIFY((turned->rotation.toRotationMatrix() - swap * theirs * swap).cwiseAbs().maxCoeff() < 1e-12);
}

void CloudsTest::whatIsRecoveredIsTold()
{
    auto cloud = readPcd(asciiPcd(cameraPoints()));
    QVERIFY(cloud);

    const auto made = recordingOf(std::move(*cloud), "a.pcd");

    QVERIFY2(made, made ? "" : made.error().message.c_str());
    QCOMPARE(made->points, std::size_t(19));
    QCOMPARE(made->pointsLeftOut, std::size_t(0));
    // Nothing but the rounding of ranges to whole millimetres is lost.
    QVERIFY(made->largestOff <= 0.5005e-3);
    const auto& extra = made->recording.description.extra;
    QCOMPARE(extra.size(), std::size_t(5));
    QCOMPARE(extra[0].first, std::string("recovered_axis"));
    QCOMPARE(extra[0].second, std::string("-1 0 0"));
    QCOMPARE(extra[1].second, std::string("of a flat image"));
    QCOMPARE(extra[4].first, std::string("recovered_note"));
}

void CloudsTest::pointsOffTheScannerAreLeftOut()
{
    CloudScan cloud;
    cloud.beams = 101;
    for (int i = 0; i < 30; ++i) {
        CloudSlice& slice = cloud.slices.emplace_back();
        for (int k = 0; k < 101; ++k) {
            const double bearing = degrees(40.0 + k);
            const double tilt = degrees(60.0 + 2.0 * i);
            slice.push_back({Eigen::Vector3d(2.0 * std::cos(bearing), 2.0 * std::sin(bearing) * std::sin(tilt),
                                             -2.0 * std::sin(bearing) * std::cos(tilt))
                                 .cast<float>(),
                             k});
        }
    }
    CloudScan worse = cloud;
    // 2 m away, 10 mm are five times the tolerance.
    cloud.slices[10][50].place.z() += 0.01F;
    for (std::size_t i = 10; i < 14; ++i)
        worse.slices[i][50].place.z() += 0.01F;

    const auto one = recordingOf(std::move(cloud), "a.pcd");
    const auto four = recordingOf(std::move(worse), "a.pcd");

    // One of 3030 is less than one in a thousand, four are more.
    QVERIFY2(one, one ? "" : one.error().message.c_str());
    QCOMPARE(one->pointsLeftOut, std::size_t(1));
    QCOMPARE(one->recording.slices[10].ranges[50], 0.0);
    QVERIFY(!four);
    QCOMPARE(four.error().code, ErrorCode::Unreadable);
}

void CloudsTest::theOfficeIsRecoveredToTheRoundingOfItsRanges()
{
    const QString path = qEnvironmentVariable("PLANEWRIGHT_TEST_DATA") + "/pcl/office1.pcd";
    if (!QFile::exists(path))
        QSKIP("office1.pcd is not here; PLANEWRIGHT_TEST_DATA names the folder of the test data");
    std::ifstream in(path.toStdString(), std::ios::binary);

    auto cloud = readCloudPcd(in, "office1.pcd");
    QVERIFY2(cloud, cloud ? "" : cloud.error().message.c_str());
    QCOMPARE(cloud->beams, 640);
    QCOMPARE(cloud->slices.size(), std::size_t(480));
    const auto made = recordingOf(std::move(*cloud), "office1.pcd");

    QVERIFY2(made, made ? "" : made.error().message.c_str());
    QCOMPARE(made->pointsLeftOut, std::size_t(0));
    QVERIFY(made->largestOff <= 0.51e-3);
    // An even spread over a millimetre: its root mean square is 1/√12 mm.
    QVERIFY(std::abs(made->rmsOff - 1e-3 / std::sqrt(12.0)) < 2e-6);
    const auto table = made->recording.description.beamTable;
    QVERIFY(table && table->imageTilt);
    QCOMPARE(made->recording.description.scanner, std::string("depth camera, PCD cloud"));
}

void CloudsTest::aRecordingOfACloudComesBackAsItWas()
{
    auto cloud = readPcd(asciiPcd(cameraPoints()));
    QVERIFY(cloud);
    const auto made = recordingOf(std::move(*cloud), "a.pcd");
    QVERIFY(made);
    std::stringstream text;

    QVERIFY(writeRecordingCsv(text, made->recording, false));
    const auto read = readRecordingCsv(text, "a.csv");

    QVERIFY2(read, read ? "" : read.error().message.c_str());
    QCOMPARE(read->warnings.size(), std::size_t(0));
    const Recording& back = read->recording;
    QVERIFY(back.description.firstBearing == made->recording.description.firstBearing);
    QVERIFY(back.description.bearingStep == made->recording.description.bearingStep);
    QVERIFY(back.description.attitude.coeffs() == made->recording.description.attitude.coeffs());
    QVERIFY(back.description.extra == made->recording.description.extra);
    QVERIFY(back.description.beamTable->bearings == made->recording.description.beamTable->bearings);
    QVERIFY(back.description.beamTable->imageTilt == made->recording.description.beamTable->imageTilt);
    QCOMPARE(back.slices.size(), made->recording.slices.size());
    for (std::size_t i = 0; i < back.slices.size(); ++i) {
        QVERIFY(back.slices[i].tilt == made->recording.slices[i].tilt);
        QVERIFY(back.slices[i].ranges == made->recording.slices[i].ranges);
        QVERIFY(*back.slices[i].bearings == *made->recording.slices[i].bearings);
    }
}

void CloudsTest::geometryThatIsWrongIsNamed_data()
{
    QTest::addColumn<QByteArray>("key");
    QTest::addColumn<QByteArray>("message");
    QTest::newRow("too few bearings") << QByteArray("beam_bearings_deg = 10 20")
                                      << QByteArray(
                                             "beam_bearings_deg is no list of rising angles from -360 to 360, "
                                             "one for each of the 3 beams");
    QTest::newRow("falling bearings") << QByteArray("beam_bearings_deg = 10 30 20")
                                      << QByteArray(
                                             "beam_bearings_deg is no list of rising angles from -360 to 360, "
                                             "one for each of the 3 beams");
    QTest::newRow("a word") << QByteArray("beam_bearings_deg = 10 x 20")
                            << QByteArray(
                                   "beam_bearings_deg is no list of rising angles from -360 to 360, one for "
                                   "each of the 3 beams");
    QTest::newRow("an image without bearings")
        << QByteArray("beam_image_pitch_deg = 90")
        << QByteArray("beam_image_pitch_deg is of no use without beam_bearings_deg");
    QTest::newRow("an image that looks behind itself")
        << QByteArray("beam_bearings_deg = -10 20 30\n# beam_image_pitch_deg = 90")
        << QByteArray("beam_bearings_deg of an image are between 0 and 180 degrees");
    QTest::newRow("no unit quaternion") << QByteArray("frame_quaternion = 1 1 0 0")
                                        << QByteArray("frame_quaternion is no unit quaternion w x y z");
    QTest::newRow("three numbers") << QByteArray("frame_quaternion = 1 0 0")
                                   << QByteArray("frame_quaternion is no unit quaternion w x y z");
}

void CloudsTest::geometryThatIsWrongIsNamed()
{
    QFETCH(QByteArray, key);
    QFETCH(QByteArray, message);
    std::istringstream in("# " + key.toStdString() +
                          "\n# format = nodding-laser-csv 1\n# bearing_start_deg = 0\n# bearing_step_deg = 1\n"
                          "# beams = 3\n# range_min_m = 0\n# range_max_m = 30\n# pitch_axis_offset_m = 0\n"
                          "slice,time_s,pitch_deg,r0,r1,r2\n0,0,90,1,2,3\n");

    const auto read = readRecordingCsv(in, "a.csv");

    QVERIFY(!read);
    QVERIFY2(read.error().message.ends_with("in the header above " + message.toStdString() + "; correct or remove it"),
             read.error().message.c_str());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::CloudsTest)
#include "clouds_test.moc"
