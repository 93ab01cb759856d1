// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/app/window/random_user.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSlider>
#include <QTabBar>
#include <QTableView>
#include <QWheelEvent>
#include <QtTest>

namespace planewright {

namespace {

constexpr int kDeedsKept = 30;
constexpr int kDialogPatience = 8;  ///< events in a dialog before it is left
constexpr std::array kKeys{Qt::Key_Escape,   Qt::Key_Return, Qt::Key_Tab,    Qt::Key_Space, Qt::Key_Delete,
                           Qt::Key_Left,     Qt::Key_Right,  Qt::Key_Up,     Qt::Key_Down,  Qt::Key_Home,
                           Qt::Key_End,      Qt::Key_F2,     Qt::Key_A,      Qt::Key_B,     Qt::Key_D,
                           Qt::Key_F,        Qt::Key_P,      Qt::Key_W,      Qt::Key_0,     Qt::Key_7,
                           Qt::Key_PageDown, Qt::Key_Minus,  Qt::Key_Period, Qt::Key_Colon};
constexpr std::array kModifiers{Qt::NoModifier, Qt::NoModifier, Qt::ShiftModifier, Qt::ControlModifier};
constexpr std::array kTexts{"",     "class:wall", "area>2", "area>",    "\"",  "0",
                            "-1e9", "12.5",       "=cmd",   "ä→\u202e", "nan", "North wall"};

QList<QWidget*> usableIn(QWidget* within)
{
    QList<QWidget*> usable;
    for (QWidget* widget : within->findChildren<QWidget*>()) {
        if (widget->isVisible() && widget->isEnabled() && widget->window() == within->window())
            usable.push_back(widget);
    }
    return usable;
}

QString nameOf(const QWidget& widget)
{
    return QStringLiteral("%1 %2").arg(QLatin1String(widget.metaObject()->className()), widget.objectName());
}

}  // namespace

RandomUser::RandomUser(ShownWindow& shown, QString folder, unsigned seed)
    : shown_(shown), folder_(std::move(folder)), random_(seed)
{
    // Queued: a timer does not fire again while it is being answered, and an answer may lead to one more dialog.
    connect(&dialogs_, &QTimer::timeout, this, &RandomUser::answerDialog, Qt::QueuedConnection);
    dialogs_.start(std::chrono::milliseconds(5));
}

int RandomUser::below(int count)
{
    // Not a distribution of the library: those differ from one to the next.
    return static_cast<int>(random_() % static_cast<unsigned>(count));
}

void RandomUser::note(const QString& deed)
{
    deeds_.push_back(deed);
    if (deeds_.size() > kDeedsKept)
        deeds_.pop_front();
}

QWidget* RandomUser::anyOf(const QList<QWidget*>& widgets)
{
    return widgets.isEmpty() ? nullptr : widgets[below(static_cast<int>(widgets.size()))];
}

QString RandomUser::anyFile()
{
    constexpr std::array kNames{"a.csv", "b.csv.gz", "c.pwscan", "d.ply",       "e.json",
                                "f.dxf", "g.png",    "h",        "no/where.csv"};
    return folder_ + "/" + QLatin1String(kNames[static_cast<std::size_t>(below(kNames.size()))]);
}

void RandomUser::act()
{
    patience_ = kDialogPatience;
    MainWindow& window = *shown_.parts.window;
    switch (below(10)) {
        case 0:
        case 1:
        case 2:
            triggerAction();
            break;
        case 3:
        case 4:
            useMouseInView();
            break;
        case 5:
            pressKey(QApplication::focusWidget() != nullptr ? QApplication::focusWidget() : &window);
            break;
        case 6:
            useTable(&window);
            break;
        case 7:
        case 8:
            useWidget(&window);
            break;
        default:
            arrange();
    }
    QTest::qWait(below(4) == 0 ? 40 : 1);
}

void RandomUser::triggerAction()
{
    const QList<QAction*> actions = shown_.parts.window->findChildren<QAction*>(QRegularExpression("^act"));
    QAction* action = actions[below(static_cast<int>(actions.size()))];
    if (!action->isEnabled() || action->objectName() == QLatin1String("actQuit"))
        return;
    note(action->objectName());
    action->trigger();
}

void RandomUser::useMouseInView()
{
    QWidget& view = shown_.parts.window->view();
    if (!view.isVisible() || view.size().isEmpty())
        return;
    const auto place = [&] { return QPoint(below(view.width()), below(view.height())); };
    const auto button =
        std::array{Qt::LeftButton, Qt::LeftButton, Qt::MiddleButton}[static_cast<std::size_t>(below(3))];
    const auto modifier = kModifiers[static_cast<std::size_t>(below(kModifiers.size()))];
    const QPoint from = place();
    switch (below(4)) {
        case 0:
            note(QStringLiteral("click in the view"));
            QTest::mouseClick(&view, button, modifier, from);
            break;
        case 1:
            note(QStringLiteral("double click in the view"));
            QTest::mouseDClick(&view, Qt::LeftButton, modifier, from);
            break;
        case 2: {
            note(QStringLiteral("wheel in the view"));
            QWheelEvent wheel(from, view.mapToGlobal(from), {}, {0, chance(50) ? 120 : -120}, Qt::NoButton, modifier,
                              Qt::NoScrollPhase, false);
            QApplication::sendEvent(&view, &wheel);
            break;
        }
        default:
            note(QStringLiteral("drag in the view"));
            QTest::mousePress(&view, button, modifier, from);
            for (int i = below(5); i >= 0; --i)
                QTest::mouseMove(&view, place());
            QTest::mouseRelease(&view, button, modifier, place());
    }
}

void RandomUser::pressKey(QWidget* target)
{
    const auto key = kKeys[static_cast<std::size_t>(below(kKeys.size()))];
    const auto modifier = kModifiers[static_cast<std::size_t>(below(kModifiers.size()))];
    note(QStringLiteral("key %1 in %2").arg(QKeySequence(key | modifier).toString(), nameOf(*target)));
    QTest::keyClick(target, key, modifier);
}

void RandomUser::useWidget(QWidget* within)
{
    QWidget* widget = anyOf(usableIn(within));
    if (widget == nullptr)
        return;
    note(nameOf(*widget));
    if (auto* button = qobject_cast<QAbstractButton*>(widget)) {
        button->click();
    } else if (auto* tabs = qobject_cast<QTabBar*>(widget); tabs != nullptr && tabs->count() > 0) {
        tabs->setCurrentIndex(below(tabs->count()));
    } else if (auto* choice = qobject_cast<QComboBox*>(widget); choice != nullptr && choice->count() > 0) {
        choice->setFocus();
        QTest::keyClick(choice, chance(50) ? Qt::Key_Down : Qt::Key_Up);
    } else if (auto* line = qobject_cast<QLineEdit*>(widget)) {
        line->setFocus();
        line->selectAll();
        line->insert(QString::fromUtf8(kTexts[static_cast<std::size_t>(below(kTexts.size()))]));
        QTest::keyClick(line, chance(70) ? Qt::Key_Return : Qt::Key_Escape);
    } else if (auto* number = qobject_cast<QAbstractSpinBox*>(widget)) {
        number->stepBy(below(21) - 10);
    } else if (auto* slider = qobject_cast<QSlider*>(widget)) {
        slider->setValue(slider->minimum() + below(slider->maximum() - slider->minimum() + 1));
    } else {
        const QPoint place(below(widget->width()), below(widget->height()));
        QTest::mouseClick(widget, Qt::LeftButton, {}, place);
    }
}

void RandomUser::useTable(QWidget* within)
{
    QList<QWidget*> tables;
    for (QWidget* widget : usableIn(within)) {
        if (qobject_cast<QTableView*>(widget) != nullptr)
            tables.push_back(widget);
    }
    auto* table = qobject_cast<QTableView*>(anyOf(tables));
    // A dock that was made small shows no cell.
    if (table == nullptr || table->viewport()->size().isEmpty())
        return;
    const QPoint place(below(table->viewport()->width()), below(table->viewport()->height()));
    note(QStringLiteral("cell of ") + nameOf(*table));
    switch (below(4)) {
        case 0:
            QTest::mouseDClick(table->viewport(), Qt::LeftButton, {}, place);
            break;
        case 1: {
            QContextMenuEvent menu(QContextMenuEvent::Mouse, place, table->viewport()->mapToGlobal(place));
            QApplication::sendEvent(table->viewport(), &menu);
            break;
        }
        default:
            QTest::mouseClick(table->viewport(), Qt::LeftButton,
                              kModifiers[static_cast<std::size_t>(below(kModifiers.size()))], place);
    }
}

void RandomUser::arrange()
{
    MainWindow& window = *shown_.parts.window;
    switch (below(4)) {
        case 0:
            note(QStringLiteral("resize"));
            window.resize(700 + below(900), 500 + below(500));
            break;
        case 1: {
            const auto docks = window.findChildren<QDockWidget*>();
            QDockWidget* dock = docks[below(static_cast<int>(docks.size()))];
            note(QStringLiteral("dock ") + dock->objectName());
            if (chance(50))
                dock->setFloating(!dock->isFloating());
            else
                dock->setVisible(!dock->isVisible());
            break;
        }
        case 2: {
            note(QStringLiteral("new scan"));
            const std::array<const char*, 4> addresses{"sim:corridor?seed=3&speed=0", "sim:office?seed=4&speed=5",
                                                       "sim:empty?seed=1&speed=0", "sim:hall?seed=2&speed=0.5"};
            shown_.controllers->scan.open(QLatin1String(addresses[static_cast<std::size_t>(below(4))]), true);
            break;
        }
        default:
            note(QStringLiteral("open a file"));
            shown_.controllers->scan.open(anyFile());
    }
}

void RandomUser::answerDialog()
{
    if (auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget())) {
        note(QStringLiteral("menu ") + menu->objectName());
        if (--patience_ > 0 && chance(70))
            QTest::keyClick(menu,
                            std::array{Qt::Key_Down, Qt::Key_Up, Qt::Key_Return}[static_cast<std::size_t>(below(3))]);
        else
            menu->close();
        return;
    }
    if (QWidget* popup = QApplication::activePopupWidget()) {
        popup->close();
        return;
    }
    QWidget* modal = QApplication::activeModalWidget();
    if (modal == nullptr)
        return;
    auto* dialog = qobject_cast<QDialog*>(modal);
    if (auto* files = qobject_cast<QFileDialog*>(modal)) {
        note(QStringLiteral("file dialog"));
        auto* name = files->findChild<QLineEdit*>();
        if (--patience_ > 0 && name != nullptr && chance(80)) {
            name->setText(anyFile());
            QMetaObject::invokeMethod(files, "accept");
        } else {
            files->reject();
        }
        return;
    }
    if (--patience_ > 0 && chance(90))
        useWidget(modal);
    else if (dialog != nullptr)
        dialog->reject();
    else
        modal->close();
}

}  // namespace planewright
