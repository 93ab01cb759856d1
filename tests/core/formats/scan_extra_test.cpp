// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/scan_extra.h"

#include <QTest>

#include "tests/test_program.h"

using namespace planewright;

class ScanExtraTest : public QObject {
    Q_OBJECT

private slots:
    void keysKeepTheirOrder();
    void otherValuesComeAsJson();
    void keysThatNoHeaderLineCanHoldAreLeftOut();
    void whatIsNoObjectIsRefused_data();
    void whatIsNoObjectIsRefused();
};

void ScanExtraTest::keysKeepTheirOrder()
{
    const ExtraKeys keys{{"zebra", "a \"b\""}, {"ant", ""}, {"m\u00f6we", "2,5"}};

    QCOMPARE(extraJson(keys), std::string("{\"zebra\":\"a \\\"b\\\"\",\"ant\":\"\",\"m\u00f6we\":\"2,5\"}"));
    QCOMPARE(*readExtraJson(extraJson(keys), "here"), keys);
}

void ScanExtraTest::otherValuesComeAsJson()
{
    const auto keys = readExtraJson(R"({"plan":{"slices":137,"beams":[1,2]},"warm":true})", "here");

    QCOMPARE(*keys, (ExtraKeys{{"plan", R"({"beams":[1,2],"slices":137})"}, {"warm", "true"}}));
}

void ScanExtraTest::keysThatNoHeaderLineCanHoldAreLeftOut()
{
    const auto keys = readExtraJson(R"({"beams":"7","a=b":"1"," c":"2","":"3","d\n":"4","kept":"5"})", "here");

    QCOMPARE(*keys, (ExtraKeys{{"kept", "5"}}));
}

void ScanExtraTest::whatIsNoObjectIsRefused_data()
{
    QTest::addColumn<QString>("text");
    QTest::newRow("empty") << "";
    QTest::newRow("a list") << "[1]";
    QTest::newRow("half") << R"({"a":)";
    QTest::newRow("a key twice") << R"({"a":"1","a":"2"})";
    QTest::newRow("deep") << R"({"a":)" + QString("[").repeated(100);
    QString many = "{";
    for (int i = 0; i <= 1000; ++i)
        many += (i == 0 ? "\"" : ",\"") + QString::number(i) + "\":1";
    QTest::newRow("many") << many + "}";
}

void ScanExtraTest::whatIsNoObjectIsRefused()
{
    QFETCH(QString, text);

    const auto keys = readExtraJson(text.toStdString(), "here");

    QVERIFY(!keys);
    QVERIFY(keys.error().code == ErrorCode::Unreadable);
    QVERIFY(keys.error().message.starts_with("here: "));
}

PLANEWRIGHT_TEST(ScanExtraTest)
#include "scan_extra_test.moc"
