// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/device_settings.h"

#include <array>
#include <cmath>

#include <QStringList>

namespace planewright {

namespace {

struct Text {
    const char* key;
    std::string DeviceSetup::*value;
};
constexpr std::array<Text, 3> kTexts{{{"devices/laser", &DeviceSetup::laser},
                                      {"devices/tilt-unit", &DeviceSetup::tiltUnit},
                                      {"devices/dialogues", &DeviceSetup::dialogueFolder}}};

struct Number {
    const char* key;
    double DeviceSetup::*value;
};
constexpr std::array<Number, 11> kNumbers{{{"devices/first-tilt", &DeviceSetup::firstTilt},
                                           {"devices/last-tilt", &DeviceSetup::lastTilt},
                                           {"devices/tilt-step", &DeviceSetup::tiltStep},
                                           {"devices/first-bearing", &DeviceSetup::firstBearing},
                                           {"devices/last-bearing", &DeviceSetup::lastBearing},
                                           {"devices/settle", &DeviceSetup::settle},
                                           {"devices/travel-speed", &DeviceSetup::travelSpeed},
                                           {"devices/lowest", &DeviceSetup::lowest},
                                           {"devices/highest", &DeviceSetup::highest},
                                           {"devices/fastest", &DeviceSetup::fastest},
                                           {"devices/axis-offset", &DeviceSetup::axisOffset}}};

const QString kStepAndStare = QStringLiteral("devices/step-and-stare");
const QString kCluster = QStringLiteral("devices/joined-steps");
const QString kKnownLasers = QStringLiteral("devices/known-lasers");

}  // namespace

DeviceSetup loadDeviceSetup(const QSettings& settings)
{
    DeviceSetup setup;
    for (const Text& text : kTexts)
        setup.*text.value = settings.value(QLatin1String(text.key)).toString().toStdString();
    for (const Number& number : kNumbers) {
        bool isNumber = false;
        const double value = settings.value(QLatin1String(number.key)).toString().toDouble(&isNumber);
        if (isNumber && std::isfinite(value))
            setup.*number.value = value;
    }
    bool isNumber = false;
    if (const int cluster = settings.value(kCluster).toString().toInt(&isNumber); isNumber)
        setup.cluster = cluster;
    setup.stepAndStare = settings.value(kStepAndStare).toString() == QLatin1String("true");
    return setup;
}

void saveDeviceSetup(const DeviceSetup& setup, QSettings& settings)
{
    for (const Text& text : kTexts)
        settings.setValue(QLatin1String(text.key), QString::fromStdString(setup.*text.value));
    for (const Number& number : kNumbers)
        settings.setValue(QLatin1String(number.key), QString::number(setup.*number.value, 'g', 17));
    settings.setValue(kCluster, QString::number(setup.cluster));
    settings.setValue(kStepAndStare, setup.stepAndStare ? QStringLiteral("true") : QStringLiteral("false"));
}

KnownLasers loadKnownLasers(const QSettings& settings)
{
    KnownLasers known;
    for (const QString& entry : settings.value(kKnownLasers).toStringList()) {
        const qsizetype split = entry.indexOf(QLatin1Char('='));
        if (split > 0 && split + 1 < entry.size())
            known[entry.left(split).toStdString()] = entry.mid(split + 1).toStdString();
    }
    return known;
}

void saveKnownLasers(const KnownLasers& known, QSettings& settings)
{
    QStringList entries;
    for (const auto& [port, serial] : known)
        entries += QString::fromStdString(port + "=" + serial);
    settings.setValue(kKnownLasers, entries);
}

}  // namespace planewright
