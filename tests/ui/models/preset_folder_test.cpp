// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/preset_folder.h"

#include <QTemporaryDir>
#include <QtTest>

#include "tests/test_program.h"
#include "ui/models/parameter_model.h"

namespace planewright {

class PresetFolderTest : public QObject {
    Q_OBJECT

private slots:
    void aPresetSavedIsThereAtTheNextStart();
    void whatIsNoPresetIsNamedAndPassedBy();
    void aFolderThatCannotBeMadeIsAnError();
    void aFolderThatIsNotThereHasNoPresets();
};

void PresetFolderTest::aPresetSavedIsThereAtTheNextStart()
{
    const QTemporaryDir home;
    const PresetFolder folder(home.filePath("presets"));
    Parameters parameters;
    parameters.planes.flatness = 0.07;

    QVERIFY(folder.save("Brick walls", parameters));
    ParameterModel model;
    QCOMPARE(folder.load(model), QStringList());

    model.setPreset("Brick walls");
    QCOMPARE(model.parameters().planes.flatness, 0.07);
}

void PresetFolderTest::whatIsNoPresetIsNamedAndPassedBy()
{
    const QTemporaryDir home;
    QFile file(home.filePath("broken.json"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("{");
    file.close();
    ParameterModel model;

    const QStringList problems = PresetFolder(home.path()).load(model);

    QCOMPARE(problems.size(), 1);
    QVERIFY2(problems[0].contains("broken.json"), qPrintable(problems[0]));
    QCOMPARE(model.presetNames().size(), 2);
}

void PresetFolderTest::aFolderThatCannotBeMadeIsAnError()
{
    const QTemporaryDir home;
    QFile file(home.filePath("file"));
    QVERIFY(file.open(QIODevice::WriteOnly));

    const auto saved = PresetFolder(home.filePath("file/presets")).save("x", {});

    QVERIFY(!saved);
    QCOMPARE(saved.error().code, ErrorCode::NotWritten);
}

void PresetFolderTest::aFolderThatIsNotThereHasNoPresets()
{
    const QTemporaryDir home;
    ParameterModel model;

    QCOMPARE(PresetFolder(home.filePath("none")).load(model), QStringList());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::PresetFolderTest)
#include "preset_folder_test.moc"
