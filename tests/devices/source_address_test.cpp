// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/source_address.h"

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class SourceAddressTest : public QObject {
    Q_OBJECT

private slots:
    void aSceneHasSeedAndSpeed();
    void optionsHaveDefaults();
    void aReplayHasASpeed();
    void aLaserIsASource();
    void aPlainNameIsAFileWhateverIsInIt_data();
    void aPlainNameIsAFileWhateverIsInIt();
    void aReplayedFileMayHaveAQuestionMarkInItsName();
    void whatIsWrongIsNamed_data();
    void whatIsWrongIsNamed();
};

void SourceAddressTest::aSceneHasSeedAndSpeed()
{
    const auto address = parseSourceAddress("sim:office?seed=18446744073709551615&speed=0.5");

    QVERIFY(address);
    QCOMPARE(address->kind, SourceAddress::Kind::Simulation);
    QCOMPARE(address->name, std::string("office"));
    QCOMPARE(address->seed, std::uint64_t{18446744073709551615ULL});
    QCOMPARE(address->speed, 0.5);
}

void SourceAddressTest::optionsHaveDefaults()
{
    for (const char* text : {"sim:office", "sim:office?"}) {
        const auto address = parseSourceAddress(text);

        QVERIFY(address);
        QCOMPARE(address->name, std::string("office"));
        QCOMPARE(address->seed, std::uint64_t{1});
        QCOMPARE(address->speed, 1.0);
    }
}

void SourceAddressTest::aReplayHasASpeed()
{
    const auto address = parseSourceAddress("replay:scans/lobby.csv.gz?speed=0");

    QVERIFY(address);
    QCOMPARE(address->kind, SourceAddress::Kind::Replay);
    QCOMPARE(address->name, std::string("scans/lobby.csv.gz"));
    QCOMPARE(address->speed, 0.0);
}

void SourceAddressTest::aLaserIsASource()
{
    const auto address = parseSourceAddress("tcp:192.168.0.10:10940");

    QVERIFY(address);
    QCOMPARE(address->kind, SourceAddress::Kind::Laser);
    QCOMPARE(address->name, std::string("tcp:192.168.0.10:10940"));
    QCOMPARE(address->laser.link, DeviceAddress::Link::Tcp);
    QCOMPARE(address->laser.name, std::string("192.168.0.10"));
    QCOMPARE(address->laser.port, std::uint16_t{10940});
}

void SourceAddressTest::aPlainNameIsAFileWhateverIsInIt_data()
{
    QTest::addColumn<QByteArray>("text");
    for (const char* text : {"lobby.csv", "/tmp/a?speed=2", "simulated.csv", "what:ever.csv", "a&b=c"})
        QTest::newRow(text) << QByteArray(text);
}

void SourceAddressTest::aPlainNameIsAFileWhateverIsInIt()
{
    QFETCH(QByteArray, text);

    const auto address = parseSourceAddress(text.toStdString());

    QVERIFY(address);
    QCOMPARE(address->kind, SourceAddress::Kind::File);
    QCOMPARE(address->name, text.toStdString());
}

void SourceAddressTest::aReplayedFileMayHaveAQuestionMarkInItsName()
{
    const auto address = parseSourceAddress("replay:why?.csv?");

    QVERIFY(address);
    QCOMPARE(address->name, std::string("why?.csv"));
}

void SourceAddressTest::whatIsWrongIsNamed_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("says");
    const auto row = [](const char* text, const char* says) {
        QTest::newRow(*text == '\0' ? "nothing" : text) << QByteArray(text) << QByteArray(says);
    };
    row("", "name of a file");
    row("sim:", "give a scene");
    row("replay:", "name of a file");
    row("replay:?speed=1", "name of a file");
    row("sim:hall?sped=1", "no option 'sped'; known: seed, speed");
    row("replay:a.csv?seed=1", "no option 'seed'; known: speed");
    row("sim:hall?seed", "seed ''");
    row("sim:hall?seed=", "seed ''");
    row("sim:hall?seed=-1", "seed '-1'");
    row("sim:hall?seed=1.5", "seed '1.5'");
    row("sim:hall?seed=18446744073709551616", "seed '18446744073709551616'");
    row("sim:hall?seed=1&seed=2", "'seed' is given twice");
    row("sim:hall?speed=fast", "speed 'fast'");
    row("sim:hall?speed=-1", "speed '-1'");
    row("sim:hall?speed=nan", "speed 'nan'");
    row("sim:hall?speed=inf", "speed 'inf'");
    row("sim:hall?speed=1e9", "speed '1e9'");
    row("sim:hall?&speed=1", "no option ''");
    row("tcp:10.0.0.2", "give a port, too, as in 10.0.0.2:10940");
    row("usb:?baud=9600", "no option 'baud'; such an address has none");
    row("dynamixel:usb:", "is a tilt unit; the scanner is its laser");
    row("board:serial:/dev/ttyACM0", "is a tilt unit; the scanner is its laser");
}

void SourceAddressTest::whatIsWrongIsNamed()
{
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, says);

    const auto address = parseSourceAddress(text.toStdString());

    QVERIFY(!address);
    QCOMPARE(address.error().code, ErrorCode::Usage);
    QVERIFY2(address.error().message.starts_with("'" + text.toStdString() + "': "), address.error().message.c_str());
    QVERIFY2(address.error().message.find(says.toStdString()) != std::string::npos, address.error().message.c_str());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::SourceAddressTest)
#include "source_address_test.moc"
