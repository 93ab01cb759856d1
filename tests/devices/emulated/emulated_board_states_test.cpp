// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <map>

#include <QFile>
#include <QtTest>

#include "tests/devices/emulated/board_host.h"
#include "tests/test_program.h"

namespace planewright {

/// The tables of resources/manual/board-protocol.md about what a board refuses, against what the emulated one does.
class EmulatedBoardStatesTest : public QObject {
    Q_OBJECT

private slots:
    void everyRequestInEveryStateDoesWhatTheDocumentSays_data();
    void everyRequestInEveryStateDoesWhatTheDocumentSays();
    void beforeHelloNothingIsDoneThatChangesAnything();
    void beforeTheConfigurationItIsNotArmed();
    void valuesOutOfRangeAreNamedByTheirOffset_data();
    void valuesOutOfRangeAreNamedByTheirOffset();
    void unknownTypesAndWrongLengthsAreNamed();
    void theFirstReasonThatAppliesIsGiven();
    void aTriggerWaitsForOneEdgeOnly();
    void theButtonStopsAndCountsForNoEstop();
    void aCauseThatIsThereKeepsTheFault_data();
    void aCauseThatIsThereKeepsTheFault();
    void withoutTheWireNoEdgeComes();
};

namespace {

using namespace board;
using namespace std::chrono_literals;

const std::map<QString, Message>& requests()
{
    static const std::map<QString, Message> all{
        {"HELLO", Hello{}},
        {"HEARTBEAT", Heartbeat{1}},
        {"GET_STATUS", GetStatus{}},
        {"SET_CONFIG", SetConfig{BoardHost::config()}},
        {"GET_CONFIG", GetConfig{}},
        {"HOME", Home{}},
        {"MOVE", Move{700, 100, 1, 0}},
        {"SWEEP", Sweep{300, 700, 4, 101, 0, 8, 160, 1}},
        {"TRIGGER", Trigger{1}},
        {"ARM 1", Arm{1}},
        {"ARM 0", Arm{0}},
        {"CLEAR_FAULT", ClearFault{}},
        {"STOP", Stop{}},
        {"ESTOP", Estop{}},
    };
    return all;
}

/// The rows of the document's table of states: request, then a cell for each state.
std::vector<QStringList> rowsOfTheDocument()
{
    QFile file(PLANEWRIGHT_SOURCE_DIR "/resources/manual/board-protocol.md");
    if (!file.open(QIODevice::ReadOnly))
        qFatal("resources/manual/board-protocol.md cannot be read");
    std::vector<QStringList> rows;
    bool inside = false;
    for (const QString& line : QString::fromUtf8(file.readAll()).split('\n')) {
        QStringList cells = line.split('|');
        if (cells.size() == kStates + 3 && cells[1].trimmed() == "request")
            inside = true;
        else if (inside && cells.size() != kStates + 3)
            break;
        if (!inside || cells[1].contains("---"))
            continue;
        for (QString& cell : cells)
            cell = cell.trimmed();
        rows.push_back(cells.mid(1, kStates + 1));
    }
    return rows;
}

/// Brings a board that was just made into a state.
void bringInto(BoardHost& host, State state, int& turns)
{
    if (state == State::Unarmed)
        return host.greet();
    host.greetAndArm();
    switch (state) {
        case State::Moving:
            host.get<MoveReply>(Move{600, 100, 1, 0});
            break;
        case State::Sweeping:
            host.get<SweepReply>(Sweep{512, 700, 4, 40, 0, 8, 160, 1});
            break;
        case State::Stopped:
            host.get<StopReply>(Stop{});
            break;
        case State::Estopped:
            host.get<EstopReply>(Estop{});
            break;
        case State::Fault:
            turns = 1;
            host.get<MoveReply>(Move{600, 100, 1, 0});
            host.wait(1s);
            break;
        default:
            break;
    }
}

/// A setup in which something holds the motor from the laser's first turn on.
EmulatedBoardSetup stallable(int& turns)
{
    EmulatedBoardSetup setup = levelBoard();
    setup.faults = {{"board-stall", 1}};
    setup.turns = [&turns](std::chrono::nanoseconds) { return turns; };
    return setup;
}

Nak nakOf(const std::optional<Frame>& reply)
{
    if (!reply || reply->type != Nak::kType)
        return Nak{static_cast<NakCode>(0), 0, 0};
    return std::get<Nak>(*toMessage(*reply));
}

}  // namespace

void EmulatedBoardStatesTest::everyRequestInEveryStateDoesWhatTheDocumentSays_data()
{
    QTest::addColumn<QString>("request");
    QTest::addColumn<int>("state");
    QTest::addColumn<QString>("cell");
    const std::vector<QStringList> rows = rowsOfTheDocument();
    QCOMPARE(rows.size(), requests().size() + 1);
    for (std::size_t row = 1; row < rows.size(); ++row) {
        for (int state = 0; state < kStates; ++state) {
            const QString name = rows[row][0] + " in " + rows[0][state + 1];
            QTest::newRow(qPrintable(name)) << rows[row][0] << state << rows[row][state + 1];
        }
    }
}

void EmulatedBoardStatesTest::everyRequestInEveryStateDoesWhatTheDocumentSays()
{
    QFETCH(QString, request);
    QFETCH(int, state);
    QFETCH(QString, cell);
    int turns = 0;
    BoardHost host{stallable(turns)};
    bringInto(host, static_cast<State>(state), turns);
    QCOMPARE(int(host.get<StatusReply>(GetStatus{}).state), state);

    const Message message = requests().at(request);
    const auto reply = host.ask(message);

    QVERIFY(reply);
    bool isNak = false;
    const int code = cell.toInt(&isNak);
    const State after = host.get<StatusReply>(GetStatus{}).state;
    if (isNak) {
        const Nak expected{static_cast<NakCode>(code), toFrame(1, message).type, static_cast<std::uint8_t>(state)};
        QCOMPARE(nakOf(reply), expected);
        QCOMPARE(int(after), state);
    } else {
        QCOMPARE(int(reply->type), int(replyType(toFrame(1, message).type)));
        QCOMPARE(QString::fromStdString(toText(after)), cell);
    }
}

void EmulatedBoardStatesTest::beforeHelloNothingIsDoneThatChangesAnything()
{
    for (const auto& [name, message] : requests()) {
        BoardHost host{levelBoard()};

        const auto reply = host.ask(message);

        QVERIFY(reply);
        const bool isAllowed = name == "HELLO" || name == "HEARTBEAT" || name == "GET_STATUS" || name == "GET_CONFIG" ||
                               name == "STOP" || name == "ESTOP" || name == "CLEAR_FAULT";
        QVERIFY2((nakOf(reply).code == NakCode::State) != isAllowed, qPrintable(name));
    }
}

void EmulatedBoardStatesTest::beforeTheConfigurationItIsNotArmed()
{
    BoardHost host{levelBoard()};
    host.get<HelloReply>(Hello{});

    QCOMPARE(nakOf(host.ask(Arm{1})), (Nak{NakCode::State, Arm::kType, 0}));
    host.get<SetConfigReply>(SetConfig{BoardHost::config()});

    QCOMPARE(host.get<ArmReply>(Arm{1}).state, State::Armed);
}

void EmulatedBoardStatesTest::valuesOutOfRangeAreNamedByTheirOffset_data()
{
    QTest::addColumn<Message>("request");
    QTest::addColumn<int>("offset");
    const auto config = [](auto change) {
        SetConfig request{BoardHost::config()};
        change(request);
        return Message{request};
    };
    QTest::newRow("low") << config([](Config& c) { c.low = 800; }) << 0;
    QTest::newRow("high") << config([](Config& c) { c.high = 1024; }) << 2;
    QTest::newRow("top speed") << config([](Config& c) { c.topSpeed = 0; }) << 4;
    QTest::newRow("park") << config([](Config& c) { c.park = 199; }) << 6;
    QTest::newRow("park speed") << config([](Config& c) { c.parkSpeed = 401; }) << 8;
    QTest::newRow("tolerance") << config([](Config& c) { c.tolerance = 51; }) << 10;
    QTest::newRow("limp") << config([](Config& c) { c.limp = 2; }) << 11;
    QTest::newRow("settle") << config([](Config& c) { c.settleMs = 1001; }) << 12;
    QTest::newRow("heartbeat") << config([](Config& c) { c.heartbeatMs = 49; }) << 14;
    QTest::newRow("stall") << config([](Config& c) { c.stallMs = 99; }) << 16;
    QTest::newRow("torque") << config([](Config& c) { c.estopTorque = 1001; }) << 18;
    QTest::newRow("scan") << config([](Config& c) { c.scanUs = 999; }) << 20;
    QTest::newRow("positions") << config([](Config& c) { c.positionHz = 201; }) << 22;
    QTest::newRow("goal too low") << Message{Move{199, 100, 1, 0}} << 0;
    QTest::newRow("goal too high") << Message{Move{801, 100, 1, 0}} << 0;
    QTest::newRow("no speed") << Message{Move{500, 0, 1, 0}} << 2;
    QTest::newRow("too fast") << Message{Move{500, 401, 1, 0}} << 2;
    QTest::newRow("flags") << Message{Move{500, 100, 2, 0}} << 4;
    QTest::newRow("first") << Message{Sweep{100, 700, 4, 1, 0, 0, 100, 1}} << 0;
    QTest::newRow("last") << Message{Sweep{300, 900, 4, 1, 0, 0, 100, 1}} << 2;
    QTest::newRow("step") << Message{Sweep{300, 700, 0, 1, 0, 0, 100, 1}} << 4;
    QTest::newRow("no slices") << Message{Sweep{300, 700, 4, 0, 0, 0, 100, 1}} << 6;
    QTest::newRow("too many slices") << Message{Sweep{300, 700, 4, 102, 0, 0, 100, 1}} << 6;
    QTest::newRow("far too many") << Message{Sweep{300, 700, 65535, 65535, 0, 0, 100, 1}} << 6;
    QTest::newRow("mode") << Message{Sweep{300, 700, 4, 1, 2, 0, 100, 1}} << 8;
    QTest::newRow("sweep's speed") << Message{Sweep{300, 700, 4, 1, 0, 0, 0, 1}} << 10;
    QTest::newRow("arm") << Message{Arm{2}} << 0;
}

void EmulatedBoardStatesTest::valuesOutOfRangeAreNamedByTheirOffset()
{
    QFETCH(Message, request);
    QFETCH(int, offset);
    BoardHost host{levelBoard()};
    host.greetAndArm();

    const Nak nak = nakOf(host.ask(request));

    QCOMPARE(nak, (Nak{NakCode::Range, toFrame(1, request).type, static_cast<std::uint8_t>(offset)}));
    QCOMPARE(host.get<GetConfigReply>(GetConfig{}), GetConfigReply{BoardHost::config()});
    QCOMPARE(host.board().state(), State::Armed);
}

void EmulatedBoardStatesTest::unknownTypesAndWrongLengthsAreNamed()
{
    BoardHost host{levelBoard()};

    QCOMPARE(nakOf(host.askFrame({1, 0x33, {1, 2, 3}})), (Nak{NakCode::UnknownType, 0x33, 0}));
    QCOMPARE(nakOf(host.askFrame({2, MoveReply::kType, {0, 0, 0, 0}})),
             (Nak{NakCode::UnknownType, MoveReply::kType, 0}));
    QCOMPARE(nakOf(host.askFrame({3, Move::kType, {0, 2, 100, 0, 1}})), (Nak{NakCode::Length, Move::kType, 6}));
    QCOMPARE(nakOf(host.askFrame({4, Hello::kType, {0}})), (Nak{NakCode::Length, Hello::kType, 0}));
    QVERIFY(!host.askFrame({0, Hello::kType, {}}));
    QVERIFY(!host.askFrame({0x8001, Hello::kType, {}}));
}

void EmulatedBoardStatesTest::theFirstReasonThatAppliesIsGiven()
{
    BoardHost host{levelBoard()};
    const Message wrongMove = Move{0, 0, 9, 0};

    QCOMPARE(nakOf(host.ask(wrongMove)).code, NakCode::State);
    host.greet();
    host.get<EstopReply>(Estop{});
    QCOMPARE(nakOf(host.ask(wrongMove)).code, NakCode::Estopped);
    host.get<ClearFaultReply>(ClearFault{});
    host.get<ArmReply>(Arm{1});
    QCOMPARE(nakOf(host.ask(wrongMove)).code, NakCode::Range);
    host.get<SweepReply>(Sweep{512, 700, 4, 40, 0, 8, 160, 1});

    QCOMPARE(nakOf(host.ask(wrongMove)).code, NakCode::Busy);
}

void EmulatedBoardStatesTest::aTriggerWaitsForOneEdgeOnly()
{
    EmulatedBoardSetup setup = levelBoard();
    setup.nextEdge = edgesEvery(1s, 900ms);
    BoardHost host{setup};
    host.greet();

    host.get<TriggerReply>(Trigger{1});
    QCOMPARE(nakOf(host.ask(Trigger{2})), (Nak{NakCode::Busy, Trigger::kType, 0}));
    host.wait(1s);

    QCOMPARE(host.all<SliceEvent>().size(), std::size_t(1));
    host.get<TriggerReply>(Trigger{2});
}

void EmulatedBoardStatesTest::theButtonStopsAndCountsForNoEstop()
{
    EmulatedBoardSetup setup = levelBoard();
    setup.faults = {{"board-button", 1}};
    bool isPressed = false;
    setup.turns = [&](std::chrono::nanoseconds) { return isPressed ? 1 : 0; };
    BoardHost host{setup};
    host.greetAndArm();
    host.get<MoveReply>(Move{700, 100, 1, 0});
    isPressed = true;
    host.wait(10ms);
    QCOMPARE(host.get<StatusReply>(GetStatus{}).state, State::Estopped);
    QCOMPARE(host.board().torque(), 300);

    host.get<EstopReply>(Estop{});

    QCOMPARE(host.board().torque(), 300);  // the first ESTOP of the host, not the second
    QCOMPARE(host.get<ClearFaultReply>(ClearFault{}).state, State::Estopped);  // it is still pressed
    host.wait(2s);
    QCOMPARE(host.get<StatusReply>(GetStatus{}).state, State::Estopped);
    QCOMPARE(host.get<ClearFaultReply>(ClearFault{}).state, State::Unarmed);
    QCOMPARE(host.get<ArmReply>(Arm{1}).state, State::Armed);
}

void EmulatedBoardStatesTest::aCauseThatIsThereKeepsTheFault_data()
{
    QTest::addColumn<QString>("fault");
    QTest::addColumn<int>("code");
    QTest::addColumn<int>("detail");
    QTest::newRow("overload") << "board-overload" << 0x12 << 0x20;
    QTest::newRow("heat") << "board-overheat" << 0x13 << 82;
    QTest::newRow("voltage") << "board-voltage" << 0x14 << 9000;
}

void EmulatedBoardStatesTest::aCauseThatIsThereKeepsTheFault()
{
    QFETCH(QString, fault);
    QFETCH(int, code);
    QFETCH(int, detail);
    EmulatedBoardSetup setup = levelBoard();
    setup.faults = {{fault.toStdString(), 1}};
    bool isThere = false;
    setup.turns = [&](std::chrono::nanoseconds) { return isThere ? 1 : 0; };
    BoardHost host{setup};
    host.greetAndArm();
    isThere = true;
    host.wait(10ms);

    const auto told = host.all<FaultEvent>();
    QCOMPARE(told.size(), std::size_t(1));
    QCOMPARE(static_cast<int>(told[0].code), code);
    QCOMPARE(told[0].state, State::Fault);
    QCOMPARE(static_cast<int>(told[0].detail), detail);
    const StatusReply status = host.get<StatusReply>(GetStatus{});
    QCOMPARE(static_cast<int>(status.tempC), code == 0x13 ? 82 : 38);
    QCOMPARE(static_cast<int>(status.voltMv), code == 0x14 ? 9000 : 14800);
    QCOMPARE(host.get<ClearFaultReply>(ClearFault{}).state, State::Fault);
    host.wait(3s);
    QCOMPARE(host.get<StatusReply>(GetStatus{}).state, State::Fault);
    QCOMPARE(host.get<ClearFaultReply>(ClearFault{}).state, State::Unarmed);
    QCOMPARE(host.get<StatusReply>(GetStatus{}).fault, Fault::None);
}

void EmulatedBoardStatesTest::withoutTheWireNoEdgeComes()
{
    EmulatedBoardSetup setup = levelBoard();
    setup.faults = {{"board-no-sync", 0}};
    BoardHost host{setup};
    host.greetAndArm();

    host.get<SweepReply>(Sweep{512, 600, 4, 20, 0, 8, 160, 1});
    host.wait(2s);

    const auto told = host.all<FaultEvent>();
    QCOMPARE(told.size(), std::size_t(1));
    QCOMPARE(told[0].code, Fault::NoSync);
    QCOMPARE(host.get<StatusReply>(GetStatus{}).state, State::Stopped);
    QVERIFY(host.all<SliceEvent>().empty());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::EmulatedBoardStatesTest)
#include "emulated_board_states_test.moc"
