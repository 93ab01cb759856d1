// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/dialogue_recorder.h"

#include <atomic>
#include <csignal>
#include <fcntl.h>
#include <fstream>
#include <sstream>
#include <sys/resource.h>
#include <thread>

#include <QTemporaryDir>
#include <QtTest>

#include "devices/emulated/emulated_link.h"
#include "devices/transport/replayed_dialogue.h"
#include "tests/devices/echo_device.h"
#include "tests/devices/fake_clock.h"
#include "tests/devices/holds.h"
#include "tests/devices/transport/test_socket.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

class DialogueRecorderTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void bothWaysAreRecordedWithTheirTimes();
    void theLinkIsUsedAsIfItWereNotRecorded();
    void aLossIsRecordedOnce();
    void closingIsNoLoss();
    void whatIsRecordedIsPlayedTheSame();
    void anExistingFileIsNotTouched();
    void aFolderThatIsNotThereIsNamed();
    void aFullDiskEndsTheRecordAndNotTheLink();
    void aRecordThatEndsEarlyIsToldOnce();
    void aFileThatMayGrowNoMoreHoldsWholeLines();
    void aSlowDiskEndsTheRecordAndNotTheLink();
    void twoThreadsMayUseTheLinkAtOnce();

private:
    std::string text() const;

    std::unique_ptr<QTemporaryDir> folder_;
    std::string path_;
    FakeClock clock_;
    std::shared_ptr<EchoDevice> device_;
};

namespace {

std::unique_ptr<Transport> linkTo(const std::shared_ptr<EchoDevice>& device, const Clock& clock)
{
    return std::make_unique<EmulatedLink>(device, std::make_shared<std::mutex>(), clock, "the echo");
}

/// A recorder whose file is this one.
std::unique_ptr<DialogueRecorder> recorderInto(Descriptor file, std::unique_ptr<Transport> link, const Clock& clock)
{
    auto writer = DialogueWriter::begin(std::move(file), "dialogue.txt", "the echo");
    return std::make_unique<DialogueRecorder>(std::move(link), std::move(*writer), clock);
}

/// No file of this process may grow beyond a size meanwhile.
class FileSizeLimit {
public:
    explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN))
    {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;
    ~FileSizeLimit()
    {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }

private:
    rlimit before_{};
    void (*handler_)(int);
};

}  // namespace

void DialogueRecorderTest::init()
{
    folder_ = std::make_unique<QTemporaryDir>();
    path_ = folder_->filePath("dialogue.txt").toStdString();
    device_ = std::make_shared<EchoDevice>();
}

std::string DialogueRecorderTest::text() const
{
    std::ostringstream text;
    text << std::ifstream{path_, std::ios::binary}.rdbuf();
    return text.str();
}

void DialogueRecorderTest::bothWaysAreRecordedWithTheirTimes()
{
    FakeClock clock;
    clock.advance(1h);
    auto writer = DialogueWriter::create(path_, "the echo");
    QVERIFY2(writer, writer ? "" : writer.error().message.c_str());
    DialogueRecorder link{linkTo(device_, clock), std::move(*writer), clock};

    clock.advance(10ms);
    QVERIFY(link.write(asBytes("QT\n"), clock.now()));
    std::array<std::uint8_t, 100> into{};
    QVERIFY(link.read(into, clock.now() + 1s, {}));
    clock.advance(1ms);
    QVERIFY(link.write(asBytes({"\xFF", 1}), clock.now()));
    link.close();

    QCOMPARE(text(), std::string("planewright-dialogue 1\n"
                                 "# the\\x20echo\n"
                                 "10000 > QT\\n\n"
                                 "12000 < QT\\n\n"
                                 "13000 > \\xFF\n"));
    QCOMPARE(link.trouble(), std::string());
}

void DialogueRecorderTest::theLinkIsUsedAsIfItWereNotRecorded()
{
    FakeClock clock;
    auto writer = DialogueWriter::create(path_, "the echo");
    QVERIFY(writer);
    DialogueRecorder link{linkTo(device_, clock), std::move(*writer), clock};
    std::array<std::uint8_t, 2> into{};

    QCOMPARE(link.name(), std::string("the echo"));
    QVERIFY(link.write(asBytes("abc"), clock.now()));
    const auto first = link.read(into, clock.now() + 1s, {});
    const auto second = link.read(into, clock.now() + 1s, {});
    const auto none = link.read(into, clock.now() + 1s, {});

    QVERIFY(first && second && none);
    QCOMPARE(first->count, std::size_t{2});
    QCOMPARE(second->count, std::size_t{1});
    QVERIFY(first->at == 2ms && second->at == 2ms);
    QCOMPARE(none->count, std::size_t{0});
    link.close();
    QVERIFY(holds(text(), "2000 < ab\n2000 < c\n"));
}

void DialogueRecorderTest::aLossIsRecordedOnce()
{
    FakeClock clock;
    auto writer = DialogueWriter::create(path_, "the echo");
    QVERIFY(writer);
    DialogueRecorder link{linkTo(device_, clock), std::move(*writer), clock};
    device_->isPluggedIn = false;
    std::array<std::uint8_t, 8> into{};

    QVERIFY(!link.read(into, clock.now() + 1s, {}));
    QVERIFY(!link.write(asBytes("a"), clock.now()));
    QVERIFY(!link.read(into, clock.now() + 1s, {}));
    link.close();

    QVERIFY2(text().ends_with("echo\n0 ! the echo: the device is gone; plug it in again\n"), text().c_str());
}

void DialogueRecorderTest::closingIsNoLoss()
{
    FakeClock clock;
    auto writer = DialogueWriter::create(path_, "the echo");
    QVERIFY(writer);
    DialogueRecorder link{linkTo(device_, clock), std::move(*writer), clock};
    std::array<std::uint8_t, 8> into{};

    link.close();
    link.close();

    QVERIFY(!link.read(into, clock.now() + 1s, {}));
    QVERIFY(!holds(text(), "!"));
}

void DialogueRecorderTest::whatIsRecordedIsPlayedTheSame()
{
    /// A session: what came, with when, each in a text.
    const auto session = [](Transport& link, const Clock& clock) {
        std::vector<std::pair<std::string, std::chrono::nanoseconds>> came;
        const auto listen = [&](std::chrono::nanoseconds until) {
            std::array<std::uint8_t, 70> into{};
            while (clock.now() < until) {
                const auto arrival = link.read(into, until, {});
                if (!arrival)
                    return;
                came.emplace_back(std::string{into.data(), into.data() + arrival->count}, arrival->at);
            }
        };
        const auto begun = clock.now();
        (void)link.write(asBytes("hello"), clock.now());
        listen(begun + 20ms);
        (void)link.write(asBytes("S"), clock.now());
        listen(begun + 61ms);
        (void)link.write(asBytes("bye"), clock.now());
        listen(begun + 80ms);
        for (auto& [text, at] : came)
            at -= begun;
        return came;
    };
    FakeClock recordClock;
    auto writer = DialogueWriter::create(path_, "the echo");
    QVERIFY(writer);
    DialogueRecorder recorder{linkTo(device_, recordClock), std::move(*writer), recordClock};
    const auto recorded = session(recorder, recordClock);
    recorder.close();

    FakeClock playClock;
    playClock.advance(1h);
    const auto played = ReplayedDialogue::open(path_, ReplayedDialogue::Pace::Recorded, playClock);
    QVERIFY2(played, played ? "" : played.error().message.c_str());

    // Echo, 12 frames in two pieces each and two echoes between them, and four waits without anything.
    QVERIFY(recorded.size() > 26);
    QVERIFY(session(**played, playClock) == recorded);
    QVERIFY((*played)->isPlayed());
}

void DialogueRecorderTest::anExistingFileIsNotTouched()
{
    std::ofstream{path_} << "precious";

    const auto writer = DialogueWriter::create(path_, "the echo");

    QVERIFY(!writer);
    QCOMPARE(writer.error().code, ErrorCode::NotWritten);
    QCOMPARE(writer.error().message, path_ + ": exists already; give another name");
    QCOMPARE(text(), std::string("precious"));
}

void DialogueRecorderTest::aFolderThatIsNotThereIsNamed()
{
    const std::string path = folder_->filePath("no/such/folder.txt").toStdString();

    const auto writer = DialogueWriter::create(path, "the echo");

    QVERIFY(!writer);
    QCOMPARE(writer.error().code, ErrorCode::NotWritten);
    QVERIFY2(writer.error().message.starts_with(path + ": cannot be written ("), writer.error().message.c_str());
}

void DialogueRecorderTest::aFullDiskEndsTheRecordAndNotTheLink()
{
    FakeClock clock;
    const auto link =
        recorderInto(Descriptor{::open("/dev/full", O_WRONLY | O_CLOEXEC)}, linkTo(device_, clock), clock);

    QTRY_VERIFY_WITH_TIMEOUT(!link->trouble().empty(), 30'000);
    QVERIFY(link->write(asBytes("QT\n"), clock.now()));

    QCOMPARE(readText(*link, 3), std::string("QT\n"));
    QVERIFY2(link->trouble().starts_with("dialogue.txt: the dialogue is recorded no further ("),
             link->trouble().c_str());
    QCOMPARE(link->health().trouble, link->trouble());
}

void DialogueRecorderTest::aRecordThatEndsEarlyIsToldOnce()
{
    std::mutex mutex;
    std::vector<std::string> told;
    const auto onTrouble = [&](const std::string& line) {
        const std::scoped_lock lock{mutex};
        told.push_back(line);
    };
    const auto writer =
        DialogueWriter::begin(Descriptor{::open("/dev/full", O_WRONLY | O_CLOEXEC)}, "dialogue.txt", "echo", onTrouble);
    QVERIFY(writer);

    for (int i = 0; i < 3; ++i) {
        (*writer)->add({DialogueEvent::Kind::ToDevice, 1ms, {'a'}});
        QTRY_VERIFY_WITH_TIMEOUT(!(*writer)->trouble().empty(), 30'000);
    }
    (*writer)->finish();

    QCOMPARE(told, std::vector<std::string>{(*writer)->trouble()});
}

void DialogueRecorderTest::aFileThatMayGrowNoMoreHoldsWholeLines()
{
    FakeClock clock;
    const std::vector<std::uint8_t> zeros(std::size_t{1} << 18, 0);
    auto writer = DialogueWriter::create(path_, "the echo");
    QVERIFY(writer);
    DialogueRecorder link{linkTo(device_, clock), std::move(*writer), clock};
    {
        const FileSizeLimit limit{100'000};
        QVERIFY(link.write(zeros, clock.now()));
        QTRY_VERIFY_WITH_TIMEOUT(!link.trouble().empty(), 30'000);
    }

    link.close();

    // Lines are of 4 kB.
    const std::string written = text();
    QVERIFY(written.size() > 90'000 && written.size() <= 100'000);
    QVERIFY(written.ends_with("\n"));
    QVERIFY(ReplayedDialogue::open(path_, ReplayedDialogue::Pace::Recorded, clock));
}

void DialogueRecorderTest::aSlowDiskEndsTheRecordAndNotTheLink()
{
    FakeClock clock;
    int ends[2] = {-1, -1};
    QCOMPARE(::pipe2(ends, O_CLOEXEC), 0);
    const Descriptor reading{ends[0]};
    const auto link = recorderInto(Descriptor{ends[1]}, linkTo(device_, clock), clock);
    const std::vector<std::uint8_t> zeros(std::size_t{1} << 16, 0);

    for (std::size_t given = 0; given < 2 * DialogueWriter::kMostWaiting; given += zeros.size())
        QVERIFY(link->write(zeros, clock.now()));

    QVERIFY2(holds(link->trouble(), "the disk is too slow"), link->trouble().c_str());
    std::jthread disk{[&] { receiveText(reading, std::size_t{1} << 30); }};
    link->close();
}

void DialogueRecorderTest::twoThreadsMayUseTheLinkAtOnce()
{
    auto writer = DialogueWriter::create(path_, "the echo");
    QVERIFY(writer);
    DialogueRecorder link{linkTo(device_, steadyClock()), std::move(*writer), steadyClock()};
    device_->delay = 0ms;
    constexpr std::size_t kWrites = 500;
    std::string received;
    std::jthread reader{[&] { received = readText(link, kWrites * 3); }};

    for (std::size_t i = 0; i < kWrites; ++i)
        QVERIFY(link.write(asBytes("ab\n"), steadyClock().now() + kPatience));
    reader.join();
    link.close();

    QCOMPARE(received.size(), kWrites * 3);
    auto dialogue = DialogueReader::open(path_);
    QVERIFY(dialogue);
    std::array<std::size_t, 2> counts{};
    for (;;) {
        const auto event = dialogue->next();
        QVERIFY2(event, event ? "" : event.error().message.c_str());
        if (!*event)
            break;
        counts.at((*event)->kind == DialogueEvent::Kind::ToDevice ? 0 : 1) += (*event)->bytes.size();
    }
    QCOMPARE(counts[0], kWrites * 3);
    QCOMPARE(counts[1], kWrites * 3);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::DialogueRecorderTest)
#include "dialogue_recorder_test.moc"
