// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/timeline_panel.h"

#include <algorithm>
#include <array>

#include <QAction>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QMenu>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include "ui/panels/plain_fields.h"
#include "ui/panels/timeline_button.h"

namespace planewright {

namespace {

struct Speed {
    double times;
    const char* text;
};
constexpr std::array<Speed, 7> kSpeeds{
    {{0.1, "0.1×"}, {0.25, "0.25×"}, {0.5, "0.5×"}, {1.0, "1×"}, {2.0, "2×"}, {5.0, "5×"}, {10.0, "10×"}}};
constexpr int kRealTime = 3;

struct EventChoice {
    const char* text;
    TimelineEvent kind;
};
constexpr std::array<EventChoice, 6> kEventChoices{
    {{QT_TRANSLATE_NOOP("Timeline", "Any event"), TimelineEvent::Any},
     {QT_TRANSLATE_NOOP("Timeline", "New planes"), TimelineEvent::Fits},
     {QT_TRANSLATE_NOOP("Timeline", "Splits, merges"), TimelineEvent::SplitsAndMerges},
     {QT_TRANSLATE_NOOP("Timeline", "Faults"), TimelineEvent::Faults},
     {QT_TRANSLATE_NOOP("Timeline", "Edits"), TimelineEvent::Edits},
     {QT_TRANSLATE_NOOP("Timeline", "Bookmarks"), TimelineEvent::Bookmarks}}};

/// Keys that a box of choices needs for itself while it has the keyboard.
bool isOfComboBox(int key)
{
    return key == Qt::Key_Space || key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_Home ||
           key == Qt::Key_End;
}

}  // namespace

TimelinePanel::TimelinePanel(const TimelineActions& actions, QWidget* parent)
    : QWidget(parent),
      strip_(new TimelineStrip),
      step_(new QSpinBox),
      speed_(new QuietComboBox),
      kind_(new QuietComboBox),
      live_(new LiveButton(actions.live)),
      menu_(new QMenu(this))
{
    setObjectName(QStringLiteral("timelinePanel"));
    setAccessibleName(tr("Timeline"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(2, 2, 2, 2);
    layout->setSpacing(2);
    makeRow(actions);
    layout->addWidget(strip_, 1);
    menu_->setObjectName(QStringLiteral("timelineMenu"));

    connect(strip_, &TimelineStrip::placeChosen, this, &TimelinePanel::placeRequested);
    connect(strip_, &TimelineStrip::loopChosen, this, &TimelinePanel::loopRequested);
    connect(strip_, &TimelineStrip::menuRequested, this, [this](int place, QPoint screen) {
        menuPlace_ = place;
        menu_->popup(screen);
    });
    connect(step_, &QSpinBox::valueChanged, this, [this](int value) { emit stepRequested(value - 1); });
    connect(speed_, &QComboBox::currentIndexChanged, this, [this] { emit speedChanged(speed()); });
    connect(kind_, &QComboBox::currentIndexChanged, this, &TimelinePanel::eventKindChanged);
    setColumns({}, 0, true);
}

void TimelinePanel::makeRow(const TimelineActions& actions)
{
    step_->setObjectName(QStringLiteral("timelineStep"));
    step_->setAccessibleName(tr("Step that is looked at"));
    step_->setToolTip(tr("Step that is looked at: type a number to go there"));
    step_->setKeyboardTracking(false);
    step_->setFocusPolicy(Qt::StrongFocus);
    step_->setAlignment(Qt::AlignRight);
    speed_->setObjectName(QStringLiteral("timelineSpeed"));
    speed_->setAccessibleName(tr("Speed of playing"));
    speed_->setToolTip(tr("Speed of playing: 1× is the time that the scan took (- and =)"));
    for (const Speed& speed : kSpeeds)
        speed_->addItem(QString::fromUtf8(speed.text), speed.times);
    speed_->setCurrentIndex(kRealTime);
    speed_->setMinimumContentsLength(4);
    kind_->setObjectName(QStringLiteral("timelineEventKind"));
    kind_->setAccessibleName(tr("Kind of event to go to"));
    kind_->setToolTip(tr("What the keys for events go to (Shift+, and Shift+.)"));
    for (const EventChoice& choice : kEventChoices)
        kind_->addItem(QCoreApplication::translate("Timeline", choice.text));
    kind_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    for (QComboBox* box : {speed_, kind_})
        box->installEventFilter(this);

    auto* row = new QHBoxLayout;
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(2);
    const auto add = [&](TimelineGlyph glyph, QAction* action) { row->addWidget(new TimelineButton(glyph, action)); };
    constexpr int kGroupGap = 6;  // [px]
    add(TimelineGlyph::First, actions.first);
    add(TimelineGlyph::Back, actions.back);
    add(TimelineGlyph::Play, actions.play);
    add(TimelineGlyph::Forward, actions.forward);
    add(TimelineGlyph::Last, actions.last);
    row->addSpacing(kGroupGap);
    row->addWidget(step_);
    row->addSpacing(kGroupGap);
    row->addWidget(speed_);
    add(TimelineGlyph::Loop, actions.loop);
    row->addSpacing(kGroupGap);
    row->addWidget(kind_);
    add(TimelineGlyph::Earlier, actions.eventBack);
    add(TimelineGlyph::Later, actions.eventForward);
    row->addStretch(1);
    row->addWidget(live_);
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
}

void TimelinePanel::setColumns(std::vector<TimelineColumn> columns, int planned, bool isWhole)
{
    const int known = static_cast<int>(columns.size());
    int last = 0;
    for (const TimelineColumn& column : columns)
        last = std::max(last, column.step + 1);
    const int steps = std::max(planned, last);
    const QSignalBlocker quiet(step_);
    step_->setEnabled(known > 0);
    step_->setRange(known > 0 ? 1 : 0, std::max(last, 0));
    step_->setSuffix(QStringLiteral(" / %1").arg(steps));
    strip_->setPlanned(steps);
    // A scan that goes on ends with the forced last pass.
    strip_->setColumns(std::move(columns), isWhole || planned == 0 ? known : planned + 1);
}

void TimelinePanel::setPlace(int place)
{
    strip_->setPlace(place);
    const auto& columns = strip_->columns();
    if (place < 0 || place >= static_cast<int>(columns.size()))
        return;
    const int step = columns[static_cast<std::size_t>(place)].step;
    const QSignalBlocker quiet(step_);
    step_->setValue(step >= 0 ? step + 1 : step_->maximum());
}

void TimelinePanel::setLooksBack(bool looksBack)
{
    strip_->setLooksBack(looksBack);
    live_->setCalling(looksBack);
}

double TimelinePanel::speed() const
{
    return speed_->currentData().toDouble();
}

void TimelinePanel::changeSpeed(int by)
{
    speed_->setCurrentIndex(std::clamp(speed_->currentIndex() + by, 0, speed_->count() - 1));
}

TimelineEvent TimelinePanel::eventKind() const
{
    return kEventChoices[static_cast<std::size_t>(kind_->currentIndex())].kind;
}

void TimelinePanel::setPlaceActions(const QList<QAction*>& actions)
{
    menu_->addActions(actions);
}

bool TimelinePanel::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride && isOfComboBox(static_cast<QKeyEvent*>(event)->key())) {
        event->accept();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace planewright
