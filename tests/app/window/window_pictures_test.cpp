// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QApplication>
#include <QtTest>

#include "app/window/screenshot.h"
#include "tests/app/window/shown_window.h"
#include "tests/test_program.h"
#include "tests/ui/view3d/reference_image.h"

namespace planewright {

/// The whole window with its docks, beside pictures that somebody has looked at.
class WindowPicturesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { useFixedLook(); }
    void wholeWindowsAreAsTheyWere_data();
    void wholeWindowsAreAsTheyWere();

private:
    QTemporaryDir folder_;
};

void WindowPicturesTest::wholeWindowsAreAsTheyWere_data()
{
    QTest::addColumn<bool>("dark");
    QTest::addColumn<bool>("scanned");
    QTest::newRow("window-light") << false << true;
    QTest::newRow("window-dark") << true << true;
    QTest::newRow("window-welcome-light") << false << false;
    QTest::newRow("window-welcome-dark") << true << false;
}

void WindowPicturesTest::wholeWindowsAreAsTheyWere()
{
    QFETCH(bool, dark);
    QFETCH(bool, scanned);
    auto opened = ShownWindow::open(folder_.filePath("settings.ini"));
    QVERIFY2(opened, opened ? "" : opened.error().message.c_str());
    ShownWindow& shown = **opened;
    WindowParts& parts = shown.parts;
    parts.preferences.theme = dark ? ThemeChoice::Dark : ThemeChoice::Light;
    emit parts.preferencesChanged();
    parts.window->resize(1440, 900);
    if (scanned) {
        QVERIFY(shown.scanCorridor());
        parts.selection.select({parts.shown->planes[1].plane->id});
        // What depends on the machine is not compared.
        for (const char* item : {"stDevice", "stStep", "stQueue", "stRec", "stMessage"})
            parts.window->setStatus(QLatin1String(item), QLatin1String(item));
    }
    parts.logModel.clear();
    QTest::qWait(400);

    const double scale = parts.window->devicePixelRatioF();
    QString name = QString::fromLatin1(QTest::currentDataTag());
    if (scale != 1.0)
        name += QStringLiteral("-scale-%1").arg(scale);
    const QString difference = differenceFromReference(takePicture(parts, {}, true), name);

    QVERIFY2(difference.isEmpty(), qPrintable(difference));
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::WindowPicturesTest)
#include "window_pictures_test.moc"
