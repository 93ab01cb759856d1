// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/tcp_link.h"

#include <algorithm>
#include <atomic>
#include <linux/filter.h>
#include <netinet/tcp.h>
#include <optional>
#include <thread>

#include <QtTest>

#include "tests/devices/fake_clock.h"
#include "tests/devices/holds.h"
#include "tests/devices/transport/test_socket.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

class TcpLinkTest : public QObject {
    Q_OBJECT

private slots:
    void bytesGoBothWays();
    void aNameIsLookedUp();
    void anArrivalHasTheTimeOfTheClock();
    void aRefusalIsExplained();
    void aNameThatIsNoneIsExplained();
    void aHostThatDoesNotAnswerIsGivenUp();
    void aStopEndsConnecting();
    void aHostThatClosesAtOnceServesAnother();
    void whatCameBeforeTheEndIsReadFirst();
    void aConnectionThatIsBrokenOffIsLost();
    void aSilentHostIsNotLost();
    void aSilentHostIsAskedWhetherItIsThere();
    void aHostThatIsGoneWithoutAWordIsLost_data();
    void aHostThatIsGoneWithoutAWordIsLost();
    void manyBytesGoToASlowHostWhole();
    void aHostThatTakesNothingEndsTheLink();
    void closingWakesReaderAndWriter();
    void aClosedLinkSendsWhatWasWrittenAndNothingMore();
    void aStopEndsReading();
};

namespace {

Result<std::unique_ptr<Transport>> connectTo(std::uint16_t port, const Clock& clock = steadyClock())
{
    return openTcpLink("127.0.0.1", port, clock, clock.now() + kPatience, {});
}

/// The descriptor of this process that is connected to a port of this machine.
std::optional<int> connectedTo(std::uint16_t port)
{
    for (int number = 0; number < 1024; ++number) {
        sockaddr_in peer{};
        socklen_t size = sizeof peer;
        if (::getpeername(number, reinterpret_cast<sockaddr*>(&peer), &size) == 0 && peer.sin_family == AF_INET &&
            ntohs(peer.sin_port) == port)
            return number;
    }
    return std::nullopt;
}

int optionOf(int socket, int level, int option)
{
    int value = -1;
    socklen_t size = sizeof value;
    ::getsockopt(socket, level, option, &value, &size);
    return value;
}

/// A listener whose queue is full: the system answers nobody else.
struct DeafListener {
    TestListener listener{0};
    std::vector<Descriptor> waiting;

    DeafListener()
    {
        for (int i = 0; i < 4; ++i) {
            Descriptor socket{::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)};
            sockaddr_in address{};
            address.sin_family = AF_INET;
            address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
            address.sin_port = htons(listener.port());
            ::connect(socket.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address);
            waiting.push_back(std::move(socket));
        }
    }
};

/// A packet filter lets nothing in: the far side acknowledges nothing any more and breaks nothing off, as a laser that
/// has lost its power, or a cable that was pulled.
bool hearsNothingAnyMore(const Descriptor& socket)
{
    sock_filter nothing{BPF_RET | BPF_K, 0, 0, 0};
    const sock_fprog program{1, &nothing};
    return ::setsockopt(socket.number(), SOL_SOCKET, SO_ATTACH_FILTER, &program, sizeof program) == 0;
}

}  // namespace

void TcpLinkTest::bytesGoBothWays()
{
    const TestListener listener;
    const auto link = connectTo(listener.port());
    QVERIFY2(link, link ? "" : link.error().message.c_str());
    const Descriptor peer = listener.accept();

    QVERIFY((*link)->write(asBytes("QT\n"), steadyClock().now() + kPatience));
    QCOMPARE(receiveText(peer, 3), std::string("QT\n"));
    QVERIFY(sendText(peer, "QT\n00P\n\n"));

    QCOMPARE(readText(**link, 8), std::string("QT\n00P\n\n"));
    QCOMPARE((*link)->name(), "127.0.0.1:" + std::to_string(listener.port()));
}

void TcpLinkTest::aNameIsLookedUp()
{
    const TestListener listener;

    // Has two numbers on many machines, of which the first refuses.
    const auto link = openTcpLink("localhost", listener.port(), steadyClock(), steadyClock().now() + kPatience, {});

    QVERIFY2(link, link ? "" : link.error().message.c_str());
    QCOMPARE((*link)->name(), "localhost:" + std::to_string(listener.port()));
}

void TcpLinkTest::anArrivalHasTheTimeOfTheClock()
{
    FakeClock clock{FakeClock::Kind::Stands};
    clock.advance(5s);
    const TestListener listener;
    const auto link = connectTo(listener.port(), clock);
    QVERIFY(link);
    const Descriptor peer = listener.accept();
    QVERIFY(sendText(peer, "abc"));
    std::array<std::uint8_t, 8> into{};

    const auto arrival = (*link)->read(into, clock.now() + kPatience, {});

    QVERIFY(arrival);
    QCOMPARE(arrival->count, std::size_t{3});
    QVERIFY(arrival->at == 5s);
}

void TcpLinkTest::aRefusalIsExplained()
{
    const TestListener bound{-1};

    const auto link = connectTo(bound.port());

    QVERIFY(!link);
    QCOMPARE(link.error().code, ErrorCode::NoDevice);
    QVERIFY2(link.error().message.starts_with("127.0.0.1:" + std::to_string(bound.port()) + ": refused"),
             link.error().message.c_str());
    QVERIFY(holds(link.error().message, "one client at a time"));
}

void TcpLinkTest::aNameThatIsNoneIsExplained()
{
    const std::string tooLongForAName(70, 'a');

    const auto link =
        openTcpLink(tooLongForAName + ".invalid", 10940, steadyClock(), steadyClock().now() + kPatience, {});

    QVERIFY(!link);
    QCOMPARE(link.error().code, ErrorCode::NoDevice);
    QVERIFY2(holds(link.error().message, "there is no host of this name"), link.error().message.c_str());
}

void TcpLinkTest::aHostThatDoesNotAnswerIsGivenUp()
{
    const DeafListener deaf;
    const auto began = steadyClock().now();

    const auto link = openTcpLink("127.0.0.1", deaf.listener.port(), steadyClock(), began + 100ms, {});

    QVERIFY(!link);
    QCOMPARE(link.error().code, ErrorCode::NoDevice);
    QVERIFY2(holds(link.error().message, "does not answer"), link.error().message.c_str());
    QVERIFY(steadyClock().now() - began >= 100ms);
}

void TcpLinkTest::aStopEndsConnecting()
{
    const DeafListener deaf;
    std::atomic<ErrorCode> code{ErrorCode::Internal};
    std::jthread connecting{[&](const std::stop_token& stop) {
        const auto link = openTcpLink("127.0.0.1", deaf.listener.port(), steadyClock(), steadyClock().now() + 1h, stop);
        if (!link)
            code = link.error().code;
    }};

    connecting.request_stop();
    connecting.join();

    QCOMPARE(code.load(), ErrorCode::Interrupted);
}

void TcpLinkTest::aHostThatClosesAtOnceServesAnother()
{
    const TestListener listener;
    const auto link = connectTo(listener.port());
    QVERIFY(link);
    listener.accept().reset();

    const std::string text = readText(**link, 1);

    QVERIFY2(holds(text, "closed the connection before it said anything"), text.c_str());
    QVERIFY2(holds(text, "one client at a time"), text.c_str());
}

void TcpLinkTest::whatCameBeforeTheEndIsReadFirst()
{
    const TestListener listener;
    const auto link = connectTo(listener.port());
    QVERIFY(link);
    {
        const Descriptor peer = listener.accept();
        QVERIFY(sendText(peer, "half a fra"));
    }

    const std::string text = readText(**link, 100);

    QVERIFY2(text.starts_with("half a fra<127.0.0.1:"), text.c_str());
    QVERIFY2(holds(text, "closed the connection; check its power"), text.c_str());
    const auto written = (*link)->write(asBytes("QT\n"), steadyClock().now() + kPatience);
    QVERIFY(!written);
    QCOMPARE(written.error().code, ErrorCode::DeviceLost);
    QVERIFY(text.ends_with("<" + written.error().message + ">"));
}

void TcpLinkTest::aConnectionThatIsBrokenOffIsLost()
{
    const TestListener listener;
    const auto link = connectTo(listener.port());
    QVERIFY(link);
    Descriptor peer = listener.accept();
    QVERIFY(sendText(peer, "a"));
    QCOMPARE(readText(**link, 1), std::string("a"));
    const linger atOnce{1, 0};
    ::setsockopt(peer.number(), SOL_SOCKET, SO_LINGER, &atOnce, sizeof atOnce);

    peer.reset();

    const std::string text = readText(**link, 1);
    QVERIFY2(holds(text, "broke off the connection"), text.c_str());
}

void TcpLinkTest::aSilentHostIsNotLost()
{
    const TestListener listener;
    const auto link = connectTo(listener.port());
    QVERIFY(link);
    const Descriptor peer = listener.accept();
    std::array<std::uint8_t, 8> into{};

    const auto deadline = steadyClock().now() + 20ms;
    const auto arrival = (*link)->read(into, deadline, {});

    QVERIFY(arrival);
    QCOMPARE(arrival->count, std::size_t{0});
    QVERIFY(steadyClock().now() >= deadline);
}

void TcpLinkTest::aSilentHostIsAskedWhetherItIsThere()
{
    const TestListener listener;
    const auto link = connectTo(listener.port());
    QVERIFY(link);

    const auto socket = connectedTo(listener.port());

    QVERIFY(socket);
    QCOMPARE(optionOf(*socket, SOL_SOCKET, SO_KEEPALIVE), 1);
    const int idle = optionOf(*socket, IPPROTO_TCP, TCP_KEEPIDLE);
    const int probes = optionOf(*socket, IPPROTO_TCP, TCP_KEEPINTVL) * optionOf(*socket, IPPROTO_TCP, TCP_KEEPCNT);
    QVERIFY(std::chrono::seconds{idle + probes} == kSilenceLimit);
    QVERIFY(std::chrono::milliseconds{optionOf(*socket, IPPROTO_TCP, TCP_USER_TIMEOUT)} == kSilenceLimit);
    QCOMPARE(optionOf(*socket, IPPROTO_TCP, TCP_NODELAY), 1);
}

void TcpLinkTest::aHostThatIsGoneWithoutAWordIsLost_data()
{
    QTest::addColumn<bool>("writes");
    QTest::newRow("who only listens finds out") << false;
    QTest::newRow("and who has said something") << true;
}

void TcpLinkTest::aHostThatIsGoneWithoutAWordIsLost()
{
    QFETCH(bool, writes);
    const TestListener listener;
    const auto link = connectTo(listener.port());
    QVERIFY(link);
    const Descriptor peer = listener.accept();
    QVERIFY(sendText(peer, "a"));
    QCOMPARE(readText(**link, 1), std::string("a"));
    QVERIFY(hearsNothingAnyMore(peer));
    const auto since = steadyClock().now();
    if (writes)
        QVERIFY((*link)->write(asBytes("VV\n"), since + kPatience));

    const std::string text = readText(**link, 1);

    QVERIFY2(holds(text, "connect it again"), text.c_str());
    QVERIFY(steadyClock().now() - since >= kSilenceLimit - 1s);
    QVERIFY(steadyClock().now() - since <= 10 * kSilenceLimit);
}

void TcpLinkTest::manyBytesGoToASlowHostWhole()
{
    const TestListener listener;
    const auto link = connectTo(listener.port());
    QVERIFY(link);
    const Descriptor peer = listener.accept();
    std::string sent(std::size_t{8} << 20, '\0');
    for (std::size_t i = 0; i < sent.size(); ++i)
        sent[i] = static_cast<char>(i * i % 251);
    std::atomic<bool> written{false};
    std::jthread writer{[&] { written = (*link)->write(asBytes(sent), steadyClock().now() + kPatience).has_value(); }};

    const std::string received = receiveText(peer, sent.size());

    writer.join();
    QVERIFY(written);
    QVERIFY(received == sent);
}

void TcpLinkTest::aHostThatTakesNothingEndsTheLink()
{
    const TestListener listener;
    const auto link = connectTo(listener.port());
    QVERIFY(link);
    const Descriptor peer = listener.accept();

    const auto written = (*link)->write(std::vector<std::uint8_t>(std::size_t{64} << 20), steadyClock().now() + 50ms);

    QVERIFY(!written);
    QCOMPARE(written.error().code, ErrorCode::DeviceLost);
    QVERIFY2(holds(written.error().message, "did not take"), written.error().message.c_str());
    QCOMPARE(readText(**link, 1), "<" + written.error().message + ">");
}

void TcpLinkTest::closingWakesReaderAndWriter()
{
    const TestListener listener;
    const auto link = connectTo(listener.port());
    QVERIFY(link);
    const Descriptor peer = listener.accept();
    std::atomic<int> lost{0};
    std::jthread reader{[&] {
        std::array<std::uint8_t, 8> into{};
        if (const auto arrival = (*link)->read(into, steadyClock().now() + 1h, {}); !arrival)
            ++lost;
    }};
    std::jthread writer{[&] {
        const std::vector<std::uint8_t> tooMany(std::size_t{64} << 20);
        if (const auto written = (*link)->write(tooMany, steadyClock().now() + 1h); !written)
            ++lost;
    }};
    // The writer has begun.
    QCOMPARE(receiveText(peer, 1).size(), std::size_t{1});

    (*link)->close();
    (*link)->close();
    reader.join();
    writer.join();

    QCOMPARE(lost.load(), 2);
}

void TcpLinkTest::aClosedLinkSendsWhatWasWrittenAndNothingMore()
{
    const TestListener listener;
    const auto link = connectTo(listener.port());
    QVERIFY(link);
    const Descriptor peer = listener.accept();
    QVERIFY(sendText(peer, "that nobody reads"));
    QVERIFY((*link)->write(asBytes("QT\n"), steadyClock().now() + kPatience));

    (*link)->close();
    const auto late = (*link)->write(asBytes("BM\n"), steadyClock().now() + kPatience);

    QVERIFY(!late);
    QCOMPARE(late.error().code, ErrorCode::DeviceLost);
    QCOMPARE(receiveText(peer, 3), std::string("QT\n"));
    // The end in order, and no break.
    char byte = 0;
    QCOMPARE(::read(peer.number(), &byte, 1), ssize_t{0});
}

void TcpLinkTest::aStopEndsReading()
{
    const TestListener listener;
    const auto link = connectTo(listener.port());
    QVERIFY(link);
    std::atomic<bool> cameBack{false};
    std::jthread reader{[&](const std::stop_token& stop) {
        std::array<std::uint8_t, 8> into{};
        const auto arrival = (*link)->read(into, steadyClock().now() + 1h, stop);
        cameBack = arrival && arrival->count == 0;
    }};

    reader.request_stop();
    reader.join();

    QVERIFY(cameBack);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::TcpLinkTest)
#include "tcp_link_test.moc"
