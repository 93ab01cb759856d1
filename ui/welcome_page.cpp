// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/welcome_page.h"

#include <cmath>

#include <QFileInfo>
#include <QFrame>
#include <QGridLayout>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

namespace planewright {

namespace {

struct Room {
    const char* scene;
    const char* title;
};
constexpr Room kRooms[]{{"office", "Office"},
                        {"hall", "Hall 20 × 25 m"},
                        {"curved", "Curved wall"},
                        {"stairs", "Stairs"},
                        {"clutter", "Cluttered room"}};

/// A font some times as large, whether its size is told in points or in pixels.
QFont scaled(QFont font, double factor)
{
    if (font.pixelSize() > 0)
        font.setPixelSize(static_cast<int>(std::lround(factor * font.pixelSize())));
    else
        font.setPointSizeF(factor * font.pointSizeF());
    return font;
}

/// A framed part of the page with a title and a line of text; buttons come into its layout.
QVBoxLayout* addCard(QHBoxLayout* row, const QString& title, const QString& text)
{
    auto* card = new QFrame;
    card->setFrameShape(QFrame::StyledPanel);
    card->setMinimumWidth(200);
    auto* layout = new QVBoxLayout(card);
    layout->setContentsMargins(14, 12, 14, 12);
    auto* heading = new QLabel(title);
    QFont font = scaled(heading->font(), 1.25);
    font.setBold(true);
    heading->setFont(font);
    layout->addWidget(heading);
    auto* line = new QLabel(text);
    line->setWordWrap(true);
    line->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    // A layout asks wrapped text for its height only while it has room for all of it.
    constexpr int kMostLines = 6;
    line->setMinimumHeight(kMostLines * line->fontMetrics().lineSpacing());
    layout->addWidget(line);
    layout->addStretch(1);
    row->addWidget(card, 1);
    return layout;
}

QPushButton* addButton(QBoxLayout* layout, const QString& text, const QString& name)
{
    auto* button = new QPushButton(text);
    button->setObjectName(name);
    button->setMinimumHeight(32);
    layout->addWidget(button);
    return button;
}

}  // namespace

WelcomePage::WelcomePage(QWidget* parent) : QWidget(parent), recent_(new QListWidget)
{
    setObjectName(QStringLiteral("welcome"));
    setAccessibleName(tr("Welcome"));
    // Where the window is low, the page scrolls.
    auto* area = new QScrollArea;
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setFocusPolicy(Qt::NoFocus);
    auto* content = new QWidget;
    area->setWidget(content);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(area);
    auto* page = new QVBoxLayout(content);
    page->setContentsMargins(24, 12, 24, 10);
    auto* title = new QLabel(tr("Watch a room grow into planes"));
    title->setFont(scaled(title->font(), 1.9));
    page->addWidget(title);
    page->addSpacing(6);

    auto* cards = new QHBoxLayout;
    cards->setSpacing(16);
    page->addLayout(cards);
    QVBoxLayout* sample =
        addCard(cards, tr("See it work"),
                tr("A simulated scanner nods through a corridor: line segments appear at once, the first planes after "
                   "five slices."));
    QPushButton* play = addButton(sample, tr("▶ Play the sample corridor"), QStringLiteral("welcomeSample"));
    play->setDefault(true);
    connect(play, &QPushButton::clicked, this, &WelcomePage::sampleRequested);

    QVBoxLayout* open = addCard(cards, tr("Open a recording"),
                                tr("A .pwscan project, or a recording as .csv or .csv.gz. Files can also be dropped "
                                   "onto this window."));
    QPushButton* choose = addButton(open, tr("Open…"), QStringLiteral("welcomeOpen"));
    connect(choose, &QPushButton::clicked, this, &WelcomePage::openDialogRequested);

    QVBoxLayout* scanner = addCard(cards, tr("Connect a scanner"),
                                   tr("A Hokuyo laser on a Dynamixel servo, or on a control board. What is plugged in "
                                      "is listed there, and tested before it scans."));
    QPushButton* connectScanner = addButton(scanner, tr("Connect…"), QStringLiteral("welcomeConnect"));
    connect(connectScanner, &QPushButton::clicked, this, &WelcomePage::connectRequested);

    page->addSpacing(8);
    page->addWidget(new QLabel(tr("Other simulated rooms, each known to the millimetre")));
    auto* rooms = new QHBoxLayout;
    rooms->setSpacing(8);
    page->addLayout(rooms);
    for (const Room& room : kRooms) {
        const QString scene = QLatin1String(room.scene);
        QPushButton* button = addButton(rooms, tr(room.title), QStringLiteral("welcome_") + scene);
        connect(button, &QPushButton::clicked, this,
                [this, scene] { emit openRequested(QStringLiteral("sim:%1?seed=1").arg(scene)); });
    }

    page->addSpacing(8);
    auto* recentTitle = new QLabel(tr("&Recent"));
    recentTitle->setBuddy(recent_);
    page->addWidget(recentTitle);
    recent_->setObjectName(QStringLiteral("welcomeRecent"));
    recent_->setAccessibleName(tr("Recent files"));
    constexpr int kOneRow = 34;  // [px]
    recent_->setMinimumHeight(kOneRow);
    recent_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);  // what is left is its
    page->addWidget(recent_, 1);
    connect(recent_, &QListWidget::itemActivated, this, [this](QListWidgetItem* item) {
        if (const QString file = item->data(Qt::UserRole).toString(); !file.isEmpty())
            emit openRequested(file);
    });
    auto* small =
        new QLabel(tr("Language and theme follow the system (change them in Preferences). Nothing is sent "
                      "anywhere."));
    small->setWordWrap(true);
    page->addWidget(small);
    setRecent({});
}

void WelcomePage::setRecent(const QStringList& files)
{
    recent_->clear();
    for (const QString& file : files) {
        const QFileInfo info(file);
        if (!info.exists())
            continue;
        auto* item = new QListWidgetItem(QStringLiteral("%1   %2").arg(info.fileName(), info.absolutePath()), recent_);
        item->setData(Qt::UserRole, info.absoluteFilePath());
        item->setSizeHint({0, 28});
    }
    if (recent_->count() == 0) {
        auto* item = new QListWidgetItem(tr("Nothing was opened yet."), recent_);
        item->setFlags(Qt::NoItemFlags);
    }
}

}  // namespace planewright
