// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/theme/theme_follower.h"

#include <QApplication>
#include <QSignalSpy>
#include <QtTest>

#include "tests/test_program.h"
#include "ui/theme/motion.h"
#include "ui/theme/theme.h"

namespace planewright {

class ThemeFollowerTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void withoutADesktopThePaletteDecides();
    void theDesktopIsFollowed();
    void aChoiceWinsOverTheDesktop();
    void otherSettingsAreNoBusinessOfOurs();
    void theDesktopMayAskForLessMotion();
    void withoutABusNothingHappens();
};

namespace {

void say(ThemeFollower& follower, unsigned int scheme)
{
    follower.takeSetting(QStringLiteral("org.freedesktop.appearance"), QStringLiteral("color-scheme"),
                         QDBusVariant(scheme));
}

}  // namespace

void ThemeFollowerTest::init()
{
    QApplication::setPalette(applicationPalette(Theme::Light));
}

void ThemeFollowerTest::withoutADesktopThePaletteDecides()
{
    QCOMPARE(ThemeFollower().theme(), Theme::Light);
    QApplication::setPalette(applicationPalette(Theme::Dark));
    QCOMPARE(ThemeFollower().theme(), Theme::Dark);
}

void ThemeFollowerTest::theDesktopIsFollowed()
{
    ThemeFollower follower;
    QSignalSpy changed(&follower, &ThemeFollower::themeChanged);

    say(follower, 1);
    QCOMPARE(follower.theme(), Theme::Dark);
    say(follower, 1);
    say(follower, 2);
    QCOMPARE(follower.theme(), Theme::Light);
    say(follower, 0);  // no preference: what the palette was

    QCOMPARE(follower.theme(), Theme::Light);
    QCOMPARE(changed.size(), 2);
}

void ThemeFollowerTest::aChoiceWinsOverTheDesktop()
{
    ThemeFollower follower;
    say(follower, 1);
    QSignalSpy changed(&follower, &ThemeFollower::themeChanged);

    follower.setChoice(ThemeChoice::Light);
    QCOMPARE(follower.theme(), Theme::Light);
    say(follower, 2);
    say(follower, 1);
    QCOMPARE(changed.size(), 1);
    follower.setChoice(ThemeChoice::System);

    QCOMPARE(follower.theme(), Theme::Dark);
    QCOMPARE(changed.size(), 2);
}

void ThemeFollowerTest::otherSettingsAreNoBusinessOfOurs()
{
    ThemeFollower follower;

    follower.takeSetting(QStringLiteral("org.freedesktop.appearance"), QStringLiteral("contrast"), QDBusVariant(1U));
    follower.takeSetting(QStringLiteral("org.gnome.desktop"), QStringLiteral("color-scheme"), QDBusVariant(1U));

    QCOMPARE(follower.theme(), Theme::Light);
}

void ThemeFollowerTest::theDesktopMayAskForLessMotion()
{
    ThemeFollower follower;
    const auto hear = [&](unsigned int value) {
        follower.takeSetting(QStringLiteral("org.freedesktop.appearance"), QStringLiteral("reduced-motion"),
                             QDBusVariant(value));
    };

    hear(1);
    const bool reduced = isMotionReduced();
    hear(0);

    QVERIFY(reduced);
    QVERIFY(!isMotionReduced());
}

void ThemeFollowerTest::withoutABusNothingHappens()
{
    ThemeFollower follower;

    follower.askDesktop();

    QTest::qWait(20);
    QCOMPARE(follower.theme(), Theme::Light);
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::ThemeFollowerTest)
#include "theme_follower_test.moc"
