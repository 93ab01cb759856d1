// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/edit_history.h"

#include <QTemporaryDir>
#include <QtTest>

#include "core/formats/pwscan_writer.h"
#include "tests/test_program.h"

namespace planewright {

class EditHistoryTest : public QObject {
    Q_OBJECT

private slots:
    void undoTakesTheLastEditBackAndRedoMakesItAgain();
    void aNewEditEndsWhatCanBeRedone();
    void withoutEditsNothingHappens();
    void whatAFileHoldsAsUndoneCanBeRedone();
    void editsFromBeforeTheFileGoIntoIt();
};

namespace {

Edit renamed(PlaneId plane, const char* name)
{
    return {Edit::Kind::Rename, {plane}, name, true};
}

std::vector<std::string> names(const EditHistory& history)
{
    std::vector<std::string> texts;
    for (const Edit& edit : history.inForce())
        texts.push_back(edit.text);
    return texts;
}

}  // namespace

void EditHistoryTest::undoTakesTheLastEditBackAndRedoMakesItAgain()
{
    EditHistory history;
    QVERIFY(history.add(renamed(1, "a")));
    QVERIFY(history.add(renamed(2, "b")));

    QVERIFY(history.undo());
    QCOMPARE(names(history), std::vector<std::string>{"a"});
    QVERIFY(history.undo());
    QVERIFY(names(history).empty());
    QVERIFY(!history.canUndo());

    QVERIFY(history.redo());
    QCOMPARE(names(history), std::vector<std::string>{"a"});
    QVERIFY(history.redo());
    QCOMPARE(names(history), (std::vector<std::string>{"a", "b"}));
    QVERIFY(!history.canRedo());
}

void EditHistoryTest::aNewEditEndsWhatCanBeRedone()
{
    EditHistory history;
    QVERIFY(history.add(renamed(1, "a")));
    QVERIFY(history.undo());

    QVERIFY(history.add(renamed(1, "b")));

    QVERIFY(!history.canRedo());
    QCOMPARE(names(history), std::vector<std::string>{"b"});
    QVERIFY(history.undo());
    QVERIFY(names(history).empty());
}

void EditHistoryTest::withoutEditsNothingHappens()
{
    EditHistory history;

    QVERIFY(history.undo());
    QVERIFY(history.redo());

    QVERIFY(!history.canUndo() && !history.canRedo());
}

void EditHistoryTest::whatAFileHoldsAsUndoneCanBeRedone()
{
    EditHistory history;
    history.begin(nullptr, 1, {{1, renamed(1, "a"), false}, {2, renamed(1, "b"), true}, {3, renamed(1, "c"), true}});

    QCOMPARE(names(history), std::vector<std::string>{"a"});
    QVERIFY(history.redo());

    QCOMPARE(names(history), (std::vector<std::string>{"a", "b"}));
}

void EditHistoryTest::editsFromBeforeTheFileGoIntoIt()
{
    const QTemporaryDir folder;
    const std::string path = folder.filePath("a.pwscan").toStdString();
    const auto writer = PwscanWriter::create(path, ScanRecord{});
    QVERIFY2(writer, writer ? "" : writer.error().message.c_str());
    auto project = PwscanProject::open(path);
    QVERIFY(project);
    EditHistory history;
    QVERIFY(history.add(renamed(1, "a")));
    QVERIFY(history.add(renamed(2, "b")));
    QVERIFY(history.undo());

    QVERIFY(history.moveInto(&*project, 1));
    QVERIFY(history.add(renamed(3, "c")));

    const auto stored = project->edits(1);
    QVERIFY(stored);
    QCOMPARE(stored->size(), std::size_t(3));
    QCOMPARE((*stored)[0].edit.text, std::string("a"));
    QVERIFY((*stored)[1].undone);
    QCOMPARE((*stored)[2].edit.text, std::string("c"));
    QCOMPARE(names(history), (std::vector<std::string>{"a", "c"}));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::EditHistoryTest)
#include "edit_history_test.moc"
