// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QImage>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

/// The window program as scripts and users start it, without a display.
class WindowProgramTest : public QObject {
    Q_OBJECT

private slots:
    void aScreenshotIsOfTheSizeAskedFor();
    void theStepAskedForIsShown();
    void aScriptWatchesARoomGrow();
    void aScriptEndsAtTheFirstLineThatFails();
    void linesOfAScriptThatMakeNoSenseAreNamed_data();
    void linesOfAScriptThatMakeNoSenseAreNamed();
    void eglDrawsTheSamePicture();
    void badUsageIsToldBeforeAnythingOpens_data();
    void badUsageIsToldBeforeAnythingOpens();
    void aFileThatIsNoRecordingIsNamed();
    void editsCanBeTakenBack();
    void aDamagedFileIsToldAndEndsWithItsCode_data();
    void aDamagedFileIsToldAndEndsWithItsCode();
    void dialogsAreOpenForAScript();
    void anActionThatWaitsForAnAnswerFails();
    void theWindowIsAsLargeAsItsPicture();
    void stepsOfAScriptAreStepsOfTheScan_data();
    void stepsOfAScriptAreStepsOfTheScan();

private:
    struct Run {
        int exitCode = -1;
        QString out;
        QString err;
    };
    Run run(const QStringList& arguments) const;
    QString write(const QString& name, const QByteArray& text) const;
    QString at(const QString& name) const { return folder_.filePath(name); }

    QTemporaryDir folder_;
};

WindowProgramTest::Run WindowProgramTest::run(const QStringList& arguments) const
{
    QProcess program;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.remove(QStringLiteral("DISPLAY"));
    environment.remove(QStringLiteral("QT_QPA_PLATFORM"));
    program.setProcessEnvironment(environment);
    program.start(QStringLiteral(PLANEWRIGHT_WINDOW_PROGRAM), QStringList{QStringLiteral("--offscreen")} + arguments);
    if (!program.waitForFinished(300'000)) {
        program.kill();
        program.waitForFinished();
        return {-2, {}, QStringLiteral("does not end")};
    }
    return {program.exitCode(), QString::fromUtf8(program.readAllStandardOutput()),
            QString::fromUtf8(program.readAllStandardError())};
}

QString WindowProgramTest::write(const QString& name, const QByteArray& text) const
{
    QFile file(at(name));
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
        qFatal("cannot write %s", qPrintable(file.fileName()));
    return file.fileName();
}

void WindowProgramTest::aScreenshotIsOfTheSizeAskedFor()
{
    const Run done = run({"sim:corridor?seed=7&speed=0", "--screenshot", at("a.png"), "--size", "700x500"});

    QVERIFY2(done.exitCode == 0, qPrintable(done.err));
    const QImage picture(at("a.png"));
    QCOMPARE(picture.size(), QSize(700, 500));
    QCOMPARE(picture.text("Step"), QString("136"));
    QVERIFY(picture.text("Parameters").contains("method.estimator="));
    QVERIFY(!picture.text("Camera").isEmpty());
}

void WindowProgramTest::theStepAskedForIsShown()
{
    const Run done =
        run({"sim:corridor?seed=7&speed=0", "--screenshot", at("b.png"), "--size", "320x240", "--step", "6"});

    QVERIFY2(done.exitCode == 0, qPrintable(done.err));
    QCOMPARE(QImage(at("b.png")).text("Step"), QString("6"));
}

void WindowProgramTest::aScriptWatchesARoomGrow()
{
    const QString script = write("grow.ndjson", R"({"do":"open","address":"sim:corridor?seed=7&speed=0"}
{"do":"wait","state":"review","timeout":120}
{"do":"expect","object":"view3d","property":"visible","equals":true}
{"do":"goto","step":4}
{"do":"select","plane":0}
{"do":"action","name":"actViewTop"}
{"do":"screenshot","file":")" + at("c.png").toUtf8() +
                                                    R"(","size":"400x300"}
{"do":"quit"}
)");

    const Run done = run({"--script", script});

    QVERIFY2(done.exitCode == 0, qPrintable(done.err));
    QCOMPARE(QImage(at("c.png")).text("Step"), QString("4"));
}

void WindowProgramTest::aScriptEndsAtTheFirstLineThatFails()
{
    const QString script =
        write("fail.ndjson", R"({"do":"expect","object":"mainWindow","property":"visible","equals":true}
{"do":"expect","object":"mainWindow","property":"visible","equals":false}
{"do":"screenshot","file":")" + at("never.png").toUtf8() +
                                 R"("}
)");

    const Run done = run({"--script", script});

    QCOMPARE(done.exitCode, 8);
    QVERIFY2(done.err.contains("fail.ndjson:2: visible of mainWindow is true"), qPrintable(done.err));
    QVERIFY(!QFile::exists(at("never.png")));
}

void WindowProgramTest::linesOfAScriptThatMakeNoSenseAreNamed_data()
{
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<QString>("said");
    QTest::newRow("no JSON") << QByteArray("open it") << "no JSON object";
    QTest::newRow("unknown action") << QByteArray(R"({"do":"dance"})") << R"("do" is "dance")";
    QTest::newRow("no such action of the window")
        << QByteArray(R"({"do":"action","name":"actNothing"})") << "there is no action actNothing";
    QTest::newRow("an action that is not possible")
        << QByteArray(R"({"do":"action","name":"actFinish"})") << "actFinish is not possible now";
    QTest::newRow("unknown key") << QByteArray(
                                        R"({"do":"expect","object":"mainWindow","property":"visible","equal":false})")
                                 << "expect has no key \"equal\"; it has object, property, equals, atLeast, atMost";
    QTest::newRow("nothing expected") << QByteArray(R"({"do":"expect","object":"mainWindow","property":"visible"})")
                                      << "expect needs \"equals\"";
    QTest::newRow("a limit that is no number")
        << QByteArray(R"({"do":"expect","object":"mainWindow","property":"width","atLeast":"100"})")
        << "\"atLeast\" is a number";
    QTest::newRow("nothing to set") << QByteArray(R"({"do":"set","object":"view3d","property":"enabled"})")
                                    << "set needs a \"value\"";
    QTest::newRow("a timeout that is no number")
        << QByteArray(R"({"do":"wait","state":"empty","timeout":"long"})") << "\"timeout\" is a number";
    QTest::newRow("both") << QByteArray(R"({"do":"select","plane":0,"segment":"0.0"})") << "select needs one of";
    QTest::newRow("no such object") << QByteArray(R"({"do":"expect","object":"x","property":"y","equals":1})")
                                    << "there is no object x";
    QTest::newRow("no such property") << QByteArray(R"({"do":"set","object":"view3d","property":"sense","value":1})")
                                      << "has no property sense";
    QTest::newRow("unknown state") << QByteArray(R"({"do":"wait","state":"bored"})") << "there is no state bored";
    QTest::newRow("plane that is not there") << QByteArray(R"({"do":"select","plane":99})") << "there is no plane 99";
    QTest::newRow("size") << QByteArray(R"({"do":"screenshot","file":"a.png","size":"9"})") << "\"size\" is like";
    QTest::newRow("no picture") << QByteArray(R"({"do":"screenshot","file":"a.txt"})") << "written as .png";
    QTest::newRow("file that is not there")
        << QByteArray(R"({"do":"open","file":"/nowhere/a.csv"})") << "/nowhere/a.csv";
}

void WindowProgramTest::linesOfAScriptThatMakeNoSenseAreNamed()
{
    QFETCH(QByteArray, line);
    QFETCH(QString, said);

    const Run done = run({"--script", write("odd.ndjson", line + "\n")});

    QCOMPARE(done.exitCode, 8);
    QVERIFY2(done.err.contains("odd.ndjson:1: ") && done.err.contains(said), qPrintable(done.err));
}

void WindowProgramTest::eglDrawsTheSamePicture()
{
    const QStringList what{"sim:twelve?seed=1&speed=0", "--size", "320x240"};
    const Run osmesa = run(what + QStringList{"--screenshot", at("osmesa.png"), "--renderer", "osmesa"});
    const Run egl = run(what + QStringList{"--screenshot", at("egl.png"), "--renderer", "egl"});

    QVERIFY2(osmesa.exitCode == 0, qPrintable(osmesa.err));
    QVERIFY2(egl.exitCode == 0, qPrintable(egl.err));
    QCOMPARE(QImage(at("egl.png")), QImage(at("osmesa.png")));
}

void WindowProgramTest::badUsageIsToldBeforeAnythingOpens_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::newRow("size") << QStringList{"--size", "12by9"};
    QTest::newRow("huge size") << QStringList{"--size", "100000x100"};
    QTest::newRow("theme") << QStringList{"--theme", "pink"};
    QTest::newRow("renderer") << QStringList{"--renderer", "pencil"};
    QTest::newRow("renderer that needs a display") << QStringList{"--renderer", "gl"};
    QTest::newRow("step") << QStringList{"--step", "-3"};
    QTest::newRow("unknown") << QStringList{"--frobnicate"};
}

void WindowProgramTest::badUsageIsToldBeforeAnythingOpens()
{
    QFETCH(QStringList, arguments);

    const Run done = run(arguments);

    QCOMPARE(done.exitCode, 2);
    QVERIFY(!done.err.isEmpty());
}

void WindowProgramTest::aFileThatIsNoRecordingIsNamed()
{
    const Run done = run({write("odd.csv", "this is no recording\n"), "--screenshot", at("no.png")});

    QCOMPARE(done.exitCode, 3);
    QVERIFY2(done.err.contains("odd.csv"), qPrintable(done.err));
    QVERIFY(!QFile::exists(at("no.png")));
}

void WindowProgramTest::editsCanBeTakenBack()
{
    const QString script = write("edit.ndjson", R"({"do":"open","address":"sim:corridor?seed=7&speed=0"}
{"do":"wait","state":"review","timeout":120}
{"do":"expect","object":"actUndo","property":"enabled","equals":false}
{"do":"select","plane":0}
{"do":"action","name":"actDelete"}
{"do":"expect","object":"actUndo","property":"enabled","equals":true}
{"do":"action","name":"actUndo"}
{"do":"expect","object":"actUndo","property":"enabled","equals":false}
{"do":"expect","object":"actRedo","property":"enabled","equals":true}
)");

    const Run done = run({"--script", script});

    QVERIFY2(done.exitCode == 0, qPrintable(done.err));
}

void WindowProgramTest::aDamagedFileIsToldAndEndsWithItsCode_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<int>("exitCode");
    QTest::newRow("a row cut short") << "cut-in-a-number.csv" << 4;
    QTest::newRow("compressed data cut short") << "gzip-cut-in-a-row.csv.gz" << 4;
    QTest::newRow("sound") << "fine-crlf.csv" << 0;
}

void WindowProgramTest::aDamagedFileIsToldAndEndsWithItsCode()
{
    QFETCH(QString, file);
    QFETCH(int, exitCode);
    const QString path = QStringLiteral(PLANEWRIGHT_SOURCE_DIR "/tests/core/formats/malformed/") + file;
    const QString picture = at(file + ".png");
    const QString script = write("damaged.ndjson", R"({"do":"open","file":")" + path.toUtf8() + R"("}
{"do":"wait","state":"review"}
)");

    const Run named = run({path, "--screenshot", picture, "--size", "320x240"});
    const Run scripted = run({"--script", script});

    QVERIFY(QFile::exists(picture));
    for (const Run& done : {named, scripted}) {
        QCOMPARE(done.exitCode, exitCode);
        QCOMPARE(done.err.count("planewright: warning: " + path), exitCode == 4 ? 1 : 0);
    }
}

void WindowProgramTest::dialogsAreOpenForAScript()
{
    const QString script = write("dialogs.ndjson", R"({"do":"action","name":"actPreferences"}
{"do":"expect","object":"preferencesDialog","property":"visible","equals":true}
{"do":"set","object":"preferencesSearch","property":"text","value":"palette"}
{"do":"expect","object":"preferencesSearch","property":"text","equals":"palette"}
{"do":"screenshot","file":")" + at("open.png").toUtf8() +
                                                       R"(","window":true}
{"do":"set","object":"preferencesDialog","property":"visible","value":false}
{"do":"screenshot","file":")" + at("left.png").toUtf8() +
                                                       R"(","window":true}
{"do":"action","name":"actShortcuts"}
{"do":"set","object":"shortcutsDialog","property":"visible","value":false}
{"do":"action","name":"actCommandPalette"}
{"do":"set","object":"commandPalette","property":"visible","value":false}
{"do":"action","name":"actManual"}
{"do":"set","object":"pageDialog","property":"visible","value":false}
{"do":"action","name":"actAbout"}
{"do":"set","object":"aboutDialog","property":"visible","value":false}
{"do":"expect","object":"aboutDialog","property":"visible","equals":true}
)");

    const Run done = run({"--script", script});

    // All lines were good but the last: nothing is left open.
    QCOMPARE(done.exitCode, 8);
    QVERIFY2(done.err.contains("dialogs.ndjson:16: there is no object aboutDialog"), qPrintable(done.err));
    const QImage open(at("open.png"));
    const QImage left(at("left.png"));
    QCOMPARE(open.size(), left.size());
    QVERIFY(open.copy(open.width() / 2 - 100, open.height() / 2 - 100, 200, 200) !=
            left.copy(left.width() / 2 - 100, left.height() / 2 - 100, 200, 200));
}

void WindowProgramTest::anActionThatWaitsForAnAnswerFails()
{
    const Run done = run({"--script", write("asks.ndjson", R"({"do":"action","name":"actOpen"}
)")});

    QCOMPARE(done.exitCode, 8);
    QVERIFY2(done.err.contains("asks.ndjson:1: actOpen waits for an answer in \"Open a recording\""),
             qPrintable(done.err));
}

void WindowProgramTest::theWindowIsAsLargeAsItsPicture()
{
    const QString script = write("size.ndjson", R"({"do":"screenshot","file":")" + at("large.png").toUtf8() +
                                                    R"(","size":"1500x1000","window":true}
{"do":"expect","object":"mainWindow","property":"width","equals":1440}
{"do":"screenshot","file":")" + at("small.png").toUtf8() +
                                                    R"(","size":"400x300","window":true}
)");

    const Run done = run({"--script", script});

    QCOMPARE(QImage(at("large.png")).size(), QSize(1500, 1000));
    QCOMPARE(done.exitCode, 8);
    QVERIFY2(done.err.contains("size.ndjson:3: the window cannot be 400x300"), qPrintable(done.err));
    QVERIFY(!QFile::exists(at("small.png")));
}

void WindowProgramTest::stepsOfAScriptAreStepsOfTheScan_data()
{
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<QString>("said");
    const auto row = [](const char* line, const char* said) { QTest::newRow(line) << QByteArray(line) << said; };
    row(R"({"do":"goto","step":9})", "");
    row(R"({"do":"goto","step":10})", "there is no step 10; the scan has steps 0 to 9");
    row(R"({"do":"goto","step":-5})", "there is no step -5");
    row(R"({"do":"goto","step":6.5})", "goto needs a whole number");
    row(R"({"do":"goto","step":1e12})", "goto needs a whole number");
    row(R"({"do":"select","plane":0.5})", "there is no plane 0.5");
}

void WindowProgramTest::stepsOfAScriptAreStepsOfTheScan()
{
    QFETCH(QByteArray, line);
    QFETCH(QString, said);
    const QString file = PLANEWRIGHT_SOURCE_DIR "/tests/core/formats/malformed/fine-equal-times-and-gap.csv";

    const Run done = run({"--script", write("steps.ndjson", R"({"do":"open","file":")" + file.toUtf8() + R"("}
{"do":"wait","state":"review"}
)" + line + "\n")});

    QCOMPARE(done.exitCode, said.isEmpty() ? 0 : 8);
    QVERIFY2(said.isEmpty() || done.err.contains("steps.ndjson:3: " + said), qPrintable(done.err));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::WindowProgramTest)
#include "window_program_test.moc"
