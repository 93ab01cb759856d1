// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/replayed_talk.h"

#include <fstream>

#include <QTemporaryDir>
#include <QtTest>

#include "tests/devices/fake_clock.h"
#include "tests/devices/transport/test_socket.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

class ReplayedTalkTest : public QObject {
    Q_OBJECT

private slots:
    void whatMeansTheSameIsAnswered();
    void questionsMayBeLeftOutWithTheirAnswers();
    void aQuestionThatIsAskedOnceMoreHasTheSameAnswer();
    void whatSpeaksByItselfGoesOnWhereQuestionsAreLeftOut();
    void whatWasRepeatedNeedNotBe();
    void anotherMeaningEndsIt();
    void questionsWithoutEndAreNotAnswered();
    void theRecordedLossIsALoss();

private:
    std::unique_ptr<ReplayedTalk> open(const std::string& events, const Clock& clock, bool answersOnly = true);

    QTemporaryDir folder_;
    std::string path_ = folder_.filePath("talk.dialogue").toStdString();
};

namespace {

/// "?a" asks, everything else does something; what follows ':' is only a number.
class TestSpeech : public DialogueSpeech {
public:
    explicit TestSpeech(bool answersOnly) : answersOnly_(answersOnly) {}

    Meaning meaningOf(std::span<const std::uint8_t> message) const override
    {
        const std::string text{message.begin(), message.end()};
        return {text.substr(0, text.find(':')), text.starts_with('?')};
    }
    bool answersOnly() const override { return answersOnly_; }

private:
    bool answersOnly_;
};

std::string readAll(Transport& link, std::chrono::nanoseconds until)
{
    std::string all;
    std::vector<std::uint8_t> into(100);
    for (;;) {
        const auto arrival = link.read(into, until, {});
        if (!arrival)
            return all + "<" + arrival.error().message + ">";
        if (arrival->count == 0)
            return all;
        all.append(into.begin(), into.begin() + static_cast<std::ptrdiff_t>(arrival->count));
    }
}

}  // namespace

std::unique_ptr<ReplayedTalk> ReplayedTalkTest::open(const std::string& events, const Clock& clock, bool answersOnly)
{
    std::ofstream{path_, std::ios::binary} << kDialogueFirstLine << "\n" << events;
    auto talk =
        ReplayedTalk::open(path_, ReplayedTalk::Pace::Recorded, std::make_unique<TestSpeech>(answersOnly), clock);
    return talk ? std::move(*talk) : nullptr;
}

void ReplayedTalkTest::whatMeansTheSameIsAnswered()
{
    FakeClock clock;
    const auto link = open("0 > go:1\n5000 < gone\n", clock);
    QVERIFY(link);
    clock.advance(1h);
    QCOMPARE(readAll(*link, clock.now()), std::string{});

    QVERIFY(link->write(asBytes("go:77"), clock.now()));

    QCOMPARE(readAll(*link, 1h + 4ms), std::string{});
    QCOMPARE(readAll(*link, 1h + 6ms), std::string{"gone"});
    QVERIFY(link->isPlayed());
}

void ReplayedTalkTest::questionsMayBeLeftOutWithTheirAnswers()
{
    FakeClock clock;
    const auto link = open("0 > ?a\n1000 < 1\n2000 > ?a\n3000 < 2\n4000 > go\n5000 < done\n", clock);
    QVERIFY(link);
    QVERIFY(link->write(asBytes("?a"), clock.now()));
    QCOMPARE(readAll(*link, 2ms), std::string{"1"});

    QVERIFY(link->write(asBytes("go"), clock.now()));

    QCOMPARE(readAll(*link, 1s), std::string{"done"});
    QVERIFY(link->isPlayed());
}

void ReplayedTalkTest::aQuestionThatIsAskedOnceMoreHasTheSameAnswer()
{
    FakeClock clock;
    const auto link = open("0 > ?a\n1000 < 1\n4000 > go\n5000 < done\n", clock);
    QVERIFY(link);
    QVERIFY(link->write(asBytes("?a"), clock.now()));
    QCOMPARE(readAll(*link, 2ms), std::string{"1"});

    QVERIFY(link->write(asBytes("?a"), clock.now()));

    QCOMPARE(readAll(*link, 2500us), std::string{});
    QCOMPARE(readAll(*link, 3500us), std::string{"1"});  // as long after it as then
    QVERIFY(link->write(asBytes("go"), clock.now()));
    QCOMPARE(readAll(*link, 1s), std::string{"done"});
}

void ReplayedTalkTest::whatSpeaksByItselfGoesOnWhereQuestionsAreLeftOut()
{
    FakeClock clock;
    const auto link = open("0 > go\n1000 < 1\n2000 > ?a\n3000 < 2\n4000 > stop\n5000 < 3\n", clock, false);
    QVERIFY(link);
    QVERIFY(link->write(asBytes("go"), clock.now()));
    QCOMPARE(readAll(*link, 2ms), std::string{"1"});

    QVERIFY(link->write(asBytes("stop"), clock.now()));

    QCOMPARE(readAll(*link, 1s), std::string{"23"});
}

void ReplayedTalkTest::whatWasRepeatedNeedNotBe()
{
    FakeClock clock;
    const auto link = open("0 > go:1\n50000 > go:1\n51000 < gone\n60000 > stop\n61000 < rests\n", clock, false);
    QVERIFY(link);

    QVERIFY(link->write(asBytes("go:9"), clock.now()));
    QVERIFY(link->write(asBytes("stop"), clock.now()));

    QCOMPARE(readAll(*link, 1s), std::string{"gonerests"});
}

void ReplayedTalkTest::anotherMeaningEndsIt()
{
    FakeClock clock;
    const auto link = open("0 > ?a\n1000 < 1\n2500 > go\n3000 < gone\n", clock);
    QVERIFY(link);

    const auto said = link->write(asBytes("stop"), clock.now());

    QVERIFY(!said);
    QCOMPARE(said.error().code, ErrorCode::DeviceLost);
    QVERIFY2(said.error().message.find("the host said '?a' and now says 'stop'") != std::string::npos,
             said.error().message.c_str());
    QVERIFY(said.error().message.starts_with(path_ + ": "));
    QVERIFY(!link->write(asBytes("?a"), clock.now()));
}

void ReplayedTalkTest::questionsWithoutEndAreNotAnswered()
{
    FakeClock clock;
    const auto link = open("0 > ?a\n1000 < 1\n", clock);
    QVERIFY(link);
    QVERIFY(link->write(asBytes("?a"), clock.now()));

    int asked = 0;
    while (asked < 10'000 && link->write(asBytes("?a"), clock.now()))
        ++asked;

    QCOMPARE(asked, ReplayedTalk::kMostRepeated);
}

void ReplayedTalkTest::theRecordedLossIsALoss()
{
    FakeClock clock;
    const auto link = open("0 > go\n1000 < 1\n2000 ! usb 1-4: the device is gone\n", clock);
    QVERIFY(link);
    QVERIFY(link->write(asBytes("go"), clock.now()));

    const std::string text = readAll(*link, 1s);

    QVERIFY2(text.starts_with("1<") && text.find("usb 1-4: the device is gone") != std::string::npos, text.c_str());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ReplayedTalkTest)
#include "replayed_talk_test.moc"
