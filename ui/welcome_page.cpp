// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/welcome_page.h"

#include <cmath>
#include <iterator>

#include <QFileInfo>
#include <QFrame>
#include <QGridLayout>
#include <QLabel>
#include <QResizeEvent>
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

constexpr int kPageMargin = 24;  // [px]
constexpr int kCardMargin = 14;  // [px]
constexpr int kCardWidth = 200;  // the least [px]
constexpr int kCardSpace = 16;   // between two cards [px]

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
QVBoxLayout* addCard(QBoxLayout* row, const QString& title, const QString& text, std::vector<QLabel*>& lines)
{
    auto* card = new QFrame;
    card->setFrameShape(QFrame::StyledPanel);
    card->setMinimumWidth(kCardWidth);
    auto* layout = new QVBoxLayout(card);
    layout->setContentsMargins(kCardMargin, 12, kCardMargin, 12);
    auto* heading = new QLabel(title);
    QFont font = scaled(heading->font(), 1.25);
    font.setBold(true);
    heading->setFont(font);
    layout->addWidget(heading);
    auto* line = new QLabel(text);
    line->setWordWrap(true);
    line->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    layout->addWidget(line);
    lines.push_back(line);
    layout->addStretch(1);
    row->addWidget(card, 1);
    return layout;
}

QPushButton* addButton(const QString& text, const QString& name)
{
    auto* button = new QPushButton(text);
    button->setObjectName(name);
    button->setMinimumHeight(32);
    return button;
}

}  // namespace

WelcomePage::WelcomePage(QWidget* parent)
    : QWidget(parent),
      cards_(new QBoxLayout(QBoxLayout::LeftToRight)),
      rooms_(new QGridLayout),
      small_(new QLabel(tr("Language and theme follow the system (change them in Preferences). Nothing is sent "
                           "anywhere."))),
      recent_(new QListWidget)
{
    setObjectName(QStringLiteral("welcome"));
    setAccessibleName(tr("Welcome"));
    // Where the window is low, the page scrolls; where it is narrow, its parts stand below each other.
    auto* area = new QScrollArea;
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setFocusPolicy(Qt::NoFocus);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->viewport()->installEventFilter(this);
    auto* content = new QWidget;
    area->setWidget(content);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(area);
    auto* page = new QVBoxLayout(content);
    page->setContentsMargins(kPageMargin, 12, kPageMargin, 10);
    auto* title = new QLabel(tr("Watch a room grow into planes"));
    title->setObjectName(QStringLiteral("welcomeTitle"));
    title->setFont(scaled(title->font(), 1.9));
    title->setWordWrap(true);
    lines_.push_back(title);
    page->addWidget(title);
    page->addSpacing(6);
    addCards(page);
    page->addSpacing(8);
    addRooms(page);
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
    small_->setWordWrap(true);
    page->addWidget(small_);
    setRecent({});
    arrange(width());
}

void WelcomePage::addCards(QVBoxLayout* page)
{
    cards_->setSpacing(kCardSpace);
    page->addLayout(cards_);
    QVBoxLayout* sample =
        addCard(cards_, tr("See it work"),
                tr("A simulated scanner nods through a corridor: line segments appear at once, the first planes after "
                   "five slices."),
                lines_);
    QPushButton* play = addButton(tr("▶ Play the sample corridor"), QStringLiteral("welcomeSample"));
    sample->addWidget(play);
    play->setDefault(true);
    connect(play, &QPushButton::clicked, this, &WelcomePage::sampleRequested);

    QVBoxLayout* open = addCard(cards_, tr("Open a recording"),
                                tr("A .pwscan project, or a recording as .csv or .csv.gz. Files can also be dropped "
                                   "onto this window."),
                                lines_);
    QPushButton* choose = addButton(tr("Open…"), QStringLiteral("welcomeOpen"));
    open->addWidget(choose);
    connect(choose, &QPushButton::clicked, this, &WelcomePage::openDialogRequested);

    QVBoxLayout* scanner = addCard(cards_, tr("Connect a scanner"),
                                   tr("A Hokuyo laser on a Dynamixel servo, or on a control board. What is plugged in "
                                      "is listed there, and tested before it scans."),
                                   lines_);
    QPushButton* connectScanner = addButton(tr("Connect…"), QStringLiteral("welcomeConnect"));
    scanner->addWidget(connectScanner);
    connect(connectScanner, &QPushButton::clicked, this, &WelcomePage::connectRequested);
}

void WelcomePage::addRooms(QVBoxLayout* page)
{
    auto* heading = new QLabel(tr("Other simulated rooms, each known to the millimetre"));
    heading->setWordWrap(true);
    lines_.push_back(heading);
    page->addWidget(heading);
    rooms_->setSpacing(8);
    page->addLayout(rooms_);
    int column = 0;
    for (const Room& room : kRooms) {
        const QString scene = QLatin1String(room.scene);
        QPushButton* button = addButton(tr(room.title), QStringLiteral("welcome_") + scene);
        rooms_->addWidget(button, 0, column++);
        connect(button, &QPushButton::clicked, this,
                [this, scene] { emit openRequested(QStringLiteral("sim:%1?seed=1").arg(scene)); });
    }
}

bool WelcomePage::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize)
        arrange(static_cast<const QResizeEvent*>(event)->size().width());
    return QWidget::eventFilter(watched, event);
}

/// Cards and rooms beside each other where there is room for them in this width, and wrapped text with all of its
/// lines: a layout asks it for its height only while it has room for them.
void WelcomePage::arrange(int width)
{
    const int room = width - 2 * kPageMargin;
    const int count = cards_->count();
    const bool isNarrow = room < count * kCardWidth + (count - 1) * kCardSpace;
    cards_->setDirection(isNarrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    const int columns = isNarrow ? 2 : static_cast<int>(std::size(kRooms));
    std::vector<QWidget*> buttons;
    while (QLayoutItem* item = rooms_->takeAt(0)) {
        buttons.push_back(item->widget());
        delete item;
    }
    for (int i = 0; i < static_cast<int>(buttons.size()); ++i)
        rooms_->addWidget(buttons[static_cast<std::size_t>(i)], i / columns, i % columns);
    const int card = isNarrow ? room : (room - (count - 1) * kCardSpace) / count;
    for (QLabel* line : lines_) {
        const bool isInCard = qobject_cast<QFrame*>(line->parentWidget()) != nullptr;
        line->setMinimumHeight(line->heightForWidth(isInCard ? card - 2 * kCardMargin - 2 : room));
    }
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
