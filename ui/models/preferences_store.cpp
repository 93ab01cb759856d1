// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/preferences_store.h"

#include <array>
#include <span>

#include <QStringList>

namespace planewright {

namespace {

constexpr std::array<const char*, 3> kThemes{"system", "light", "dark"};
constexpr std::array<const char*, 3> kRenderers{"automatic", "gpu", "software"};
constexpr std::array<const char*, 3> kPalettes{"normal", "colour-blind", "high-contrast"};
constexpr std::array<const char*, 2> kDetails{"problems", "everything"};
const QString kShortcuts = QStringLiteral("shortcuts");

/// Reads what is there and has the right form; the rest stays as it is.
class Reader {
public:
    explicit Reader(const QSettings& settings) : settings_(settings) {}

    template <class Enum>
    void choice(const char* key, std::span<const char* const> words, Enum& value) const
    {
        const QString word = settings_.value(QLatin1String(key)).toString();
        for (std::size_t i = 0; i < words.size(); ++i) {
            if (word == QLatin1String(words[i]))
                value = static_cast<Enum>(i);
        }
    }
    void number(const char* key, double& value) const
    {
        bool isNumber = false;
        const double read = settings_.value(QLatin1String(key)).toString().toDouble(&isNumber);
        if (isNumber)
            value = read;
    }
    void number(const char* key, int& value) const
    {
        bool isNumber = false;
        const int read = settings_.value(QLatin1String(key)).toString().toInt(&isNumber);
        if (isNumber)
            value = read;
    }
    void toggle(const char* key, bool& value) const
    {
        const QString read = settings_.value(QLatin1String(key)).toString();
        if (read == QLatin1String("true") || read == QLatin1String("false"))
            value = read == QLatin1String("true");
    }
    void text(const char* key, std::string& value) const
    {
        if (settings_.contains(QLatin1String(key)))
            value = settings_.value(QLatin1String(key)).toString().toStdString();
    }

private:
    const QSettings& settings_;
};

template <class Value>
void write(QSettings& settings, const char* key, const Value& value, const Value& own)
{
    if (value == own)
        settings.remove(QLatin1String(key));
    else
        settings.setValue(QLatin1String(key), value);
}

template <class Enum>
void writeChoice(QSettings& settings, const char* key, std::span<const char* const> words, Enum value, Enum own)
{
    write(settings, key, QString::fromLatin1(words[static_cast<std::size_t>(value)]),
          QString::fromLatin1(words[static_cast<std::size_t>(own)]));
}

void writeShortcuts(QSettings& settings, const Preferences& preferences)
{
    settings.remove(kShortcuts);
    for (const auto& [action, keys] : preferences.shortcuts) {
        QStringList list;
        for (const std::string& key : keys)
            list << QString::fromStdString(key);
        settings.setValue(kShortcuts + '/' + QString::fromStdString(action), list);
    }
}

void readShortcuts(const QSettings& settings, Preferences& preferences)
{
    for (const QString& key : settings.allKeys()) {
        if (!key.startsWith(kShortcuts + '/'))
            continue;
        std::vector<std::string>& keys = preferences.shortcuts[key.mid(kShortcuts.size() + 1).toStdString()];
        for (const QString& sequence : settings.value(key).toStringList())
            keys.push_back(sequence.toStdString());
    }
}

}  // namespace

Preferences loadPreferences(const QSettings& settings)
{
    Preferences loaded;
    const Reader read(settings);
    read.choice("general/theme", kThemes, loaded.theme);
    read.toggle("general/millimetres", loaded.lengths.millimetres);
    read.number("general/decimals", loaded.lengths.decimals);
    read.choice("view/renderer", kRenderers, loaded.renderer);
    read.number("view/point-budget", loaded.pointBudget);
    read.toggle("view/anti-aliasing", loaded.antiAliasing);
    read.choice("view/palette", kPalettes, loaded.palette);
    read.text("scan/record-folder", loaded.recordFolder);
    read.number("scan/free-space-floor", loaded.freeSpaceFloor);
    read.text("scan/preset", loaded.preset);
    read.toggle("scan/alarm-sound", loaded.alarmSound);
    read.choice("advanced/log", kDetails, loaded.logDetail);
    read.toggle("advanced/safe-mode-next-start", loaded.safeModeNextStart);
    readShortcuts(settings, loaded);
    return validated(std::move(loaded));
}

void savePreferences(const Preferences& preferences, QSettings& settings)
{
    const Preferences own;
    writeChoice(settings, "general/theme", kThemes, preferences.theme, own.theme);
    write(settings, "general/millimetres", preferences.lengths.millimetres, own.lengths.millimetres);
    write(settings, "general/decimals", preferences.lengths.decimals, own.lengths.decimals);
    writeChoice(settings, "view/renderer", kRenderers, preferences.renderer, own.renderer);
    write(settings, "view/point-budget", preferences.pointBudget, own.pointBudget);
    write(settings, "view/anti-aliasing", preferences.antiAliasing, own.antiAliasing);
    writeChoice(settings, "view/palette", kPalettes, preferences.palette, own.palette);
    write(settings, "scan/record-folder", QString::fromStdString(preferences.recordFolder),
          QString::fromStdString(own.recordFolder));
    write(settings, "scan/free-space-floor", preferences.freeSpaceFloor, own.freeSpaceFloor);
    write(settings, "scan/preset", QString::fromStdString(preferences.preset), QString::fromStdString(own.preset));
    write(settings, "scan/alarm-sound", preferences.alarmSound, own.alarmSound);
    writeChoice(settings, "advanced/log", kDetails, preferences.logDetail, own.logDetail);
    write(settings, "advanced/safe-mode-next-start", preferences.safeModeNextStart, own.safeModeNextStart);
    writeShortcuts(settings, preferences);
}

}  // namespace planewright
