// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/dialogs/action_list.h"

#include <QAction>
#include <QMenu>
#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class ActionListTest : public QObject {
    Q_OBJECT

private slots:
    void actionsAreListedOnceWithMenuAndKeys();
    void lettersFitInTheirOrder();
    void beginningsOfWordsFitBetter();
};

void ActionListTest::actionsAreListedOnceWithMenuAndKeys()
{
    QMenu menu(QStringLiteral("&Scan"));
    QAction* start = menu.addAction(QStringLiteral("&Start && go"));
    start->setObjectName("actStart");
    start->setShortcuts({QKeySequence("F5"), QKeySequence("Ctrl+Return")});
    QAction* nameless = menu.addAction(QStringLiteral("Nameless"));
    QAction* separator = menu.addSeparator();

    const auto listed = listedActions({start, nameless, separator, start});

    QCOMPARE(listed.size(), std::size_t(1));
    QCOMPARE(listed[0].group, QStringLiteral("Scan"));
    QCOMPARE(listed[0].text, QStringLiteral("Start & go"));
    QCOMPARE(listed[0].keys, QStringLiteral("F5; Ctrl+Return"));
}

void ActionListTest::lettersFitInTheirOrder()
{
    QVERIFY(fuzzyFit("", "Export planes") >= 0);
    QVERIFY(fuzzyFit("expl", "Export planes") > 0);
    QVERIFY(fuzzyFit("EX PL", "Export planes") > 0);
    QVERIFY(fuzzyFit("lpxe", "Export planes") < 0);
    QVERIFY(fuzzyFit("planesx", "Export planes") < 0);
    QVERIFY(fuzzyFit("ss", "s") < 0);
}

void ActionListTest::beginningsOfWordsFitBetter()
{
    QVERIFY(fuzzyFit("ep", "Export planes") > fuzzyFit("ep", "Keep points"));
    QVERIFY(fuzzyFit("fit", "Fit selection") > fuzzyFit("fit", "File a ticket"));
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::ActionListTest)
#include "action_list_test.moc"
