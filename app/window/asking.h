// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>

#include <QDialog>
#include <QString>

namespace planewright {

/// Opens a dialog over its window and returns at once; it is deleted when it is left. Where one of its name is open
/// already, that stays and the new one goes.
void ask(QDialog* dialog);

/// The same for one beside which the window can be used; false where the new one is gone.
bool askBeside(QDialog* dialog);

/// The dialog that has to be left before anything else of the window can be used; null without one.
QWidget* openDialog();

/// Performs something, and leaves every dialog and menu that it would wait for, as with Esc. Gives the title of the
/// last of these; empty where it waited for none.
QString performUnasked(const std::function<void()>& deed);

}  // namespace planewright
