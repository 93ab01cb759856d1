// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <map>

#include <QDir>
#include <QDirIterator>
#include <QtTest>

#include "tests/architecture/include_check.h"
#include "tests/architecture/layout_check.h"
#include "tests/architecture/rooms.h"
#include "tests/architecture/source_text.h"
#include "tests/test_program.h"

namespace planewright::architecture {

class ArchitectureTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();

    // The tree as it is.
    void everyIncludeGoesThroughADoor();
    void noHeadersIncludeEachOther();
    void theTopLevelIsAsAgreed();
    void everySourceNamesItsLicence();
    void noSourceIsLongerThanItMayBe();

    // The checker itself, on small made-up sources.
    void theDoorsOfTheTableFormNoCircle();
    void aBreachIsNamedByFileLineAndRule();
    void aDoorIsOpenOrClosed_data();
    void aDoorIsOpenOrClosed();
    void aWordIsOpenOrClosed_data();
    void aWordIsOpenOrClosed();
    void commentsAndLiteralsAreNotRead();
    void aCircleOfHeadersIsFound();
    void aStrayNameAtTheTopLevelIsFound();
    void missingLicenceLinesAreFound_data();
    void missingLicenceLinesAreFound();
    void aLongSourceIsFound();

private:
    std::map<std::string, std::string> texts_;  ///< path from the top → text of every file below the rooms
};

namespace {

void report(const Offences& offences)
{
    for (const Offence& offence : offences)
        qWarning("%s", offence.text().c_str());
    QVERIFY2(offences.empty(), qPrintable(QString::number(offences.size()) + " breaches, listed above"));
}

std::string includeLine(const QString& header)
{
    return "#include " + header.toStdString() + "\n";
}

}  // namespace

void ArchitectureTest::initTestCase()
{
    const QDir top(PLANEWRIGHT_SOURCE_DIR);
    for (const char* folder : {"app", "core", "devices", "ui", "tests", "packaging", ".ci"}) {
        QDirIterator files(top.filePath(folder), QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
        while (files.hasNext()) {
            QFile file(files.next());
            QVERIFY2(file.open(QIODevice::ReadOnly), qPrintable(file.fileName()));
            texts_[top.relativeFilePath(file.fileName()).toStdString()] = file.readAll().toStdString();
        }
    }
    QVERIFY(texts_.contains("core/types/plane.h"));
}

void ArchitectureTest::everyIncludeGoesThroughADoor()
{
    Offences offences;
    for (const auto& [path, text] : texts_) {
        if (path.ends_with(".cpp") || path.ends_with(".h")) {
            for (Offence& offence : checkSource(path, text))
                offences.push_back(std::move(offence));
        }
    }
    report(offences);
}

void ArchitectureTest::noHeadersIncludeEachOther()
{
    report(checkCircles(texts_));
}

void ArchitectureTest::theTopLevelIsAsAgreed()
{
    std::vector<std::string> names;
    const QDir top(PLANEWRIGHT_SOURCE_DIR);
    for (const QString& name : top.entryList(QDir::AllEntries | QDir::NoDotAndDotDot | QDir::Hidden))
        names.push_back(name.toStdString());
    QFile ignoreFile(top.filePath(".gitignore"));
    QVERIFY(ignoreFile.open(QIODevice::ReadOnly));
    std::vector<std::string> ignored;
    for (const QByteArray& line : ignoreFile.readAll().split('\n'))
        ignored.push_back(line.toStdString());

    report(checkTopLevel(names, ignored));
}

void ArchitectureTest::everySourceNamesItsLicence()
{
    Offences offences;
    for (const auto& [path, text] : texts_) {
        if (needsLicenceLines(path, text)) {
            for (Offence& offence : checkLicenceLines(path, text))
                offences.push_back(std::move(offence));
        }
    }
    report(offences);
}

void ArchitectureTest::noSourceIsLongerThanItMayBe()
{
    Offences offences;
    for (const auto& [path, text] : texts_) {
        for (Offence& offence : checkLength(path, text))
            offences.push_back(std::move(offence));
    }
    report(offences);
}

void ArchitectureTest::theDoorsOfTheTableFormNoCircle()
{
    // Rooms without a door to one of those left are taken away, again and again; those in a circle would stay.
    std::vector<Room> left(rooms().begin(), rooms().end());
    for (std::size_t round = 0; round < rooms().size(); ++round) {
        const std::vector<Room> before = left;
        std::erase_if(left, [&](const Room& room) {
            return std::none_of(before.begin(), before.end(), [&](const Room& other) {
                return other.folder != room.folder && hasDoorTo(room, std::string{other.folder} + "/any.h");
            });
        });
    }
    for (const Room& room : left)
        qWarning("%s is in a circle of rooms", std::string{room.folder}.c_str());
    QVERIFY(left.empty());
}

void ArchitectureTest::aBreachIsNamedByFileLineAndRule()
{
    const Offences offences = checkSource("core/types/plane.h",
                                          "#pragma once\n"
                                          "\n"
                                          "#include <vector>\n"
                                          "#include \"core/planes/merge.h\"\n");

    QCOMPARE(offences.size(), std::size_t(1));
    QCOMPARE(QString::fromStdString(offences[0].text()),
             QString("core/types/plane.h:4: core/types may not include \"core/planes/merge.h\": "
                     "there is no door to core/planes"));
}

void ArchitectureTest::aDoorIsOpenOrClosed_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("header");
    QTest::addColumn<bool>("open");
    const auto row = [](const char* path, const char* header, bool open) {
        QTest::addRow("%s %s", path, header) << path << header << open;
    };
    // The order of rooms within core.
    row("core/types/a.h", "\"core/types/plane.h\"", true);
    row("core/types/a.h", "\"core/params/parameters.h\"", false);
    row("core/params/a.h", "\"core/types/error.h\"", true);
    row("core/params/a.h", "\"core/geometry/sensor_model.h\"", false);
    row("core/geometry/a.h", "\"core/params/parameters.h\"", true);
    row("core/geometry/a.h", "\"core/segments/breakpoints.h\"", false);
    row("core/segments/a.h", "\"core/geometry/sensor_model.h\"", true);
    row("core/segments/a.h", "\"core/clusters/clusters.h\"", false);
    row("core/clusters/a.h", "\"core/segments/breakpoints.h\"", true);
    row("core/clusters/a.h", "\"core/planes/msac.h\"", false);
    row("core/planes/a.h", "\"core/clusters/clusters.h\"", true);
    row("core/planes/a.h", "\"core/pipeline/plane_extractor.h\"", false);
    row("core/pipeline/a.h", "\"core/planes/msac.h\"", true);
    row("core/pipeline/a.h", "\"core/formats/recording_csv.h\"", false);
    row("core/pipeline/a.h", "\"core/simulation/scene.h\"", false);
    row("core/simulation/a.h", "\"core/geometry/sensor_model.h\"", true);
    row("core/simulation/a.h", "\"core/pipeline/plane_extractor.h\"", false);
    row("core/simulation/a.h", "\"core/formats/recording_csv.h\"", false);
    row("core/formats/a.h", "\"core/geometry/outline.h\"", true);
    row("core/formats/a.h", "\"core/planes/msac.h\"", false);
    row("core/evaluation/a.h", "\"core/geometry/outline.h\"", true);
    row("core/evaluation/a.h", "\"core/formats/recording_csv.h\"", false);
    // The doors between the rooms of the house.
    row("core/pipeline/a.h", "\"devices/scan_source.h\"", false);
    row("core/pipeline/a.h", "\"ui/main_window.h\"", false);
    row("core/pipeline/a.h", "\"app/cli/extract.h\"", false);
    row("core/types/a.h", "\"tests/support/scans.h\"", false);
    row("devices/scan_source.h", "\"core/types/scan_slice.h\"", true);
    row("devices/scan_source.h", "\"core/params/parameters.h\"", false);
    row("devices/scan_source.h", "\"core/pipeline/plane_extractor.h\"", false);
    row("devices/nodding/a.h", "\"devices/scan_source.h\"", true);
    row("devices/nodding/a.h", "\"core/simulation/scene.h\"", false);
    row("devices/emulated/a.h", "\"core/simulation/scene.h\"", true);
    row("devices/emulated/a.h", "\"core/formats/recording_csv.h\"", false);
    row("devices/replay/a.h", "\"core/formats/recording_csv.h\"", true);
    row("devices/replay/a.h", "\"ui/main_window.h\"", false);
    row("ui/panels/a.h", "\"core/types/plane.h\"", true);
    row("ui/panels/a.h", "\"ui/models/plane_model.h\"", true);
    row("ui/models/a.h", "\"ui/panels/plane_panel.h\"", false);
    row("ui/models/a.h", "\"ui/scene/map_scene.h\"", false);
    row("devices/transport/a.h", "\"devices/scan_source.h\"", false);
    row("devices/transport/a.h", "\"devices/clock.h\"", true);
    row("ui/panels/a.h", "\"devices/scan_source.h\"", false);
    row("ui/panels/a.h", "\"app/session/scan_session.h\"", false);
    row("app/session/a.h", "\"devices/scan_source.h\"", true);
    row("app/session/a.h", "\"app/session/loops/channel.h\"", true);
    row("app/session/a.h", "\"ui/main_window.h\"", false);
    row("app/session/loops/a.h", "\"app/session/scan_session.h\"", false);
    row("app/session/loops/a.h", "\"devices/scan_source.h\"", true);
    row("app/main.cpp", "\"ui/main_window.h\"", true);
    row("app/main.cpp", "\"app/session/scan_session.h\"", true);
    row("app/cli/a.h", "\"core/pipeline/plane_extractor.h\"", true);
    row("app/cli/a.h", "\"app/session/scan_session.h\"", true);
    row("app/cli/a.h", "\"ui/main_window.h\"", false);
    // Headers of the project are named from the top.
    row("core/types/a.cpp", "\"plane.h\"", false);
    row("core/types/a.cpp", "\"../params/parameters.h\"", false);
    row("core/types/a.cpp", "\"core/unheard/of.h\"", false);
    row("core/unheard/a.cpp", "<vector>", false);
    row("core/types/a.cpp", "PLANE_HEADER", false);
    // Libraries.
    row("core/types/a.h", "<Eigen/Core>", true);
    row("core/types/a.h", "<tl/expected.hpp>", true);
    row("core/types/a.h", "<zlib.h>", false);
    row("core/formats/a.cpp", "<zlib.h>", true);
    row("core/formats/a.cpp", "<nlohmann/json.hpp>", true);
    row("core/formats/a.cpp", "<sqlite3.h>", true);
    row("core/formats/a.cpp", "<dime/Model.h>", true);
    row("core/planes/a.cpp", "<nlohmann/json.hpp>", false);
    row("core/geometry/a.cpp", "<polyclipping/clipper.hpp>", true);
    row("core/formats/a.cpp", "<polyclipping/clipper.hpp>", false);
    row("core/mapping/a.cpp", "<ceres/ceres.h>", true);
    row("core/planes/a.cpp", "<ceres/ceres.h>", false);
    row("core/planes/a.cpp", "<QString>", false);
    row("core/planes/a.cpp", "<vtkActor.h>", false);
    row("core/planes/a.cpp", "<libusb-1.0/libusb.h>", false);
    row("core/planes/a.cpp", "<unistd.h>", false);
    row("devices/transport/a.cpp", "<libusb-1.0/libusb.h>", true);
    row("devices/transport/a.cpp", "<libusb.h>", true);
    row("devices/nodding/a.cpp", "<libusb.h>", false);
    row("devices/nodding/a.cpp", "<vtkActor.h>", false);
    row("ui/models/a.h", "<QAbstractItemModel>", true);
    row("ui/models/a.h", "<vtkActor.h>", false);
    row("ui/scene/a.h", "<vtkActor.h>", true);
    row("ui/scene/a.h", "<QObject>", false);
    row("ui/view3d/a.h", "<vtkActor.h>", true);
    row("ui/view3d/a.h", "<QWidget>", true);
    row("app/cli/a.cpp", "<CLI/CLI.hpp>", true);
    row("app/cli/a.cpp", "<vtkActor.h>", false);
    row("app/session/a.cpp", "<QThread>", true);
    row("app/session/a.cpp", "<QWidget>", false);
    row("app/session/loops/a.cpp", "<QThread>", false);
    row("app/session/loops/a.cpp", "<mutex>", true);
    // Standard headers.
    row("core/planes/a.cpp", "<vector>", true);
    row("core/planes/a.cpp", "<chrono>", true);
    row("core/planes/a.cpp", "<thread>", false);
    row("core/planes/a.cpp", "<mutex>", false);
    row("core/planes/a.cpp", "<future>", false);
    row("core/planes/a.cpp", "<condition_variable>", false);
    row("core/formats/a.cpp", "<iostream>", false);
    row("core/formats/a.cpp", "<cstdio>", false);
    row("core/formats/a.cpp", "<istream>", true);
    row("core/planes/a.cpp", "<ostream>", false);
    row("core/planes/a.cpp", "<random>", false);
    row("core/simulation/a.cpp", "<random>", true);
    row("devices/nodding/a.cpp", "<thread>", false);
    row("devices/transport/a.cpp", "<thread>", true);
    row("app/session/a.cpp", "<thread>", true);
}

void ArchitectureTest::aDoorIsOpenOrClosed()
{
    QFETCH(QString, path);
    QFETCH(QString, header);
    QFETCH(bool, open);

    const Offences offences = checkSource(path.toStdString(), includeLine(header));

    QCOMPARE(offences.empty(), open);
}

void ArchitectureTest::aWordIsOpenOrClosed_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<bool>("open");
    QTest::newRow("const auto now = std::chrono::steady_clock::now();") << "core/planes/a.cpp" << false;
    QTest::newRow("using Clock = std::chrono::system_clock;") << "core/formats/a.cpp" << false;
    QTest::newRow("std::random_device seed;") << "core/simulation/a.cpp" << false;
    QTest::newRow("return std::rand();") << "core/planes/a.cpp" << false;
    QTest::newRow("std::normal_distribution<double> noise;") << "core/simulation/a.cpp" << false;
    QTest::newRow("return std::stod(text);") << "core/formats/a.cpp" << false;
    QTest::newRow("std::chrono::nanoseconds elapsed{0};") << "core/planes/a.cpp" << true;
    QTest::newRow("const double operand = brand(1);") << "core/planes/a.cpp" << true;
    QTest::newRow("std::mt19937_64 engine(seed);") << "core/simulation/a.cpp" << true;
    QTest::newRow("auto now = std::chrono::steady_clock::now();") << "app/cli/a.cpp" << true;
}

void ArchitectureTest::aWordIsOpenOrClosed()
{
    QFETCH(QString, path);
    QFETCH(bool, open);

    const Offences offences = checkSource(path.toStdString(), QTest::currentDataTag());

    QCOMPARE(offences.empty(), open);
}

void ArchitectureTest::commentsAndLiteralsAreNotRead()
{
    const std::string source =
        "// #include <thread>\n"
        "/* a comment of two lines\n"
        "#include <mutex> */\n"
        "const char* text = \"steady_clock // \\\" rand\";\n"
        "const char* raw = R\"x(\n"
        "#include <future>\n"
        ")\" srand )x\";\n"
        "const char quote = '\"'; const int million = 1'000'000; // rand\n"
        "#include <iostream> // found\n";

    const Offences offences = checkSource("core/planes/a.cpp", source);

    QCOMPARE(offences.size(), std::size_t(1));
    QCOMPARE(offences[0].line, 9);
}

void ArchitectureTest::aCircleOfHeadersIsFound()
{
    const std::map<std::string, std::string> sources{
        {"core/types/a.h", "#include \"core/types/b.h\"\n"},
        {"core/types/b.h", "#include \"core/types/c.h\"\n#include \"core/types/d.h\"\n"},
        {"core/types/c.h", "#include \"core/types/a.h\"\n"},
        {"core/types/d.h", "#include <vector>\n"},
    };

    const Offences offences = checkCircles(sources);

    QCOMPARE(offences.size(), std::size_t(1));
    QVERIFY(offences[0].rule.ends_with("core/types/a.h → core/types/b.h → core/types/c.h → core/types/a.h"));
}

void ArchitectureTest::aStrayNameAtTheTopLevelIsFound()
{
    std::vector<std::string> names{
        "CHANGELOG.md", "CMakeLists.txt", "CMakePresets.json", "CONTRIBUTING.md", "LICENSE", "README.md", "app",
        "core",         "devices",        "packaging",         "resources",       "tests",   "ui"};
    QVERIFY(checkTopLevel(names, {}).empty());
    names.push_back(".clang-format");
    names.push_back("planewright-demo");
    QVERIFY(checkTopLevel(names, {"/planewright-demo/"}).empty());
    names.push_back("scripts");
    names.erase(names.begin());

    const Offences offences = checkTopLevel(names, {"/planewright-demo/"});

    QCOMPARE(offences.size(), std::size_t(2));
    QCOMPARE(offences[0].file, std::string("scripts"));
    QCOMPARE(offences[1].file, std::string("CHANGELOG.md"));
}

void ArchitectureTest::missingLicenceLinesAreFound_data()
{
    QTest::addColumn<QByteArray>("head");
    QTest::addColumn<bool>("fine");
    const QByteArray holder = QByteArray("SPDX-") + "FileCopyrightText: 2026 The Planewright authors\n";
    const QByteArray licence = QByteArray("SPDX-") + "License-Identifier: BSD-3-Clause\n";
    QTest::newRow("core/a.cpp") << "// " + holder + "// " + licence + "\n" << true;
    QTest::newRow("core/CMakeLists.txt") << "# " + holder + "# " + licence << true;
    QTest::newRow("packaging/run-demo") << "#!/bin/bash\n# " + holder + "# " + licence << true;
    QTest::newRow("core/b.cpp") << "// " + licence + "// " + holder << false;
    QTest::newRow("core/c.cpp") << "#pragma once\n// " + holder + "// " + licence << false;
    QTest::newRow("core/d.cpp") << "// " + holder << false;
    QTest::newRow("core/e.h") << QByteArray() << false;
    QTest::newRow("tests/run") << QByteArray("#!/bin/bash\n") << false;
    QTest::newRow("packaging/packages-build.txt") << QByteArray("cmake\n") << false;
}

void ArchitectureTest::missingLicenceLinesAreFound()
{
    QFETCH(QByteArray, head);
    QFETCH(bool, fine);

    QVERIFY(needsLicenceLines(QTest::currentDataTag(), head.toStdString()));
    QCOMPARE(checkLicenceLines(QTest::currentDataTag(), head.toStdString()).empty(), fine);
}

void ArchitectureTest::aLongSourceIsFound()
{
    QVERIFY(checkLength("core/a.cpp", std::string(400, '\n')).empty());
    QCOMPARE(checkLength("core/a.cpp", std::string(401, '\n')).size(), std::size_t(1));
    QVERIFY(checkLength("tests/core/a_test.cpp", std::string(600, '\n')).empty());
    QCOMPARE(checkLength("tests/core/a_test.cpp", std::string(601, '\n')).size(), std::size_t(1));
    QVERIFY(checkLength("core/README.md", std::string(401, '\n')).empty());
}

}  // namespace planewright::architecture

PLANEWRIGHT_TEST(planewright::architecture::ArchitectureTest)
#include "architecture_test.moc"
