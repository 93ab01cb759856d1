// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/theme/theme.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class ThemeTest : public QObject {
    Q_OBJECT

private slots:
    void textIsReadable_data();
    void textIsReadable();
    void aPaletteTellsItsTheme();
    void targetsAreLargeEnough();
    void focusIsARingOfTwoPixels_data();
    void focusIsARingOfTwoPixels();
};

namespace {

Rgb rgb(const QColor& colour)
{
    return {static_cast<std::uint8_t>(colour.red()), static_cast<std::uint8_t>(colour.green()),
            static_cast<std::uint8_t>(colour.blue())};
}

}  // namespace

void ThemeTest::textIsReadable_data()
{
    QTest::addColumn<Theme>("theme");
    QTest::newRow("light") << Theme::Light;
    QTest::newRow("dark") << Theme::Dark;
}

void ThemeTest::textIsReadable()
{
    QFETCH(Theme, theme);
    const QPalette palette = applicationPalette(theme);
    const std::vector<std::pair<QPalette::ColorRole, QPalette::ColorRole>> pairs{
        {QPalette::WindowText, QPalette::Window},
        {QPalette::Text, QPalette::Base},
        {QPalette::Text, QPalette::AlternateBase},
        {QPalette::ButtonText, QPalette::Button},
        {QPalette::HighlightedText, QPalette::Highlight},
        {QPalette::PlaceholderText, QPalette::Base},
        {QPalette::Link, QPalette::Window},
        {QPalette::ToolTipText, QPalette::ToolTipBase}};

    for (const QPalette::ColorGroup group : {QPalette::Active, QPalette::Inactive, QPalette::Disabled}) {
        for (const auto& [text, background] : pairs) {
            const double found = contrast(rgb(palette.color(group, text)), rgb(palette.color(group, background)));
            QVERIFY2(found >= 4.5, qPrintable(QString("role %1 in group %2: %3").arg(text).arg(group).arg(found)));
        }
    }
}

void ThemeTest::aPaletteTellsItsTheme()
{
    QCOMPARE(themeOf(applicationPalette(Theme::Light)), Theme::Light);
    QCOMPARE(themeOf(applicationPalette(Theme::Dark)), Theme::Dark);
}

void ThemeTest::targetsAreLargeEnough()
{
    applyTheme(Theme::Light);
    QPushButton button(QStringLiteral("Go"));
    QToolButton tool;
    QComboBox choices;
    QLineEdit edit;
    QDoubleSpinBox number;
    QCheckBox check(QStringLiteral("On"));

    for (const QWidget* widget : std::initializer_list<QWidget*>{&button, &tool, &choices, &edit, &number, &check})
        QVERIFY2(widget->sizeHint().height() >= 28, widget->metaObject()->className());
    QVERIFY(tool.sizeHint().width() >= 28);
}

void ThemeTest::focusIsARingOfTwoPixels_data()
{
    textIsReadable_data();
}

void ThemeTest::focusIsARingOfTwoPixels()
{
    QFETCH(Theme, theme);
    applyTheme(theme);
    QWidget window;
    auto* layout = new QVBoxLayout(&window);
    auto* edit = new QLineEdit(&window);
    auto* choices = new QComboBox(&window);
    auto* number = new QDoubleSpinBox(&window);
    for (QWidget* widget : std::initializer_list<QWidget*>{edit, choices, number})
        layout->addWidget(widget);
    window.show();
    window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&window));

    for (QWidget* widget : std::initializer_list<QWidget*>{edit, choices, number}) {
        widget->setFocus();
        const QImage image = widget->grab().toImage();
        const QColor ring = QApplication::palette().color(QPalette::Highlight);
        const int middle = image.height() / 2;
        for (const int x : {0, 1}) {
            const QColor pixel = image.pixelColor(x, middle);
            QVERIFY2(std::abs(pixel.blue() - ring.blue()) < 40 && std::abs(pixel.red() - ring.red()) < 40,
                     qPrintable(QString("%1: %2 at %3").arg(widget->metaObject()->className(), pixel.name()).arg(x)));
        }
    }
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::ThemeTest)
#include "theme_test.moc"
