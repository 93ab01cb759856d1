// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include "core/params/manual_page.h"
#include "core/params/presets.h"
#include "core/params/registry.h"
#include "run_program.h"
#include "tests/test_program.h"

using namespace planewright;

class CliParamsTest : public QObject {
    Q_OBJECT

private slots:
    void listsEveryParameterWithItsDefault();
    void jsonHasARowForEveryParameter();
    void showsOne();
    void showsTheValueInForce();
    void parametersOfMapsAreShownAndSetLikeAll();
    void unknownKeyIsAnErrorThatSuggestsOne();
    void markdownIsThePageOfTheManual();
};

void CliParamsTest::listsEveryParameterWithItsDefault()
{
    const ProgramRun run = runProgram({"params"});
    const QStringList lines = QString::fromUtf8(run.out).split('\n', Qt::SkipEmptyParts);

    QCOMPARE(run.code, 0);
    Parameters defaults;
    apply(methodPresets().front(), defaults);
    QCOMPARE(lines.size(), static_cast<qsizetype>(parameterRows().size() + mappingRows().size()) + 1);
    for (std::size_t i = 0; i < parameterRows().size(); ++i) {
        const ParameterRow& row = parameterRows()[i];
        const QStringList words = lines[static_cast<qsizetype>(i) + 1].split(' ', Qt::SkipEmptyParts);
        QCOMPARE(words[0].toStdString(), std::string{row.key});
        QCOMPARE(words[1].toStdString(), printParameter(defaults, row.key));
    }
    // Those of maps come last: walls are even to 2 mm.
    QCOMPARE(lines[static_cast<qsizetype>(parameterRows().size()) + 1].split(' ', Qt::SkipEmptyParts).mid(0, 3),
             QStringList({"map.flatness", "0.002", "m"}));
    QCOMPARE(runProgram({"params", "list"}).out, run.out);
}

void CliParamsTest::jsonHasARowForEveryParameter()
{
    const ProgramRun run = runProgram({"params", "--json"});
    const QJsonArray rows = QJsonDocument::fromJson(run.out).array();

    QCOMPARE(run.code, 0);
    QCOMPARE(rows.size(), static_cast<qsizetype>(parameterRows().size() + mappingRows().size()));
    for (const auto& row : rows) {
        for (const char* key : {"key", "value", "unit", "symbol", "meaning"})
            QVERIFY(row.toObject().contains(key));
        QVERIFY(row.toObject().contains("range") != row.toObject().contains("choices"));
    }
    QCOMPARE(runProgram({"params", "list", "--json"}).out, run.out);
}

void CliParamsTest::showsOne()
{
    const ProgramRun run = runProgram({"params", "show", "segments.min-length", "--preset", "paper"});

    QCOMPARE(run.code, 0);
    QCOMPARE(run.out, QByteArray("key      segments.min-length\n"
                                 "value    0.2\n"
                                 "unit     m\n"
                                 "range    0 to 10\n"
                                 "symbol   L_min\n"
                                 "meaning  Shorter segments are removed, Eq. (5).\n"));
}

void CliParamsTest::showsTheValueInForce()
{
    const ProgramRun run =
        runProgram({"params", "show", "noise.pitch", "--json", "--sensor", "urg-04lx", "-P", "noise.bearing=1"});

    QCOMPARE(run.code, 0);
    QCOMPARE(QJsonDocument::fromJson(run.out)["value"].toDouble(), 0.15);
}

void CliParamsTest::parametersOfMapsAreShownAndSetLikeAll()
{
    const ProgramRun set = runProgram({"params", "show", "map.search-tilt", "--json", "-P", "map.search-tilt=7.5"});
    const ProgramRun beyond = runProgram({"params", "-P", "map.least-pairs=2.5"});

    QCOMPARE(set.code, 0);
    QCOMPARE(QJsonDocument::fromJson(set.out)["value"].toDouble(), 7.5);
    QCOMPARE(QJsonDocument::fromJson(set.out)["unit"].toString(), "deg");
    QCOMPARE(beyond.code, 2);
    QCOMPARE(beyond.err,
             QByteArray("planewright-cli: -P: parameter map.least-pairs: '2.5' is not allowed; give a whole "
                        "number from 1 to 50\n"));
}

void CliParamsTest::unknownKeyIsAnErrorThatSuggestsOne()
{
    const ProgramRun run = runProgram({"params", "show", "segments.min-lenght"});

    QCOMPARE(run.code, 2);
    QCOMPARE(run.err, QByteArray("planewright-cli: there is no parameter 'segments.min-lenght'; did you mean "
                                 "segments.min-length? 'planewright-cli params' lists all\n"));
}

void CliParamsTest::markdownIsThePageOfTheManual()
{
    const ProgramRun run = runProgram({"params", "list", "--markdown"});

    QCOMPARE(run.code, 0);
    QCOMPARE(run.out.toStdString(), parameterManualPage());
}

PLANEWRIGHT_TEST(CliParamsTest)
#include "cli_params_test.moc"
