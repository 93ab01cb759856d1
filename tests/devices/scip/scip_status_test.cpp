// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/scip/scip_status.h"

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class ScipStatusTest : public QObject {
    Q_OBJECT

private slots:
    void statusesMeanWhatTheyDo_data();
    void statusesMeanWhatTheyDo();
    void version22ReusesLetters();
    void onlyNumbersAreInARangeOfNumbers();
    void theVersionIsThatOfTheProtocol();
    void peopleAreToldCodeAndMeaning();
};

void ScipStatusTest::statusesMeanWhatTheyDo_data()
{
    QTest::addColumn<QString>("command");
    QTest::addColumn<QString>("status");
    QTest::addColumn<int>("verdict");
    const auto row = [](const char* command, const char* status, ScipVerdict verdict) {
        QTest::addRow("%s %s", command, status) << QString{command} << QString{status} << static_cast<int>(verdict);
    };
    row("VV", "00", ScipVerdict::Good);
    row("MD", "99", ScipVerdict::Good);
    row("VV", "99", ScipVerdict::Refused);
    row("BM", "01", ScipVerdict::Malfunction);
    row("BM", "02", ScipVerdict::AlreadySo);
    row("QT", "0E", ScipVerdict::Refused);
    row("QT", "E", ScipVerdict::Refused);
    row("SCIP2.0", "0", ScipVerdict::Good);
    row("RB", "01", ScipVerdict::Good);
    row("TM", "02", ScipVerdict::AlreadySo);
    row("TM", "03", ScipVerdict::AlreadySo);
    row("TM", "04", ScipVerdict::Refused);
    row("TM", "10", ScipVerdict::NotNow);
    row("CR", "04", ScipVerdict::Refused);
    row("SS", "03", ScipVerdict::AlreadySo);
    row("HS", "03", ScipVerdict::Refused);
    for (const char* const status : {"01", "02", "03", "04", "05", "06", "07"})
        row("ME", status, ScipVerdict::Refused);
    row("GD", "10", ScipVerdict::Refused);
    row("MD", "10", ScipVerdict::NotNow);
    row("MD", "20", ScipVerdict::Refused);
    row("MD", "21", ScipVerdict::Verifying);
    row("MD", "49", ScipVerdict::Verifying);
    row("MD", "50", ScipVerdict::Malfunction);
    row("GE", "97", ScipVerdict::Malfunction);
    row("MD", "98", ScipVerdict::Resumed);
    row("VV", "0L", ScipVerdict::Malfunction);
    row("VV", "0M", ScipVerdict::NotNow);
    row("VV", "0B", ScipVerdict::NotNow);
    row("VV", "77", ScipVerdict::Refused);
}

void ScipStatusTest::statusesMeanWhatTheyDo()
{
    QFETCH(QString, command);
    QFETCH(QString, status);
    QFETCH(int, verdict);

    for (const ScipVersion version : {ScipVersion::V2_0, ScipVersion::V2_2})
        QCOMPARE(static_cast<int>(scipMeaning(command.toStdString(), status.toStdString(), version).verdict), verdict);
}

void ScipStatusTest::version22ReusesLetters()
{
    const auto text = [](const char* status, ScipVersion version) {
        return std::string{scipMeaning("VV", status, version).text};
    };
    for (const char* const status : {"0D", "0F", "0H"})
        QVERIFY(text(status, ScipVersion::V2_0) != text(status, ScipVersion::V2_2));
    QCOMPARE(text("0F", ScipVersion::V2_2), std::string{"this model cannot do that"});
    QCOMPARE(text("0H", ScipVersion::V2_2), text("0C", ScipVersion::V2_2));
    QCOMPARE(text("0F", ScipVersion::V2_0), text("0C", ScipVersion::V2_0));
    QCOMPARE(text("0D", ScipVersion::V2_0), text("0E", ScipVersion::V2_0));
    QCOMPARE(text("0I", ScipVersion::V2_2), std::string{"no meaning is known"});
}

void ScipStatusTest::onlyNumbersAreInARangeOfNumbers()
{
    QCOMPARE(scipMeaning("MD", "3A", ScipVersion::V2_0).verdict, ScipVerdict::Refused);
    QCOMPARE(scipMeaning("MD", "5", ScipVersion::V2_0).verdict, ScipVerdict::Refused);
    QCOMPARE(scipMeaning("MD", "", ScipVersion::V2_0).verdict, ScipVerdict::Refused);
}

void ScipStatusTest::theVersionIsThatOfTheProtocol()
{
    QCOMPARE(scipVersionOf("SCIP 2.0"), ScipVersion::V2_0);
    QCOMPARE(scipVersionOf("SCIP 2.2"), ScipVersion::V2_2);
    QCOMPARE(scipVersionOf(""), ScipVersion::V2_0);
}

void ScipStatusTest::peopleAreToldCodeAndMeaning()
{
    QCOMPARE(describeScipStatus("BM", "01", ScipVersion::V2_0),
             std::string{"status 01: the laser cannot be switched on: it is faulty"});
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ScipStatusTest)
#include "scip_status_test.moc"
