// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/dialogs/about_dialog.h"

#include <QClipboard>
#include <QLabel>
#include <QPushButton>
#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class AboutDialogTest : public QObject {
    Q_OBJECT

private slots:
    void itNamesVersionsAndLicence();
    void versionsAreCopied();
};

void AboutDialogTest::itNamesVersionsAndLicence()
{
    const AboutDialog dialog({{"Planewright", "1.2.3"}, {"Renderer", "<llvmpipe>"}});

    const QString text = dialog.findChild<QLabel*>("aboutText")->text();
    QVERIFY(text.contains("1.2.3"));
    QVERIFY(text.contains("&lt;llvmpipe&gt;"));
    QVERIFY(text.contains("BSD-3-Clause"));
}

void AboutDialogTest::versionsAreCopied()
{
    AboutDialog dialog({{"Planewright", "1.2.3"}, {"Qt", "6.4.2"}});

    dialog.findChild<QPushButton*>("copyVersions")->click();

    QCOMPARE(QGuiApplication::clipboard()->text(), QStringLiteral("Planewright 1.2.3\nQt 6.4.2\n"));
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::AboutDialogTest)
#include "about_dialog_test.moc"
