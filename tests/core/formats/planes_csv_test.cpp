// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/planes_csv.h"

#include <clocale>
#include <locale>
#include <sstream>

#include <QtTest>

#include "sample_planes.h"
#include "tests/test_program.h"

using namespace planewright;

namespace {

constexpr const char* kHead =
    "# format = planewright-planes 1\n"
    "id,nx,ny,nz,d,segments,points,error,rms_m,area_m2,width_m,height_m,cx,cy,cz,sigma_normal_deg,sigma_d_m,born_step,"
    "changed_step,lineage,polygon_wkt,name,class\n";

std::string textOf(const std::vector<PlaneResult>& planes)
{
    std::ostringstream out;
    const auto done = writePlanesCsv(out, planes);
    return done ? out.str() : done.error().message;
}

Result<std::vector<PlaneRecord>> readPlanesText(const std::string& text)
{
    std::istringstream in(text);
    return readPlanesCsv(in, "p.csv");
}

/// A text as a gzip stream of one stored block (RFC 1951, 3.2.4), its checksum cut off.
QByteArray gzipWithoutEnd(const QByteArray& text)
{
    const auto length = static_cast<unsigned>(text.size());
    QByteArray bytes("\x1F\x8B\x08\0\0\0\0\0\0\xFF\x01", 11);
    for (const unsigned value : {length, ~length})
        bytes += QByteArray(1, static_cast<char>(value & 0xFF)) + QByteArray(1, static_cast<char>(value >> 8 & 0xFF));
    return bytes + text;
}

}  // namespace

class PlanesCsvTest : public QObject {
    Q_OBJECT

private slots:
    void writesEveryColumn();
    void leavesEmptyWhatIsUnknown();
    void keepsFormulasOut_data();
    void keepsFormulasOut();
    void writesTheSameInEveryLocale();
    void givesTheOutlinesOfASnapshot();
    void readsBackWhatWasWritten();
    void readsFilesWrittenByHand();
    void refusesWhatIsNoPlanesFile_data();
    void refusesWhatIsNoPlanesFile();
    void refusesAQuoteThatNeverEnds();
    void refusesAFullDisk();
};

void PlanesCsvTest::writesEveryColumn()
{
    QCOMPARE(
        QString::fromStdString(textOf({sampleCeiling(), sampleWall()})),
        QString(kHead) +
            "3,0,0,1,1.25,2,60,0.5,0.004,11,4,3,2.04545455,1.5,1.25,0.5,0.002,4,6,merge:1+2,\"POLYGON Z ((0 0 1.25, "
            "4 0 1.25, 4 3 1.25, 0 3 1.25, 0 0 1.25), (1 1 1.25, 1 2 1.25, 2 2 1.25, 2 1 1.25, 1 1 1.25))\","
            "\"Ceiling, \"\"left\"\"\",ceiling\n"
            "12,0,1,0,2,1,7,0.333333333,0,1,5,2,2.5,2,0,,,0,0,split:0,\"MULTIPOLYGON Z (((0 2 0, 0 2 1, 1 2 0, 0 2 "
            "0)), ((5 2 0, 5 2 -1, 4 2 0, 5 2 0)))\",'=1+2,\n");
}

void PlanesCsvTest::leavesEmptyWhatIsUnknown()
{
    const std::string text = textOf({knownPlane(7, "east wall", {-1, 0, 0}, -3.5, 912)});

    QCOMPARE(QString::fromStdString(text), QString(kHead) + "7,1,0,0,3.5,,912,,,,,,,,,,,,,,,east wall,\n");
}

void PlanesCsvTest::keepsFormulasOut_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("cell");
    QTest::newRow("=") << "=SUM(A1)"
                       << "'=SUM(A1)";
    QTest::newRow("+") << "+1"
                       << "'+1";
    QTest::newRow("-") << "-1"
                       << "'-1";
    QTest::newRow("@") << "@x"
                       << "'@x";
    QTest::newRow("with a comma") << "=A1,B2"
                                  << "\"'=A1,B2\"";
    QTest::newRow("with a line end") << "a\nb"
                                     << "\"a\nb\"";
    QTest::newRow("harmless") << "a=b"
                              << "a=b";
    QTest::newRow("apostrophe") << "'tis"
                                << "'tis";
}

void PlanesCsvTest::keepsFormulasOut()
{
    QFETCH(QString, name);
    QFETCH(QString, cell);

    const std::string text = textOf({knownPlane(0, name.toStdString(), Eigen::Vector3d::UnitZ(), 1.0, 5)});

    QVERIFY2(text.ends_with(",," + cell.toStdString() + ",\n"), text.c_str());
    QCOMPARE(QString::fromStdString(readPlanesText(text)->at(0).name), name);
}

void PlanesCsvTest::writesTheSameInEveryLocale()
{
    const std::string expected = textOf({sampleCeiling(), sampleWall()});
    QVERIFY2(std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr,
             "the locale de_DE.UTF-8 is missing: install locales-all");
    const std::locale before = std::locale::global(std::locale("de_DE.UTF-8"));

    const std::string german = textOf({sampleCeiling(), sampleWall()});
    const auto planes = readPlanesText(german);
    std::locale::global(before);

    QCOMPARE(german, expected);
    QCOMPARE(planes->at(0).distance, 1.25);
}

void PlanesCsvTest::givesTheOutlinesOfASnapshot()
{
    // Two parallel segments of 2 m, 1 m apart on the floor.
    Snapshot snapshot;
    auto plane = std::make_shared<Plane>();
    plane->id = 4;
    plane->distance = 0.0;
    for (const int step : {0, 1}) {
        LineSegment segment;
        segment.id = {step, 0};
        segment.start = {1.0, static_cast<double>(step), 0.0};
        segment.end = {-1.0, static_cast<double>(step), 0.0};
        segment.direction = Eigen::Vector3d::UnitX();
        snapshot.segments.append(step, std::make_shared<Segments>(Segments{segment}));
        plane->segments.push_back(segment.id);
    }
    snapshot.planes = {plane};

    const std::vector<PlaneResult> results = planeResults(snapshot);

    QCOMPARE(results.size(), std::size_t(1));
    QCOMPARE(results[0].plane->id, 4);
    QVERIFY(std::abs(results[0].outline.area - 2.0) < 1e-6);
    QVERIFY(results[0].name.empty());
}

void PlanesCsvTest::readsBackWhatWasWritten()
{
    const auto planes =
        readPlanesText(textOf({sampleCeiling(), sampleWall(), knownPlane(1, "east", {0.6, 0.0, -0.8}, 0.5, 400)}));

    QVERIFY(planes.has_value());
    QCOMPARE(planes->size(), std::size_t(3));
    QCOMPARE(planes->at(0).id, 3);
    QCOMPARE(planes->at(0).normal, Eigen::Vector3d(0, 0, 1));
    QCOMPARE(planes->at(0).distance, 1.25);
    QCOMPARE(planes->at(0).points, std::optional<int>(60));
    QCOMPARE(planes->at(0).name, std::string("Ceiling, \"left\""));
    QCOMPARE(planes->at(0).className, std::string("ceiling"));
    QCOMPARE(planes->at(1).name, std::string("=1+2"));
    QVERIFY((planes->at(2).normal - Eigen::Vector3d(0.6, 0.0, -0.8)).norm() < 1e-12);
}

void PlanesCsvTest::readsFilesWrittenByHand()
{
    const auto planes = readPlanesText(
        "# format = planewright-planes "
        "1,,,,\r\nd,nz,ny,nx,id,note\r\n-2,-1.0004,0,0,5,\"two\r\nlines\"\r\n0,-1,0,0,6,\r\n"
        "\r\n");

    QVERIFY2(planes.has_value(), planes ? "" : planes.error().message.c_str());
    QCOMPARE(planes->size(), std::size_t(2));
    QCOMPARE(planes->at(0).normal, Eigen::Vector3d(0, 0, 1));
    QCOMPARE(planes->at(0).distance, 2.0);
    QVERIFY(!planes->at(0).points);
    QCOMPARE(planes->at(1).normal, Eigen::Vector3d(0, 0, 1));
}

void PlanesCsvTest::refusesWhatIsNoPlanesFile_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("message");
    const QByteArray first = "# format = planewright-planes 1\n";
    const QByteArray head = first + "id,nx,ny,nz,d,points,name\n";
    const QString other =
        "this is not a planes file: the first line is not '# format = planewright-planes 1'; give a CSV that 'extract "
        "--planes' or 'simulate --truth' wrote";
    QTest::newRow("empty") << QByteArray() << "p.csv: " + other;
    QTest::newRow("recording") << QByteArray("# format = nodding-laser-csv 1\n") << "p.csv: line 1: " + other;
    QTest::newRow("no columns") << first << "p.csv: line 1: the line of column names is missing; add it";
    QTest::newRow("column missing") << first + "id,nx,ny,d\n"
                                    << "p.csv: line 2: there is no column 'nz'; add it";
    QTest::newRow("column twice") << first + "id,nx,nx\n"
                                  << "p.csv: line 2, column 3 (nx): the column is there twice; remove one of the two";
    QTest::newRow("short row") << head + "1,0,0,1\n"
                               << "p.csv: line 3: the row has 4 cells instead of 7; complete it";
    QTest::newRow("id") << head + "x,0,0,1,2,3,\n"
                        << "p.csv: line 3, column 1 (id): 'x' is not a whole number; correct it";
    QTest::newRow("huge id") << head + "9999999999,0,0,1,2,3,\n"
                             << "p.csv: line 3, column 1 (id): '9999999999' is not a whole number; correct it";
    QTest::newRow("negative id") << head + "-1,0,0,1,2,3,\n"
                                 << "p.csv: line 3: the id -1 is negative; ids count from 0";
    QTest::newRow("id twice") << head + "1,0,0,1,2,3,\n1,0,0,1,3,3,\n"
                              << "p.csv: line 4: the id 1 is there twice; give every plane its own";
    QTest::newRow("normal") << head + "1,0,nan,1,2,3,\n"
                            << "p.csv: line 3, column 3 (ny): 'nan' is not a finite number; correct it";
    QTest::newRow("no normal") << head + "1,0,,1,2,3,\n"
                               << "p.csv: line 3, column 3 (ny): '' is not a finite number; correct it";
    QTest::newRow("long normal") << head + "1,0,1,1,2,3,\n"
                                 << "p.csv: line 3: the normal of plane 1 has the length 1.41421356; a normal has the "
                                    "length 1";
    QTest::newRow("huge normal") << head + "1,0,1e300,1,2,3,\n"
                                 << "p.csv: line 3: the normal of plane 1 has the length ; a normal has the length 1";
    QTest::newRow("points") << head + "1,0,0,1,2,3.5,\n"
                            << "p.csv: line 3, column 6 (points): '3.5' is not a whole number; correct it";
    QTest::newRow("negative points") << head + "1,0,0,1,2,-3,\n"
                                     << "p.csv: line 3: plane 1 has a negative number of points; correct it";
    QTest::newRow("quote inside")
        << head + "1,0,0,1,2,3,a\"b\n"
        << "p.csv: line 3: a quote stands inside a cell; put the whole cell in quotes and double "
           "those inside";
    QTest::newRow("text after quote")
        << head + "1,0,0,1,2,3,\"a\"b\n"
        << "p.csv: line 3: a quote stands inside a cell; put the whole cell in quotes and "
           "double those inside";
    QTest::newRow("quote never closed") << head + "1,0,0,1,2,3,\"a\n1,0\n"
                                        << "p.csv: line 4: a quote is opened and never closed; close it";
    QTest::newRow("damaged gzip") << QByteArray("\x1F\x8B\x08\0\0\0\0\0\0\xFF\x06", 11)
                                  << "p.csv: line 1: the compressed data are damaged here; get the file again";
    QTest::newRow("cut gzip") << gzipWithoutEnd(head + "1,0,0,1,2,3,\n")
                              << "p.csv: line 4: the compressed file was cut short; get the whole file";
}

void PlanesCsvTest::refusesWhatIsNoPlanesFile()
{
    QFETCH(QByteArray, text);
    QFETCH(QString, message);

    const auto planes = readPlanesText(text.toStdString());

    QVERIFY(!planes.has_value());
    QCOMPARE(planes.error().code, ErrorCode::Unreadable);
    QCOMPARE(QString::fromStdString(planes.error().message), message);
}

void PlanesCsvTest::refusesAQuoteThatNeverEnds()
{
    std::string text = "# format = planewright-planes 1\nid,nx,ny,nz,d\n\"";
    const std::string line(std::size_t{1} << 20, 'x');
    for (int i = 0; i < 20; ++i)
        text += line + "\n";

    const auto planes = readPlanesText(text);

    QCOMPARE(planes.error().message,
             std::string("p.csv: line 18: the row is longer than 16777216 bytes; close its quotes"));
}

void PlanesCsvTest::refusesAFullDisk()
{
    std::ostringstream out;
    out.setstate(std::ios::badbit);

    QCOMPARE(writePlanesCsv(out, {}).error().code, ErrorCode::NotWritten);
}

PLANEWRIGHT_TEST(PlanesCsvTest)
#include "planes_csv_test.moc"
