// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/parameter_model.h"

#include <QSet>
#include <QSignalSpy>
#include <QtTest>

#include "core/params/presets.h"
#include "tests/test_program.h"

namespace planewright {

class ParameterModelTest : public QObject {
    Q_OBJECT

private slots:
    void groupsFollowTheAlgorithmAndHoldEveryParameterOnce();
    void labelsAndSymbolsAreForPeople();
    void itBeginsWithTheDefaultPreset();
    void aTextIsTakenInTheUnitThatPeopleSee();
    void whatIsNotAllowedSaysWhatIsAndChangesNothing();
    void changesAreHeldAgainstThePreset();
    void aPresetSetsAllItsValues();
    void theUsersPresetsComeAfterThePrograms();
    void namesOfPresetsAreChecked_data();
    void namesOfPresetsAreChecked();
    void theSameParametersAreNoChange();
};

void ParameterModelTest::groupsFollowTheAlgorithmAndHoldEveryParameterOnce()
{
    QStringList titles;
    QSet<QString> keys;
    std::size_t rows = 0;
    for (const ParameterGroup& group : parameterGroups()) {
        titles << group.title;
        QVERIFY2(!group.rows.empty(), qPrintable(group.title));
        rows += group.rows.size();
        for (const ParameterRow* row : group.rows)
            keys << QString::fromLatin1(row->key.data(), static_cast<qsizetype>(row->key.size()));
    }

    QCOMPARE(titles, (QStringList{"Method", "Breakpoints", "Segments", "3D geometry", "Scanner corrections", "Assign",
                                  "Clusters", "Fit", "Split and merge", "Likelihood", "Schedule"}));
    QCOMPARE(rows, parameterRows().size());
    QCOMPARE(static_cast<std::size_t>(keys.size()), parameterRows().size());
}

void ParameterModelTest::labelsAndSymbolsAreForPeople()
{
    const auto row = [](std::string_view key) {
        for (const ParameterRow& r : parameterRows()) {
            if (r.key == key)
                return r;
        }
        return ParameterRow{};
    };

    QCOMPARE(parameterLabel(row("segments.split-distance")), QStringLiteral("Split distance"));
    QCOMPARE(parameterSymbol(row("segments.incidence-limit")), QStringLiteral("λ<sub>u</sub>"));
    QCOMPARE(parameterSymbol(row("noise.range-constant")), QStringLiteral("σ<sub>ρ,0</sub>"));
    QCOMPARE(parameterSymbol(row("planes.refine-tolerance")), QStringLiteral("ε<sub>min</sub>"));
    QCOMPARE(parameterSymbol(row("planes.merge-distance")), QStringLiteral("δ<sub>Π</sub>"));
    QCOMPARE(parameterSymbol(row("schedule.fit-every")), QString());
    QCOMPARE(parameterUnit(row("segments.incidence-limit")), QStringLiteral("°"));
    QCOMPARE(parameterUnit(row("segments.split-distance")), QStringLiteral("m"));
}

void ParameterModelTest::itBeginsWithTheDefaultPreset()
{
    const ParameterModel model;

    QCOMPARE(model.preset(), QStringLiteral("precise"));
    QCOMPARE(model.text("method.estimator"), QStringLiteral("likelihood"));
    QVERIFY(!model.isAnyChanged());
}

void ParameterModelTest::aTextIsTakenInTheUnitThatPeopleSee()
{
    ParameterModel model;
    QSignalSpy changed(&model, &ParameterModel::parametersChanged);

    QCOMPARE(model.setText("segments.incidence-limit", " 30 "), QString());

    QCOMPARE(changed.size(), 1);
    QVERIFY(std::abs(model.parameters().segments.incidenceLimit - degrees(30.0)) < 1e-12);
    QCOMPARE(model.text("segments.incidence-limit"), QStringLiteral("30"));
}

void ParameterModelTest::whatIsNotAllowedSaysWhatIsAndChangesNothing()
{
    ParameterModel model;
    QSignalSpy changed(&model, &ParameterModel::parametersChanged);
    const QString before = model.text("segments.split-distance");

    QCOMPARE(model.setText("segments.split-distance", "9"), QStringLiteral("Give a number from 0 to 0.5 m."));
    QCOMPARE(model.setText("segments.split-distance", "0,1"), QStringLiteral("Give a number from 0 to 0.5 m."));
    QCOMPARE(model.setText("schedule.fit-every", "2.5"), QStringLiteral("Give a whole number from 1 to 65536."));
    QCOMPARE(model.setText("planes.cost", "x"), QStringLiteral("Give ml or foot."));

    QCOMPARE(model.text("segments.split-distance"), before);
    QCOMPARE(changed.size(), 0);
}

void ParameterModelTest::changesAreHeldAgainstThePreset()
{
    ParameterModel model;
    const QString before = model.text("planes.flatness");

    model.setText("planes.flatness", "0.02");
    QVERIFY(model.isChanged("planes.flatness"));
    QVERIFY(!model.isChanged("planes.cost"));
    model.reset("planes.flatness");

    QCOMPARE(model.text("planes.flatness"), before);
    QVERIFY(!model.isAnyChanged());
}

void ParameterModelTest::aPresetSetsAllItsValues()
{
    ParameterModel model;
    model.setText("planes.flatness", "0.02");

    model.setPreset("paper");

    QVERIFY(!model.isAnyChanged());
    QCOMPARE(model.text("planes.flatness"), QStringLiteral("0.005"));
    QCOMPARE(model.text("method.estimator"), QStringLiteral("end-points"));
    model.setPreset("no such preset");
    QCOMPARE(model.preset(), QStringLiteral("paper"));
}

void ParameterModelTest::theUsersPresetsComeAfterThePrograms()
{
    ParameterModel model;
    QSignalSpy changed(&model, &ParameterModel::presetsChanged);
    Parameters parameters;
    parameters.planes.flatness = 0.07;

    QCOMPARE(model.addPreset(" Brick walls ", parameters), QString());

    QCOMPARE(changed.size(), 1);
    QCOMPARE(model.presetNames(), (QStringList{"precise", "paper", "Brick walls"}));
    model.setPreset("Brick walls");
    QCOMPARE(model.text("planes.flatness"), QStringLiteral("0.07"));
}

void ParameterModelTest::namesOfPresetsAreChecked_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<bool>("allowed");
    QTest::newRow("a name") << "Brick walls, 2nd floor" << true;
    QTest::newRow("none") << "  " << false;
    QTest::newRow("the program's") << "paper" << false;
    QTest::newRow("a folder") << "../x" << false;
    QTest::newRow("hidden") << ".x" << false;
    QTest::newRow("too long") << QString(61, 'x') << false;
}

void ParameterModelTest::namesOfPresetsAreChecked()
{
    QFETCH(QString, name);
    QFETCH(bool, allowed);
    ParameterModel model;

    QCOMPARE(model.addPreset(name, {}).isEmpty(), allowed);
    QCOMPARE(model.presetNames().size(), allowed ? 3 : 2);
}

void ParameterModelTest::theSameParametersAreNoChange()
{
    ParameterModel model;
    QSignalSpy changed(&model, &ParameterModel::parametersChanged);

    model.setParameters(model.parameters());
    model.setText("planes.cost", model.text("planes.cost"));
    QCOMPARE(changed.size(), 0);
    model.setParameters(Parameters{});

    QCOMPARE(changed.size(), 1);
    QVERIFY(model.isAnyChanged());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ParameterModelTest)
#include "parameter_model_test.moc"
