// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/params/manual_page.h"

#include <QFile>
#include <QtTest>

#include "core/params/presets.h"
#include "core/params/registry.h"
#include "tests/test_program.h"

namespace planewright {

class ManualPageTest : public QObject {
    Q_OBJECT

private slots:
    void thePageInTheManualIsUpToDate();
    void everyParameterHasARowWithItsValuesAndMeaning();
    void everyPresetIsNamed();
    void everyTableRowHasAsManyCellsAsItsHeading();
};

void ManualPageTest::thePageInTheManualIsUpToDate()
{
    QFile file(PLANEWRIGHT_SOURCE_DIR "/resources/manual/parameters.md");
    QVERIFY2(file.open(QIODevice::ReadOnly), qPrintable(file.fileName() + ": " + file.errorString()));

    const QByteArray onDisk = file.readAll();

    QVERIFY2(onDisk == QByteArray::fromStdString(parameterManualPage()),
             "resources/manual/parameters.md is stale; make it anew from the top of the source tree with\n"
             "    planewright-cli params list --markdown > resources/manual/parameters.md");
}

void ManualPageTest::everyParameterHasARowWithItsValuesAndMeaning()
{
    const QString page = QString::fromStdString(parameterManualPage());

    for (const ParameterRow& row : parameterRows()) {
        const QString key = QString::fromUtf8(row.key.data(), static_cast<qsizetype>(row.key.size()));
        const QStringList rows = page.split('\n').filter("| `" + key + "` |");
        QVERIFY2(rows.size() == 1, qPrintable(key));
        QStringList cells = rows.front().split(" | ");
        for (std::size_t i = 0; i < methodPresets().size(); ++i) {
            Parameters parameters;
            apply(methodPresets()[i], parameters);
            QCOMPARE(cells.at(static_cast<qsizetype>(i) + 1).toStdString(),
                     "`" + printParameter(parameters, row.key) + "`");
        }
        QVERIFY(rows.front().endsWith(QString::fromStdString(" " + std::string{row.meaning} + " |")));
    }
    for (const ParameterRow& row : mappingRows()) {
        const std::string value = printParameter(MappingParameters{}, row.key);
        QVERIFY(page.contains(QString::fromStdString("| `" + std::string{row.key} + "` | `" + value + "` |")));
        QVERIFY(page.contains(QString::fromStdString(" " + std::string{row.meaning} + " |\n")));
    }
}

void ManualPageTest::everyPresetIsNamed()
{
    const QString page = QString::fromStdString(parameterManualPage());

    for (const auto* presets : {&methodPresets(), &sensorPresets()}) {
        for (const Preset& preset : *presets)
            QVERIFY(page.contains(QString::fromStdString("| `" + std::string{preset.name} + "` |")));
    }
}

void ManualPageTest::everyTableRowHasAsManyCellsAsItsHeading()
{
    qsizetype bars = 0;
    for (QString line : QString::fromStdString(parameterManualPage()).split('\n')) {
        const qsizetype here = line.remove("\\|").count('|');
        if (bars != 0 && here != 0)
            QVERIFY2(here == bars, qPrintable(line));
        bars = here;
    }
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ManualPageTest)
#include "manual_page_test.moc"
