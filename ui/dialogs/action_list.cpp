// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/dialogs/action_list.h"

#include <QAction>
#include <QMenu>
#include <QSet>

namespace planewright {

namespace {

QString plain(QString text)
{
    text.replace(QStringLiteral("&&"), QStringLiteral("\x01"));
    text.remove('&');
    text = text.section('\t', 0, 0);  // behind it stand keys
    return text.replace(QStringLiteral("\x01"), QStringLiteral("&"));
}

QString menuOf(const QAction* action)
{
    for (const QObject* holder : action->associatedObjects()) {
        if (const auto* menu = qobject_cast<const QMenu*>(holder))
            return plain(menu->title());
    }
    return {};
}

}  // namespace

std::vector<ListedAction> listedActions(const QList<QAction*>& actions)
{
    std::vector<ListedAction> listed;
    QSet<QString> seen;
    for (QAction* action : actions) {
        if (action->isSeparator() || action->text().isEmpty() || action->objectName().isEmpty() ||
            seen.contains(action->objectName()))
            continue;
        seen.insert(action->objectName());
        listed.push_back({action, menuOf(action), plain(action->text()),
                          QKeySequence::listToString(action->shortcuts(), QKeySequence::NativeText)});
    }
    return listed;
}

int fuzzyFit(const QString& query, const QString& text)
{
    constexpr int kWordStart = 8;
    constexpr int kSideBySide = 10;
    constexpr int kLetter = 1;
    int fit = 0;
    qsizetype at = 0;
    qsizetype last = -2;
    for (const QChar letter : query) {
        if (letter.isSpace())
            continue;
        // The next beginning of a word is worth more than a letter before it, unless that goes on where it was.
        const auto isStart = [&](qsizetype i) { return i == 0 || !text[i - 1].isLetterOrNumber(); };
        const auto same = [&](qsizetype i) { return text[i].toCaseFolded() == letter.toCaseFolded(); };
        qsizetype found = at < text.size() && last == at - 1 && same(at) ? at : -1;
        for (qsizetype i = at; found < 0 && i < text.size(); ++i) {
            if (same(i) && isStart(i))
                found = i;
        }
        for (qsizetype i = at; found < 0 && i < text.size(); ++i) {
            if (same(i))
                found = i;
        }
        if (found < 0)
            return -1;
        fit += kLetter + (isStart(found) ? kWordStart : 0) + (found == last + 1 ? kSideBySide : 0);
        last = found;
        at = found + 1;
    }
    return fit;
}

}  // namespace planewright
