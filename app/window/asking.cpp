// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/asking.h"

#include <QApplication>
#include <QTimer>

namespace planewright {

namespace {

constexpr int kLookForQuestions = 20;  // [ms]

/// False where one of its name is open already: then the new one is gone.
bool isOnly(QDialog* dialog)
{
    for (const QWidget* other : QApplication::topLevelWidgets()) {
        if (other != dialog && other->isVisible() && other->objectName() == dialog->objectName()) {
            delete dialog;
            return false;
        }
    }
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    return true;
}

}  // namespace

void ask(QDialog* dialog)
{
    if (isOnly(dialog))
        dialog->open();
}

bool askBeside(QDialog* dialog)
{
    if (!isOnly(dialog))
        return false;
    dialog->show();
    return true;
}

QWidget* openDialog()
{
    return QApplication::activeModalWidget();
}

QString performUnasked(const std::function<void()>& deed)
{
    QString asked;
    const QWidget* before = openDialog();
    QTimer look;
    // It only comes to this while the deed has an event loop of its own.
    QObject::connect(&look, &QTimer::timeout, [&] {
        if (QWidget* menu = QApplication::activePopupWidget()) {
            asked = QObject::tr("a menu");
            menu->close();
            return;
        }
        QWidget* modal = openDialog();
        if (modal == nullptr || modal == before)
            return;
        asked = modal->windowTitle();
        if (auto* dialog = qobject_cast<QDialog*>(modal))
            dialog->reject();
        else
            modal->close();
    });
    look.start(kLookForQuestions);
    deed();
    return asked;
}

}  // namespace planewright
