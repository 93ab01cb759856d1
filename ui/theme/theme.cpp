// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/theme/theme.h"

#include <QApplication>

#include "ui/theme/clear_style.h"

namespace planewright {

namespace {

struct Colours {
    QColor window;
    QColor base;
    QColor alternate;
    QColor button;
    QColor text;
    QColor dimmed;  ///< of what is disabled or stands for a text to come
    QColor accent;
    QColor onAccent;
    QColor link;
    QColor tip;
};

Colours coloursOf(Theme theme)
{
    if (theme == Theme::Dark)
        return {.window = {43, 46, 52},
                .base = {30, 33, 38},
                .alternate = {37, 40, 46},
                .button = {56, 60, 68},
                .text = {232, 234, 238},
                .dimmed = {170, 175, 183},
                .accent = {110, 170, 255},
                .onAccent = {12, 18, 28},
                .link = {128, 184, 255},
                .tip = {24, 26, 30}};
    return {.window = {240, 241, 243},
            .base = {255, 255, 255},
            .alternate = {246, 247, 249},
            .button = {232, 234, 238},
            .text = {28, 31, 36},
            .dimmed = {96, 101, 109},
            .accent = {21, 94, 184},
            .onAccent = {255, 255, 255},
            .link = {18, 84, 168},
            .tip = {255, 255, 255}};
}

}  // namespace

QPalette applicationPalette(Theme theme)
{
    const Colours colours = coloursOf(theme);
    QPalette palette(colours.text, colours.button, colours.button.lighter(120), colours.button.darker(160),
                     colours.button.darker(130), colours.text, colours.text, colours.base, colours.window);
    palette.setColor(QPalette::AlternateBase, colours.alternate);
    palette.setColor(QPalette::Highlight, colours.accent);
    palette.setColor(QPalette::HighlightedText, colours.onAccent);
    palette.setColor(QPalette::Link, colours.link);
    palette.setColor(QPalette::LinkVisited, colours.link);
    palette.setColor(QPalette::PlaceholderText, colours.dimmed);
    palette.setColor(QPalette::ToolTipBase, colours.tip);
    palette.setColor(QPalette::ToolTipText, colours.text);
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, colours.dimmed);
    palette.setColor(QPalette::Disabled, QPalette::Highlight, colours.button);
    palette.setColor(QPalette::Disabled, QPalette::HighlightedText, colours.dimmed);
    return palette;
}

void applyTheme(Theme theme)
{
    if (qobject_cast<ClearStyle*>(QApplication::style()) == nullptr)
        QApplication::setStyle(makeClearStyle());
    QApplication::setPalette(applicationPalette(theme));
}

Theme themeOf(const QPalette& palette)
{
    return palette.color(QPalette::Window).lightness() < palette.color(QPalette::WindowText).lightness() ? Theme::Dark
                                                                                                         : Theme::Light;
}

}  // namespace planewright
