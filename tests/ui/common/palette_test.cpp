// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/common/palette.h"

#include <set>
#include <tuple>

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class PaletteTest : public QObject {
    Q_OBJECT

private slots:
    void contrastIsThatOfThePublishedFormula();
    void everyPlaneOfOneRoundHasAColourOfItsOwn_data();
    void everyPlaneOfOneRoundHasAColourOfItsOwn();
    void coloursComeRoundAgain();
    void marksStandOutFromTheBackground_data();
    void marksStandOutFromTheBackground();
    void textIsReadable_data();
    void textIsReadable();
};

namespace {

void addThemes()
{
    QTest::addColumn<Theme>("theme");
    QTest::newRow("light") << Theme::Light;
    QTest::newRow("dark") << Theme::Dark;
}

void addPalettes()
{
    QTest::addColumn<Theme>("theme");
    QTest::addColumn<PlanePalette>("palette");
    for (const Theme theme : {Theme::Light, Theme::Dark}) {
        for (std::size_t i = 0; i < kPlanePaletteNames.size(); ++i)
            QTest::addRow("%s %s", theme == Theme::Light ? "light" : "dark", kPlanePaletteNames[i].data())
                << theme << static_cast<PlanePalette>(i);
    }
}

}  // namespace

void PaletteTest::contrastIsThatOfThePublishedFormula()
{
    // WCAG 2: black on white is 21; #777777 on white is the well-known 4.48.
    QVERIFY(std::abs(contrast({0, 0, 0}, {255, 255, 255}) - 21.0) < 1e-9);
    QVERIFY(std::abs(contrast({255, 255, 255}, {0x77, 0x77, 0x77}) - 4.48) < 0.005);
}

void PaletteTest::everyPlaneOfOneRoundHasAColourOfItsOwn_data()
{
    addPalettes();
}

void PaletteTest::everyPlaneOfOneRoundHasAColourOfItsOwn()
{
    QFETCH(Theme, theme);
    QFETCH(PlanePalette, palette);

    std::set<std::tuple<int, int, int>> colours;
    for (PlaneId id = 0; id < kPlaneColours; ++id) {
        const Rgb colour = planeColour(id, palette, theme);
        colours.insert({colour.red, colour.green, colour.blue});
    }

    QCOMPARE(colours.size(), static_cast<std::size_t>(kPlaneColours));
}

void PaletteTest::coloursComeRoundAgain()
{
    QVERIFY(planeColour(kPlaneColours + 5, PlanePalette::Normal, Theme::Light) ==
            planeColour(5, PlanePalette::Normal, Theme::Light));
}

void PaletteTest::marksStandOutFromTheBackground_data()
{
    addPalettes();
}

void PaletteTest::marksStandOutFromTheBackground()
{
    QFETCH(Theme, theme);
    QFETCH(PlanePalette, palette);

    const Rgb background = themeColours(theme).background;

    // The first dozen are what most rooms show; what is lightened after them need only be told apart.
    for (PlaneId id = 0; id < 12; ++id) {
        const double ratio = contrast(planeColour(id, palette, theme), background);
        QVERIFY2(ratio >= (palette == PlanePalette::ColourBlind ? 2.0 : 2.5),
                 qPrintable(QString("%1: %2").arg(id).arg(ratio)));
    }
    QVERIFY(contrast(themeColours(theme).unfitted, background) >= 3.0);
    QVERIFY(contrast(themeColours(theme).sensor, background) >= 3.0);
}

void PaletteTest::textIsReadable_data()
{
    addThemes();
}

void PaletteTest::textIsReadable()
{
    QFETCH(Theme, theme);

    const ThemeColours& colours = themeColours(theme);

    QVERIFY(contrast(colours.text, colours.background) >= 4.5);
    QVERIFY(contrast(colours.text, colours.backgroundTop) >= 4.5);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::PaletteTest)
#include "palette_test.moc"
