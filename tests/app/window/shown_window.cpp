// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/app/window/shown_window.h"

#include <QApplication>
#include <QtTest>

#include "app/window/waiting.h"

namespace planewright {

ShownWindow::ShownWindow(const QString& settingsFile) : parts(ParameterOptions{}, settingsFile)
{
    parts.preferences.theme = ThemeChoice::Light;
}

ShownWindow::~ShownWindow()
{
    parts.session.close();
}

Result<std::unique_ptr<ShownWindow>> ShownWindow::open(const QString& settingsFile)
{
    std::unique_ptr<ShownWindow> shown(new ShownWindow(settingsFile));
    MainWindow& window = *shown->parts.window;
    PresenterSettings presenter;
    presenter.image = QGuiApplication::platformName() == QLatin1String("offscreen");
    if (auto presented = window.view().present(presenter); !presented)
        return tl::unexpected(std::move(presented.error()));
    shown->controllers = std::make_unique<WindowControllers>(shown->parts, shown->follower);
    window.show();
    window.activateWindow();
    if (!QTest::qWaitForWindowActive(&window))
        return tl::unexpected(Error{ErrorCode::Internal, "the window does not become active"});
    return shown;
}

bool ShownWindow::scanCorridor()
{
    controllers->scan.open(QStringLiteral("sim:corridor?seed=7&speed=0"), true);
    return waitUntil([this] { return parts.session.state() == SessionState::Review; }, kPatience) &&
           waitForRest(parts, kPatience) && parts.shown->planes.size() > 5;
}

void useFixedLook()
{
    QLocale::setDefault(QLocale::c());
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(12);
    QApplication::setFont(font);
}

}  // namespace planewright
