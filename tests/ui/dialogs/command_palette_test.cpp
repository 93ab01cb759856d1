// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/dialogs/command_palette.h"

#include <QAction>
#include <QLineEdit>
#include <QListWidget>
#include <QSignalSpy>
#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class CommandPaletteTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void someLettersAndEnterDoTheCommand();
    void arrowsChooseWhileTheKeyboardStaysInTheLine();
    void whatIsNotPossibleIsNotDone();
    void lettersThatFitNothingDoNothing();

private:
    QAction* add(const char* text, const char* name)
    {
        auto* action = new QAction(QString::fromLatin1(text), holder_.get());
        action->setObjectName(QString::fromLatin1(name));
        actions_ << action;
        return action;
    }
    QLineEdit* query() const { return palette_->findChild<QLineEdit*>("commandQuery"); }
    void show();

    std::unique_ptr<QObject> holder_;
    QList<QAction*> actions_;
    std::unique_ptr<CommandPalette> palette_;
};

void CommandPaletteTest::init()
{
    palette_.reset();
    actions_.clear();
    holder_ = std::make_unique<QObject>();
    add("Fit all", "actFit");
    add("Export planes…", "actExportPlanes");
    add("Export points…", "actExportPoints");
    add("Stop motion", "actStop")->setEnabled(false);
}

void CommandPaletteTest::show()
{
    palette_ = std::make_unique<CommandPalette>(actions_);
    palette_->show();
    palette_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(palette_.get()));
    QVERIFY(query()->hasFocus());
}

void CommandPaletteTest::someLettersAndEnterDoTheCommand()
{
    show();
    QSignalSpy done(actions_[2], &QAction::triggered);

    QTest::keyClicks(query(), "expo poi");
    QTest::keyClick(query(), Qt::Key_Return);

    QCOMPARE(done.size(), 1);
    QVERIFY(!palette_->isVisible());
}

void CommandPaletteTest::arrowsChooseWhileTheKeyboardStaysInTheLine()
{
    show();
    QSignalSpy done(actions_[1], &QAction::triggered);

    QTest::keyClick(query(), Qt::Key_Down);
    QVERIFY(query()->hasFocus());
    QTest::keyClick(query(), Qt::Key_Return);

    QCOMPARE(done.size(), 1);
}

void CommandPaletteTest::whatIsNotPossibleIsNotDone()
{
    show();
    QSignalSpy done(actions_[3], &QAction::triggered);

    QTest::keyClicks(query(), "stop");
    QTest::keyClick(query(), Qt::Key_Return);

    QCOMPARE(done.size(), 0);
    QVERIFY(palette_->isVisible());
}

void CommandPaletteTest::lettersThatFitNothingDoNothing()
{
    show();

    QTest::keyClicks(query(), "qqq");
    QTest::keyClick(query(), Qt::Key_Return);

    QCOMPARE(palette_->findChild<QListWidget*>("commandList")->count(), 0);
    QVERIFY(palette_->isVisible());
    QTest::keyClick(query(), Qt::Key_Escape);
    QVERIFY(!palette_->isVisible());
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::CommandPaletteTest)
#include "command_palette_test.moc"
