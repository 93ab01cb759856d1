// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/dialogs/shortcuts_page.h"

#include <QAction>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QtTest>

#include "tests/test_program.h"
#include "ui/dialogs/shortcuts_dialog.h"

namespace planewright {

class ShortcutsPageTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void newKeysTakeThePlaceOfAnActionsOwn();
    void keysThatAreTakenSayByWhom();
    void stopMotionGainsKeysAndKeepsItsOwn();
    void noKeysAtAllIsAChoice();
    void ownKeysComeBack();
    void keysOfThePreferencesAreInForce();
    void theListIsSearched();

private:
    void set(int row, const char* keys);
    QString keysOf(int row) const { return table()->item(row, 1)->text(); }
    QTableWidget* table() const { return page_->findChild<QTableWidget*>("shortcutTable"); }

    std::unique_ptr<QObject> holder_;
    QList<QAction*> actions_;
    std::unique_ptr<ShortcutsPage> page_;
};

void ShortcutsPageTest::init()
{
    page_.reset();
    actions_.clear();
    holder_ = std::make_unique<QObject>();
    for (const auto& [name, text, keys] :
         {std::tuple{"actStart", "Start", "F5"}, {"actStop", "Stop motion", "Ctrl+."}, {"actFit", "Fit", "F"}}) {
        auto* action = new QAction(QString::fromLatin1(text), holder_.get());
        action->setObjectName(QString::fromLatin1(name));
        action->setShortcut(QKeySequence(QString::fromLatin1(keys)));
        actions_ << action;
    }
    rememberOwnKeys(actions_);
    page_ = std::make_unique<ShortcutsPage>(actions_, ShortcutMap{}, QSet<QString>{"actStop"});
}

void ShortcutsPageTest::set(int row, const char* keys)
{
    table()->setCurrentCell(row, 0);
    page_->findChild<QKeySequenceEdit*>("shortcutKeys")->setKeySequence(QKeySequence(QString::fromLatin1(keys)));
    page_->findChild<QPushButton*>("setShortcut")->click();
}

void ShortcutsPageTest::newKeysTakeThePlaceOfAnActionsOwn()
{
    set(0, "Ctrl+G");

    QCOMPARE(keysOf(0), QStringLiteral("Ctrl+G"));
    QVERIFY(page_->changed() == (ShortcutMap{{"actStart", {"Ctrl+G"}}}));
    QCOMPARE(actions_[0]->shortcut(), QKeySequence("F5"));  // not before the preferences are applied
}

void ShortcutsPageTest::keysThatAreTakenSayByWhom()
{
    set(0, "F");

    QCOMPARE(page_->findChild<QLabel*>("problem")->text(),
             QStringLiteral("F belongs to “Fit”. Give that other keys first."));
    QVERIFY(page_->changed().empty());
    set(2, "Shift+F");
    set(0, "F");
    QCOMPARE(keysOf(0), QStringLiteral("F"));
}

void ShortcutsPageTest::stopMotionGainsKeysAndKeepsItsOwn()
{
    set(1, "Ctrl+0");
    QCOMPARE(keysOf(1), QStringLiteral("Ctrl+.; Ctrl+0"));
    set(1, "");
    QCOMPARE(keysOf(1), QStringLiteral("Ctrl+."));
}

void ShortcutsPageTest::noKeysAtAllIsAChoice()
{
    set(2, "");

    QCOMPARE(keysOf(2), QString());
    QVERIFY(page_->changed() == (ShortcutMap{{"actFit", {}}}));
}

void ShortcutsPageTest::ownKeysComeBack()
{
    set(0, "Ctrl+G");
    set(2, "Ctrl+H");
    table()->setCurrentCell(0, 0);

    page_->findChild<QPushButton*>("ownShortcut")->click();
    QCOMPARE(keysOf(0), QStringLiteral("F5"));
    QCOMPARE(keysOf(2), QStringLiteral("Ctrl+H"));
    page_->restoreDefaults();

    QCOMPARE(keysOf(2), QStringLiteral("F"));
    QVERIFY(page_->changed().empty());
}

void ShortcutsPageTest::keysOfThePreferencesAreInForce()
{
    const ShortcutMap changed{{"actStart", {"Ctrl+G", "F6"}}, {"actStop", {"Ctrl+0"}}, {"actGone", {"F7"}}};

    applyShortcuts(actions_, changed, {"actStop"});

    QCOMPARE(actions_[0]->shortcuts(), (QList<QKeySequence>{QKeySequence("Ctrl+G"), QKeySequence("F6")}));
    QCOMPARE(actions_[1]->shortcuts(), (QList<QKeySequence>{QKeySequence("Ctrl+."), QKeySequence("Ctrl+0")}));
    QCOMPARE(actions_[2]->shortcuts(), QList<QKeySequence>{QKeySequence("F")});
    applyShortcuts(actions_, {}, {"actStop"});
    QCOMPARE(actions_[0]->shortcuts(), QList<QKeySequence>{QKeySequence("F5")});
}

void ShortcutsPageTest::theListIsSearched()
{
    QCOMPARE(page_->search("sto"), 1);
    QVERIFY(table()->isRowHidden(0));
    QCOMPARE(page_->search(""), 3);

    ShortcutsDialog dialog(actions_);
    auto* shown = dialog.findChild<QTableWidget*>("shortcutTable");
    QCOMPARE(shown->rowCount(), 3);
    QCOMPARE(shown->item(1, 2)->text(), QStringLiteral("Ctrl+."));
    dialog.findChild<QLineEdit*>("shortcutSearch")->setText("F5");
    QVERIFY(!shown->isRowHidden(0));
    QVERIFY(shown->isRowHidden(1));
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::ShortcutsPageTest)
#include "shortcuts_page_test.moc"
