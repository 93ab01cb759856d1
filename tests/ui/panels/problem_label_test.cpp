// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/problem_label.h"

#include <QApplication>
#include <QVBoxLayout>
#include <QtTest>

#include "tests/test_program.h"
#include "ui/theme/theme.h"

namespace planewright {

class ProblemLabelTest : public QObject {
    Q_OBJECT

private slots:
    void itIsThereOnlyWhileSomethingIsWrong();
    void itsColourFollowsTheTheme();
};

void ProblemLabelTest::itIsThereOnlyWhileSomethingIsWrong()
{
    QWidget window;
    auto* label = new ProblemLabel(&window);
    window.show();
    QVERIFY(!label->isVisible());

    label->tell("Give a number.");
    QVERIFY(label->isVisible());
    label->tell({});

    QVERIFY(!label->isVisible());
}

void ProblemLabelTest::itsColourFollowsTheTheme()
{
    const auto rgb = [](const QColor& colour) {
        return Rgb{static_cast<std::uint8_t>(colour.red()), static_cast<std::uint8_t>(colour.green()),
                   static_cast<std::uint8_t>(colour.blue())};
    };
    applyTheme(Theme::Light);
    QWidget window;
    ProblemLabel label(&window);

    for (const Theme theme : {Theme::Dark, Theme::Light, Theme::Dark}) {
        applyTheme(theme);
        const QPalette palette = label.palette();
        for (const QPalette::ColorRole background : {QPalette::Window, QPalette::Base})
            QVERIFY(contrast(rgb(palette.color(QPalette::WindowText)), rgb(palette.color(background))) >= 4.5);
        QVERIFY(palette.color(QPalette::WindowText).red() > palette.color(QPalette::WindowText).green() + 50);
    }
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::ProblemLabelTest)
#include "problem_label_test.moc"
