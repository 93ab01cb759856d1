// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/timeline_words.h"

#include <algorithm>

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "core/pipeline/step_replay.h"
#include "core/types/plane_words.h"

namespace planewright {

namespace {

QString timelineWords(const char* text)
{
    return QCoreApplication::translate("Timeline", text);
}

/// What an event tells, in one line: plain text, or JSON with a message. Files of others hold whatever they like.
QString wordsIn(const std::string& payload)
{
    constexpr qsizetype kLongest = 200;
    QString text = QString::fromStdString(payload);
    const QJsonDocument json = QJsonDocument::fromJson(QByteArray::fromStdString(payload));
    if (json.isObject()) {
        const QString message = json[QStringLiteral("message")].toString();
        text = message.isEmpty() && json.object().isEmpty() ? QString() : message.isEmpty() ? text : message;
    }
    text = text.simplified();
    return text.size() > kLongest ? text.left(kLongest - 1) + QStringLiteral("…") : text;
}

}  // namespace

QString timelineLineOf(const Edit& edit)
{
    QStringList planes;
    for (const PlaneId plane : edit.planes)
        planes.push_back(QString::fromStdString(planeLabel(plane)));
    const QString text = QString::fromStdString(edit.text);
    const QString names = planes.join(QStringLiteral(", "));
    switch (edit.kind) {
        case Edit::Kind::Rename:
            return text.isEmpty() ? timelineWords("%1: name taken away").arg(names)
                                  : timelineWords("%1: named %2").arg(names, text);
        case Edit::Kind::Classify:
            return text.isEmpty() ? timelineWords("%1: class by normal and height").arg(names)
                                  : timelineWords("%1: class %2").arg(names, text);
        case Edit::Kind::Hide:
            return edit.on ? timelineWords("%1: hidden").arg(names) : timelineWords("%1: shown again").arg(names);
        case Edit::Kind::Delete:
            return timelineWords("%1: deleted").arg(names);
        case Edit::Kind::Merge:
            return timelineWords("%1: merged").arg(names);
        case Edit::Kind::Split:
            return timelineWords("%1: split").arg(names);
        case Edit::Kind::Lock:
            break;
    }
    return edit.on ? timelineWords("%1: locked").arg(names) : timelineWords("%1: unlocked").arg(names);
}

QStringList troublesOf(const ExtractedStep& step, const ExtractedStep* before)
{
    QStringList troubles;
    if (!step.measured)
        return troubles;
    const int expected = before != nullptr && before->measured ? before->measured->step + 1 : 0;
    const int missing = step.measured->step - expected;
    if (missing == 1)
        troubles.push_back(timelineWords("step %1 was lost").arg(expected + 1));
    else if (missing > 1)
        troubles.push_back(timelineWords("steps %1 to %2 were lost").arg(expected + 1).arg(step.measured->step));
    if (step.measured->angleSuspect)
        troubles.push_back(timelineWords("its pitch may be wrong: no planes are made of it"));
    if (step.measured->timeSuspect)
        troubles.push_back(timelineWords("its time may be wrong"));
    if (step.measured->retaken)
        troubles.push_back(timelineWords("taken again after a fault"));
    return troubles;
}

std::vector<std::pair<int, QString>> troublesIn(std::span<const ScanEvent> events)
{
    std::vector<std::pair<int, QString>> troubles;
    for (const ScanEvent& event : events) {
        const bool isFault = event.kind == ScanEvent::Kind::Fault;
        if (!event.step || (!isFault && event.kind != ScanEvent::Kind::Recovered))
            continue;
        const QString told = wordsIn(event.payload);
        const QString line = isFault ? timelineWords("a fault") : timelineWords("went on after a fault");
        troubles.emplace_back(*event.step, told.isEmpty() ? line : isFault ? told : line + QStringLiteral(": ") + told);
    }
    return troubles;
}

int placeOfFault(const Playhead& playhead, int step, bool isOver)
{
    const Playhead::History& history = playhead.history();
    if (history.empty())
        return -1;
    if (step == kLastPass)
        return history.back()->report.step == kLastPass ? static_cast<int>(history.size()) - 1 : -1;
    const bool isReached = std::any_of(history.begin(), history.end(),
                                       [step](const auto& snapshot) { return snapshot->report.step >= step; });
    return isReached || isOver ? std::max(playhead.placeOf(step), 0) : -1;
}

std::set<int> bookmarkedStepsOf(const std::string& text)
{
    std::set<int> steps;
    const QJsonDocument document = QJsonDocument::fromJson(QByteArray::fromStdString(text));
    for (const QJsonValue step : document.array()) {
        if (step.isDouble() && step.toInt(kLastPass) >= kLastPass)
            steps.insert(step.toInt(kLastPass));
    }
    return steps;
}

std::string textOfBookmarks(const std::set<int>& steps)
{
    QJsonArray array;
    for (const int step : steps)
        array.append(step);
    return QJsonDocument(array).toJson(QJsonDocument::Compact).toStdString();
}

}  // namespace planewright
