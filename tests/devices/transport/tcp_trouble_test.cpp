// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/tcp_trouble.h"

#include <cerrno>

#include <QtTest>

#include "devices/clock.h"
#include "tests/test_program.h"

namespace planewright {

class TcpTroubleTest : public QObject {
    Q_OBJECT

private slots:
    void whyThereIsNoConnectionIsToldWithWhatToDo_data();
    void whyThereIsNoConnectionIsToldWithWhatToDo();
    void whatHasAnsweredBeforeIsNotAnotherProgramsNow();
    void aHostInThisNetworkIsNotBlamedOnTheNetwork();
    void aNumberOfVersion6IsNotBlamedOnTheNetwork();
    void theAddressProposedIsNotTheHostsOwn();
    void whyAConnectionIsOverIsToldWithWhatToDo_data();
    void whyAConnectionIsOverIsToldWithWhatToDo();
    void hostsArePutIntoBracketsWhereTheyHaveColons();
};

namespace {

HostAddress address(const std::string& host)
{
    return resolveHost(host, 10940, steadyClock(), std::chrono::nanoseconds{0}, {}).value().at(0);
}

constexpr OwnNetwork kOffice{0x0A00020F, 0xFFFFFF00};  // 10.0.2.15/24
constexpr OwnNetwork kBench{0xC0A80005, 0xFFFF0000};   // 192.168.0.5/16

}  // namespace

void TcpTroubleTest::whyThereIsNoConnectionIsToldWithWhatToDo_data()
{
    QTest::addColumn<int>("error");
    QTest::addColumn<QByteArray>("says");
    const auto row = [](const char* name, int error, const char* says) {
        QTest::newRow(name) << error << QByteArray(says);
    };
    row("refused", ECONNREFUSED, "one client at a time");
    row("firewall", EACCES, "firewall");
    row("silent", ETIMEDOUT, "does not answer; check its power, its cable");
    row("no route", EHOSTUNREACH, "cannot be reached from here");
    row("no network", ENETUNREACH, "cannot be reached from here");
    row("wrong subnet", ETIMEDOUT,
        "in another network (10.0.2.15/24): give its network card an address such as 192.168.0.100/24");
    row("anything else", EAFNOSUPPORT, "check the address");
}

void TcpTroubleTest::whyThereIsNoConnectionIsToldWithWhatToDo()
{
    QFETCH(int, error);
    QFETCH(QByteArray, says);

    const std::string text = connectTroubleText(error, address("192.168.0.10"), std::vector{kOffice});

    QVERIFY2(text.find(says.toStdString()) != std::string::npos, text.c_str());
    QVERIFY2(text.find("laser") == std::string::npos, text.c_str());  // it may be a servo's adapter, or a board
}

void TcpTroubleTest::whatHasAnsweredBeforeIsNotAnotherProgramsNow()
{
    const std::string text = connectTroubleText(ECONNREFUSED, address("192.168.0.10"), std::vector{kOffice}, true);

    QVERIFY2(text.starts_with("nothing answers there yet"), text.c_str());
    QVERIFY2(text.find("program") == std::string::npos, text.c_str());
}

void TcpTroubleTest::aHostInThisNetworkIsNotBlamedOnTheNetwork()
{
    const std::string text = connectTroubleText(ETIMEDOUT, address("192.168.7.10"), std::vector{kOffice, kBench});

    QCOMPARE(text, std::string("does not answer; check its power, its cable and the address"));
}

void TcpTroubleTest::aNumberOfVersion6IsNotBlamedOnTheNetwork()
{
    const std::string text = connectTroubleText(ETIMEDOUT, address("2001:db8::1"), std::vector{kOffice});

    QCOMPARE(text, std::string("does not answer; check its power, its cable and the address"));
}

void TcpTroubleTest::theAddressProposedIsNotTheHostsOwn()
{
    const std::string text = connectTroubleText(ETIMEDOUT, address("172.16.3.100"), {});

    QVERIFY2(text.ends_with("(it has no address): give its network card an address such as 172.16.3.101/24"),
             text.c_str());
}

void TcpTroubleTest::whyAConnectionIsOverIsToldWithWhatToDo_data()
{
    QTest::addColumn<int>("error");
    QTest::addColumn<bool>("anythingCame");
    QTest::addColumn<QByteArray>("says");
    QTest::newRow("closed at once") << 0 << false << QByteArray("one client at a time");
    QTest::newRow("reset at once") << ECONNRESET << false << QByteArray("one client at a time");
    QTest::newRow("closed") << 0 << true << QByteArray("check its power");
    QTest::newRow("reset") << ECONNRESET << true << QByteArray("broke off");
    QTest::newRow("written to after the end") << EPIPE << true << QByteArray("broke off");
    QTest::newRow("probes unanswered") << ETIMEDOUT << true << QByteArray("check its power and its cable");
    QTest::newRow("silent from the beginning") << ETIMEDOUT << false << QByteArray("check its power and its cable");
    QTest::newRow("route gone") << EHOSTUNREACH << true << QByteArray("check its power and its cable");
}

void TcpTroubleTest::whyAConnectionIsOverIsToldWithWhatToDo()
{
    QFETCH(int, error);
    QFETCH(bool, anythingCame);
    QFETCH(QByteArray, says);

    const std::string text = tcpEndText(error, anythingCame);

    QVERIFY2(text.find(says.toStdString()) != std::string::npos, text.c_str());
    QVERIFY2(text.find("laser") == std::string::npos, text.c_str());
}

void TcpTroubleTest::hostsArePutIntoBracketsWhereTheyHaveColons()
{
    QCOMPARE(hostText("fe80::1", 10940), std::string("[fe80::1]:10940"));
    QCOMPARE(hostText("192.168.0.10", 10940), std::string("192.168.0.10:10940"));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::TcpTroubleTest)
#include "tcp_trouble_test.moc"
