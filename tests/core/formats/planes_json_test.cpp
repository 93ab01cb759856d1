// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/planes_json.h"

#include <clocale>
#include <limits>
#include <locale>
#include <sstream>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>

#include "sample_planes.h"
#include "tests/test_program.h"

using namespace planewright;

namespace {

std::string planesJsonText(const std::vector<PlaneResult>& planes, std::string_view program = "planewright 0.1.0")
{
    std::ostringstream out;
    const auto done = writePlanesJson(out, planes, Parameters{}, program);
    return done ? out.str() : done.error().message;
}

Result<std::vector<PlaneRecord>> readPlanesJsonText(const std::string& text)
{
    std::istringstream in(text);
    return readPlanesJson(in, "p.json");
}

QJsonObject parse(const std::string& text)
{
    return QJsonDocument::fromJson(QByteArray::fromStdString(text)).object();
}

}  // namespace

class PlanesJsonTest : public QObject {
    Q_OBJECT

private slots:
    void writesFormatProgramAndParameters();
    void writesAPlaneALine();
    void writesTheSameInEveryLocale();
    void replacesBytesThatAreNoUtf8();
    void readsBackWhatWasWritten();
    void readsBackAllThatAMapNeeds();
    void aMapsPlanesTellTheirStops();
    void refusesWhatIsNoPlaneOfAMap_data();
    void refusesWhatIsNoPlaneOfAMap();
    void refusesWhatIsNoPlanesFile_data();
    void refusesWhatIsNoPlanesFile();
    void refusesDeepNesting();
    void refusesTooManyValues();
    void refusesTooManyBytes();
    void refusesAStreamThatFails();
};

void PlanesJsonTest::writesFormatProgramAndParameters()
{
    const QJsonObject object = parse(planesJsonText({}));

    QCOMPARE(object["format"].toString(), QString("planewright-planes 1"));
    QCOMPARE(object["program"].toString(), QString("planewright 0.1.0"));
    QCOMPARE(object["parameters"].toObject()["segments.split-distance"].toDouble(), 0.03);
    QCOMPARE(object["parameters"].toObject()["noise.pitch"].toDouble(), 0.084);
    QCOMPARE(object["parameters"].toObject()["clusters.average"].toString(), QString("ewma"));
    QVERIFY(object["planes"].isArray());
    QVERIFY(object["planes"].toArray().isEmpty());
}

void PlanesJsonTest::writesAPlaneALine()
{
    const std::string text = planesJsonText({sampleCeiling(), sampleWall(), knownPlane(1, "", {0, 0, 1}, 2, 5)});
    const QStringList lines = QString::fromStdString(text).split('\n');

    QCOMPARE(lines.size(), 6);
    // (0.5°)² = (π/360)² = 7.615435495e-5 rad²; times 0.52, 0.36 and 0.73.
    QCOMPARE(lines[1],
             QString(R"({"id":3,"nx":0,"ny":0,"nz":1,"d":1.25,"segments":2,"points":60,"error":0.5,"rms_m":0.004,)"
                     R"("area_m2":11,"width_m":4,"height_m":3,"cx":2.04545455,"cy":1.5,"cz":1.25,)"
                     R"("sigma_normal_deg":0.5,"sigma_d_m":0.002,"born_step":4,"changed_step":6,)"
                     R"("lineage":"merge:1+2","polygon":[[[0,0,1.25],[4,0,1.25],[4,3,1.25],[0,3,1.25],[0,0,1.25]],)"
                     R"([[1,1,1.25],[1,2,1.25],[2,2,1.25],[2,1,1.25],[1,1,1.25]]],"name":"Ceiling, \"left\"",)"
                     R"("class":"ceiling","covariance":[[3.96002646e-05,2.74155678e-05,0],[2.74155678e-05,)"
                     R"(5.55926791e-05,0],[0,0,4e-06]],"tangents":[[1,0,0],[0,1,0]]},)"));
    QVERIFY(lines[2].contains(
        R"("polygon":[[[0,2,0],[0,2,1],[1,2,0],[0,2,0]],[[5,2,0],[5,2,-1],[4,2,0],[5,2,0]]],"name":"=1+2","class":null)"));
    QCOMPARE(lines[3],
             QString(R"({"id":1,"nx":0,"ny":0,"nz":1,"d":2,"segments":null,"points":5,"error":null,"rms_m":null,)"
                     R"("area_m2":null,"width_m":null,"height_m":null,"cx":null,"cy":null,"cz":null,)"
                     R"("sigma_normal_deg":null,"sigma_d_m":null,"born_step":null,"changed_step":null,)"
                     R"("lineage":null,"polygon":null,"name":null,"class":null,"covariance":null,"tangents":null})"));
    QCOMPARE(parse(text)["planes"].toArray().size(), 3);
}

void PlanesJsonTest::writesTheSameInEveryLocale()
{
    const std::string expected = planesJsonText({sampleCeiling()});
    QVERIFY2(std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr,
             "the locale de_DE.UTF-8 is missing: install locales-all");
    const std::locale before = std::locale::global(std::locale("de_DE.UTF-8"));

    const std::string german = planesJsonText({sampleCeiling()});
    const auto planes = readPlanesJsonText(german);
    std::locale::global(before);

    QCOMPARE(german, expected);
    QCOMPARE(planes->at(0).distance, 1.25);
}

void PlanesJsonTest::replacesBytesThatAreNoUtf8()
{
    const QJsonObject object = parse(planesJsonText({}, "pl\xFFne"));

    QCOMPARE(object["program"].toString(), QString::fromUtf8("pl\xEF\xBF\xBDne"));
}

void PlanesJsonTest::readsBackWhatWasWritten()
{
    const auto planes =
        readPlanesJsonText(planesJsonText({sampleCeiling(), sampleWall(), knownPlane(1, "east", {0, -1, 0}, 2, 5)}));

    QVERIFY(planes.has_value());
    QCOMPARE(planes->size(), std::size_t(3));
    QCOMPARE(planes->at(0).id, 3);
    QCOMPARE(planes->at(0).normal, Eigen::Vector3d(0, 0, 1));
    QCOMPARE(planes->at(0).points, std::optional<int>(60));
    QCOMPARE(planes->at(0).name, std::string("Ceiling, \"left\""));
    QCOMPARE(planes->at(0).className, std::string("ceiling"));
    QCOMPARE(planes->at(1).name, std::string("=1+2"));
    QVERIFY(planes->at(1).className.empty());
    QCOMPARE(planes->at(2).normal, Eigen::Vector3d(0, -1, 0));
    QCOMPARE(planes->at(2).distance, 2.0);
}

void PlanesJsonTest::readsBackAllThatAMapNeeds()
{
    const PlaneResult ceiling = sampleCeiling();
    const PlaneResult wall = sampleWall();
    std::istringstream in(planesJsonText({ceiling, wall}));

    const auto read = readPlaneResultsJson(in, "p.json");

    QVERIFY2(read.has_value(), read ? "" : read.error().message.c_str());
    const PlaneResult& first = read->at(0);
    QCOMPARE(first.plane->id, 3);
    QVERIFY(first.plane->covariance.isApprox(ceiling.plane->covariance, 1e-8));
    QCOMPARE(first.plane->tangents, ceiling.plane->tangents);
    QCOMPARE(first.plane->points, 60);
    QCOMPARE(first.outline.parts.size(), std::size_t(1));
    QCOMPARE(first.outline.parts[0].ring, ceiling.outline.parts[0].ring);
    QCOMPARE(first.outline.parts[0].holes.size(), std::size_t(1));
    QVERIFY(std::abs(first.outline.area - 11.0) < 1e-12);
    QCOMPARE(first.className, std::string("ceiling"));
    QCOMPARE(read->at(1).outline.parts.size(), std::size_t(2));
    QVERIFY(read->at(1).plane->covariance.isZero(0.0));
}

void PlanesJsonTest::aMapsPlanesTellTheirStops()
{
    PlaneResult plane = sampleCeiling();
    plane.stops = {0, 7, 12};

    QVERIFY(planesJsonText({plane}).find("\"class\":\"ceiling\",\"stops\":[0,7,12],") != std::string::npos);
}

void PlanesJsonTest::refusesWhatIsNoPlaneOfAMap_data()
{
    QTest::addColumn<QByteArray>("rest");
    QTest::addColumn<QByteArray>("message");
    const QByteArray unit = R"("covariance":[[1,0,0],[0,1,0],[0,0,1]],"tangents":[[1,0,0],[0,1,0]])";
    const auto row = [](const char* name, const QByteArray& rest, const char* message) {
        QTest::newRow(name) << rest << QByteArray(message);
    };
    row("covariance", R"("covariance":7)", "'covariance' is no list of three rows; correct it");
    row("no tangents", R"("covariance":[[1,0,0],[0,1,0],[0,0,1]])", "'tangents' is no list of two vectors; correct it");
    row("row", R"("covariance":[[1,0,0],[0,1],[0,0,1]],"tangents":[[1,0,0],[0,1,0]])",
        "'covariance' has a row that is no three numbers; correct it");
    row("not symmetric", R"("covariance":[[1,0,0],[0.5,1,0],[0,0,1]],"tangents":[[1,0,0],[0,1,0]])",
        "'covariance' is not symmetric; correct it");
    row("tangent off the plane", R"("covariance":[[1,0,0],[0,1,0],[0,0,1]],"tangents":[[1,0,0],[0,0,1]])",
        "'tangents' are no unit vectors in the plane; correct them");
    row("tangents alike", R"("covariance":[[1,0,0],[0,1,0],[0,0,1]],"tangents":[[1,0,0],[1,0,0]])",
        "'tangents' are not at right angles; correct them");
    row("polygon", unit + R"(,"polygon":"none")", "'polygon' is no list of rings; correct it");
    row("two corners", unit + R"(,"polygon":[[[0,0,2],[1,0,2],[0,0,2]]])",
        "'polygon' has a ring of less than three corners; correct it");
    row("corner", unit + R"(,"polygon":[[[0,0,2],[1,0],[1,1,2],[0,0,2]]])",
        "'polygon' has a corner that is no three numbers; correct it");
    row("off the plane", unit + R"(,"polygon":[[[0,0,2],[1,0,2.1],[1,1,2],[0,0,2]]])",
        "'polygon' has a corner that is not in the plane; correct it");
    row("open", unit + R"(,"polygon":[[[0,0,2],[1,0,2],[1,1,2],[0,1,2]]])",
        "'polygon' has a ring that is not closed; correct it");
    row("hole first", unit + R"(,"polygon":[[[0,0,2],[1,1,2],[1,0,2],[0,0,2]]])",
        "'polygon' begins with a hole; correct it");
}

void PlanesJsonTest::refusesWhatIsNoPlaneOfAMap()
{
    QFETCH(QByteArray, rest);
    QFETCH(QByteArray, message);
    const QByteArray text =
        R"({"format":"planewright-planes 1","planes":[{"id":1,"nx":0,"ny":0,"nz":1,"d":2,)" + rest + "}]}";
    std::istringstream in(text.toStdString());

    const auto read = readPlaneResultsJson(in, "p.json");

    QVERIFY(!read.has_value());
    QCOMPARE(QByteArray::fromStdString(read.error().message), "p.json: plane 0 of the list: " + message);
}

void PlanesJsonTest::refusesWhatIsNoPlanesFile_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("message");
    const auto planes = [](const QByteArray& list) -> QByteArray {
        return R"({"format":"planewright-planes 1","planes":)" + list + "}";
    };
    QTest::newRow("empty") << QByteArray() << "p.json: line 1, column 1: this is not JSON at ''; correct it there";
    QTest::newRow("syntax") << QByteArray("{\n  \"a\" 1}")
                            << "p.json: line 2, column 7: this is not JSON at '1'; correct it there";
    QTest::newRow("cut") << QByteArray(R"({"format")")
                         << "p.json: line 1, column 10: this is not JSON at '\"format\"'; correct it there";
    QTest::newRow("rest") << QByteArray("{} x")
                          << "p.json: line 1, column 4: this is not JSON at '{} x'; correct it there";
    QTest::newRow("NaN") << planes(R"([{"id":NaN}])")
                         << "p.json: line 1, column 50: this is not JSON at '\"id\":N'; correct it there";
    QTest::newRow("overflow") << planes(R"([{"id":1e999}])")
                              << "p.json: line 1, column 54: this is not JSON at '1e999'; correct it there";
    QTest::newRow("key twice") << QByteArray(R"({"format":1,"format":2})")
                               << "p.json: the key 'format' is there twice; remove one of the two";
    QTest::newRow("no object") << QByteArray("[1]")
                               << R"(p.json: there is no "format":"planewright-planes 1"; give a file of this format)";
    QTest::newRow("format is a number")
        << QByteArray(R"({"format":1})")
        << R"(p.json: there is no "format":"planewright-planes 1"; give a file of this format)";
    QTest::newRow("other format") << QByteArray(R"({"format":"planewright-preset 1"})")
                                  << "p.json: the format is 'planewright-preset 1'; give a file of the format "
                                     "'planewright-planes 1'";
    QTest::newRow("newer") << QByteArray(R"({"format":"planewright-planes 2"})")
                           << "p.json: the file is of the newer format 'planewright-planes 2' and this program reads "
                              "'planewright-planes 1'; use a newer version of the program";
    QTest::newRow("older") << QByteArray(R"({"format":"planewright-planes 0"})")
                           << "p.json: the format is 'planewright-planes 0'; give a file of the format "
                              "'planewright-planes 1'";
    QTest::newRow("no list") << planes("{}")
                             << "p.json: there is no list 'planes'; give a file that 'extract --planes' wrote";
    const QString first = "p.json: plane 0 of the list: ";
    QTest::newRow("no plane") << planes("[7]") << first + "is not an object; correct it";
    QTest::newRow("no id") << planes(R"([{"nx":0,"ny":0,"nz":1,"d":2}])") << first + "has no 'id'; add it";
    QTest::newRow("null") << planes(R"([{"id":1,"nx":0,"ny":0,"nz":null,"d":2}])") << first + "has no 'nz'; add it";
    QTest::newRow("text") << planes(R"([{"id":1,"nx":0,"ny":"0","nz":1,"d":2}])")
                          << first + "'ny' is not a number; correct it";
    QTest::newRow("broken id") << planes(R"([{"id":1.5,"nx":0,"ny":0,"nz":1,"d":2}])")
                               << first + "'id' is not a whole number; correct it";
    QTest::newRow("huge id") << planes(R"([{"id":4294967296,"nx":0,"ny":0,"nz":1,"d":2}])")
                             << first + "'id' is not a whole number; correct it";
    QTest::newRow("id of 64 bits") << planes(R"([{"id":18446744073709551615,"nx":0,"ny":0,"nz":1,"d":2}])")
                                   << first + "'id' is not a whole number; correct it";
    QTest::newRow("points") << planes(R"([{"id":1,"nx":0,"ny":0,"nz":1,"d":2,"points":"9"}])")
                            << first + "'points' is not a whole number; correct it";
    QTest::newRow("name") << planes(R"([{"id":1,"nx":0,"ny":0,"nz":1,"d":2,"name":9}])")
                          << first + "'name' is not a text; correct it";
    QTest::newRow("id twice") << planes(R"([{"id":1,"nx":0,"ny":0,"nz":1,"d":2},{"id":1,"nx":0,"ny":0,"nz":1,"d":2}])")
                              << "p.json: the id 1 is there twice; give every plane its own";
}

void PlanesJsonTest::refusesWhatIsNoPlanesFile()
{
    QFETCH(QByteArray, text);
    QFETCH(QString, message);

    const auto planes = readPlanesJsonText(text.toStdString());

    QVERIFY(!planes.has_value());
    QCOMPARE(planes.error().code, ErrorCode::Unreadable);
    QCOMPARE(QString::fromStdString(planes.error().message), message);
}

void PlanesJsonTest::refusesDeepNesting()
{
    const std::string deepest =
        R"({"format":"planewright-planes 1","planes":[],"a":)" + std::string(63, '[') + std::string(63, ']') + "}";

    QVERIFY(readPlanesJsonText(deepest).has_value());
    for (const char* opening : {"[", "{\"a\":"}) {
        std::string text;
        for (int i = 0; i < 100000; ++i)
            text += opening;
        QCOMPARE(readPlanesJsonText(text).error().message,
                 std::string("p.json: the file nests deeper than 64 levels; give a flatter one"));
    }
}

void PlanesJsonTest::refusesTooManyValues()
{
    std::string text = "[0";
    for (int i = 0; i < 4'000'000; ++i)
        text += ",0";

    QCOMPARE(readPlanesJsonText(text).error().message,
             std::string("p.json: the file holds more than 4000000 values; give a smaller one"));
    text = "[";
    for (int i = 0; i < 4'000'000; ++i)
        text += "[],";
    QCOMPARE(readPlanesJsonText(text).error().message,
             std::string("p.json: the file holds more than 4000000 values; give a smaller one"));
}

void PlanesJsonTest::refusesTooManyBytes()
{
    const std::string text((std::size_t{64} << 20) + 1, ' ');

    QCOMPARE(readPlanesJsonText(text).error().message,
             std::string("p.json: the file is larger than 64 MiB; give one that this program wrote"));
}

void PlanesJsonTest::refusesAStreamThatFails()
{
    std::istringstream in("{}");
    in.setstate(std::ios::badbit);
    std::ostringstream out;
    out.setstate(std::ios::badbit);

    QCOMPARE(readPlanesJson(in, "p.json").error().message,
             std::string("p.json: the file cannot be read; check that it is a file and that its disk is sound"));
    QCOMPARE(writePlanesJson(out, {}, {}, "p").error().code, ErrorCode::NotWritten);
}

PLANEWRIGHT_TEST(PlanesJsonTest)
#include "planes_json_test.moc"
