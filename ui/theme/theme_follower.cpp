// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/theme/theme_follower.h"

#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusPendingCallWatcher>
#include <QDBusPendingReply>
#include <QGuiApplication>

#include "ui/theme/motion.h"
#include "ui/theme/theme.h"

namespace planewright {

namespace {

const QString kService = QStringLiteral("org.freedesktop.portal.Desktop");
const QString kPath = QStringLiteral("/org/freedesktop/portal/desktop");
const QString kInterface = QStringLiteral("org.freedesktop.portal.Settings");
const QString kGroup = QStringLiteral("org.freedesktop.appearance");
const QString kKey = QStringLiteral("color-scheme");
const QString kMotionKey = QStringLiteral("reduced-motion");

/// The number in an answer; Read wraps it in two variants.
unsigned int numberIn(QVariant value)
{
    while (value.canConvert<QDBusVariant>())
        value = value.value<QDBusVariant>().variant();
    return value.toUInt();
}

}  // namespace

ThemeFollower::ThemeFollower(QObject* parent) : QObject(parent), atStart_(themeOf(QGuiApplication::palette()))
{
    QDBusConnection::sessionBus().connect(kService, kPath, kInterface, QStringLiteral("SettingChanged"), this,
                                          SLOT(takeSetting(QString, QString, QDBusVariant)));
}

void ThemeFollower::setChoice(ThemeChoice choice)
{
    const Theme before = theme();
    choice_ = choice;
    if (theme() != before)
        emit themeChanged(theme());
}

Theme ThemeFollower::theme() const
{
    switch (choice_) {
        case ThemeChoice::Light:
            return Theme::Light;
        case ThemeChoice::Dark:
            return Theme::Dark;
        case ThemeChoice::System:
            break;
    }
    return desktop_.value_or(atStart_);
}

void ThemeFollower::askDesktop()
{
    ask(kKey);
    ask(kMotionKey);
}

void ThemeFollower::ask(const QString& key)
{
    const QDBusConnection bus = QDBusConnection::sessionBus();
    if (!bus.isConnected())
        return;
    QDBusMessage question = QDBusMessage::createMethodCall(kService, kPath, kInterface, QStringLiteral("Read"));
    question.setArguments({kGroup, key});
    auto* watcher = new QDBusPendingCallWatcher(bus.asyncCall(question), this);
    connect(watcher, &QDBusPendingCallWatcher::finished, this, [this, watcher, key] {
        const QDBusPendingReply<QDBusVariant> reply = *watcher;
        if (reply.isValid())
            takeSetting(kGroup, key, reply.value());
        watcher->deleteLater();
    });
}

std::optional<Theme> ThemeFollower::preferred(unsigned int colorScheme)
{
    constexpr unsigned int kDark = 1;
    constexpr unsigned int kLight = 2;
    if (colorScheme == kDark)
        return Theme::Dark;
    return colorScheme == kLight ? std::optional(Theme::Light) : std::nullopt;
}

void ThemeFollower::takeSetting(const QString& group, const QString& key, const QDBusVariant& value)
{
    if (group == kGroup && key == kKey)
        setDesktop(preferred(numberIn(value.variant())));
    if (group == kGroup && key == kMotionKey)
        setMotionReduced(numberIn(value.variant()) == 1);
}

void ThemeFollower::setDesktop(std::optional<Theme> theme)
{
    const Theme before = this->theme();
    desktop_ = theme;
    if (this->theme() != before)
        emit themeChanged(this->theme());
}

}  // namespace planewright
