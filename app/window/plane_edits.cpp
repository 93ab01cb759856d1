// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/plane_edits.h"

#include <algorithm>

#include "app/window/map_words.h"
#include "app/window/timeline_words.h"
#include "core/types/plane_words.h"
#include "ui/dialogs/history_dialog.h"
#include "ui/panels/filtered_table.h"

namespace planewright {

PlaneEdits::PlaneEdits(WindowParts& parts) : QObject(&parts), parts_(parts)
{
    connectActions();
    connectTable();
    connect(&parts_.selection, &MapSelection::changed, this, &PlaneEdits::refresh);
    connect(&parts_, &WindowParts::mapShown, this, &PlaneEdits::refresh);
    connect(&parts_.undo, &UndoLine::changed, this, &PlaneEdits::refresh);
    refresh();
}

std::vector<PlaneId> PlaneEdits::selected() const
{
    return {parts_.selection.planes().begin(), parts_.selection.planes().end()};
}

std::vector<PlaneId> PlaneEdits::planesThat(bool hidden) const
{
    std::vector<PlaneId> planes;
    for (const ShownPlane& plane : parts_.shown->planes) {
        if (plane.hidden == hidden)
            planes.push_back(plane.plane->id);
    }
    return planes;
}

void PlaneEdits::connectActions()
{
    WindowActions& actions = parts_.window->actions();
    const auto on = [&](const char* name, auto&& call) {
        connect(actions[QLatin1String(name)], &QAction::triggered, this, call);
    };
    on("actRename", [this] { parts_.planesPanel->beginRename(); });
    on("actHide", [this] { edit(Edit::Kind::Hide, selected()); });
    on("actIsolate", [this] {
        std::vector<PlaneId> others = planesThat(false);
        std::erase_if(others, [this](PlaneId id) { return parts_.selection.planes().contains(id); });
        edit(Edit::Kind::Hide, others);
    });
    on("actShowAll", [this] { edit(Edit::Kind::Hide, planesThat(true), {}, false); });
    on("actMerge", [this] { edit(Edit::Kind::Merge, selected()); });
    on("actSplit", [this] { edit(Edit::Kind::Split, selected()); });
    on("actDelete", [this] { edit(Edit::Kind::Delete, selected()); });
    on("actLock", [this] {
        const auto& planes = parts_.shown->planes;
        const bool anyFree = std::any_of(planes.begin(), planes.end(), [this](const ShownPlane& plane) {
            return parts_.selection.planes().contains(plane.plane->id) && !plane.locked;
        });
        edit(Edit::Kind::Lock, selected(), {}, anyFree);
    });
    on("actUndo", [this] { take(parts_.undo.undo()); });
    on("actRedo", [this] { take(parts_.undo.redo()); });
    on("actHistory", [this] { showHistory(); });
    on("actCopy", [this] { parts_.planesPanel->table()->copyAction()->trigger(); });

    QMenu* classes = actions.submenu(QStringLiteral("class"));
    for (const std::string_view name : kPlaneClasses) {
        const QString text = QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
        QAction* action = classes->addAction(text);
        action->setObjectName(QStringLiteral("actClass_") + text);
        connect(action, &QAction::triggered, this, [this, text] { edit(Edit::Kind::Classify, selected(), text); });
    }
    QAction* automatic = classes->addAction(tr("By normal and height"));
    automatic->setObjectName(QStringLiteral("actClass_auto"));
    connect(automatic, &QAction::triggered, this, [this] { edit(Edit::Kind::Classify, selected()); });

    QList<QAction*> context;
    for (const char* name : {"actViewFitSelection", "actIsolate", "actHide", "actShowAll", "", "actRename", "actLock",
                             "actMerge", "actSplit", "actDelete"})
        context.push_back(*name == '\0' ? nullptr : actions[QLatin1String(name)]);
    context.insert(6, classes->menuAction());
    parts_.planesPanel->setContextActions(context);
}

void PlaneEdits::connectTable()
{
    connect(&parts_.planes, &PlanesModel::renameRequested, this,
            [this](PlaneId plane, const QString& name) { edit(Edit::Kind::Rename, {plane}, name); });
    connect(&parts_.planes, &PlanesModel::classRequested, this,
            [this](PlaneId plane, const QString& name) { edit(Edit::Kind::Classify, {plane}, name); });
    connect(&parts_.planes, &PlanesModel::hideRequested, this,
            [this](PlaneId plane, bool hidden) { edit(Edit::Kind::Hide, {plane}, {}, hidden); });
    connect(&parts_.planes, &PlanesModel::lockRequested, this,
            [this](PlaneId plane, bool locked) { edit(Edit::Kind::Lock, {plane}, {}, locked); });
}

void PlaneEdits::edit(Edit::Kind kind, std::vector<PlaneId> planes, const QString& text, bool on)
{
    if (planes.empty())
        return;
    take(parts_.undo.add({kind, std::move(planes), text.toStdString(), on}));
}

void PlaneEdits::take(const Result<void>& result)
{
    if (!result)
        parts_.problem(tr("edits"), result.error());
    parts_.showMap();
    refresh();
}

void PlaneEdits::showHistory()
{
    HistoryDialog dialog(parts_.window.get());
    const auto show = [this, &dialog] {
        std::vector<HistoryDialog::Line> lines;
        for (const UndoLine::Entry& entry : parts_.undo.entries())
            lines.push_back({entry.edit      ? timelineLineOf(*entry.edit)
                             : entry.mapEdit ? lineOf(*entry.mapEdit)
                                             : tr("Extracted once more"),
                             entry.isUndone});
        dialog.setLines(lines, parts_.undo.canUndo(), parts_.undo.canRedo());
    };
    connect(&parts_.undo, &UndoLine::changed, &dialog, show);
    connect(&dialog, &HistoryDialog::undoRequested, this, [this] { take(parts_.undo.undo()); });
    connect(&dialog, &HistoryDialog::redoRequested, this, [this] { take(parts_.undo.redo()); });
    show();
    dialog.exec();
}

void PlaneEdits::refresh()
{
    WindowActions& actions = parts_.window->actions();
    const std::size_t count = parts_.selection.planes().size();
    for (const char* name : {"actHide", "actIsolate", "actLock", "actDelete", "actViewFitSelection"})
        actions[QLatin1String(name)]->setEnabled(
            count > 0 ||
            (QLatin1String(name) == QLatin1String("actViewFitSelection") && !parts_.selection.segments().empty()));
    actions[QStringLiteral("actRename")]->setEnabled(count == 1);
    actions[QStringLiteral("actSplit")]->setEnabled(count == 1);
    actions[QStringLiteral("actMerge")]->setEnabled(count >= 2);
    actions[QStringLiteral("actShowAll")]->setEnabled(!planesThat(true).empty());
    actions.submenu(QStringLiteral("class"))->setEnabled(count > 0);
    actions[QStringLiteral("actUndo")]->setEnabled(parts_.undo.canUndo());
    actions[QStringLiteral("actRedo")]->setEnabled(parts_.undo.canRedo());
}

}  // namespace planewright
