// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/script_runner.h"

#include <algorithm>

#include <QAction>
#include <QCoreApplication>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QMetaProperty>

#include "app/window/history_control.h"
#include "app/window/screenshot.h"
#include "app/window/view_text.h"
#include "app/window/waiting.h"

namespace planewright {

namespace {

constexpr std::chrono::seconds kSettleTime{60};
constexpr double kDefaultTimeout = 30.0;  // [s]

tl::unexpected<Error> wrong(const QString& what)
{
    return fail(ErrorCode::GateFailed, what.toStdString());
}

QString text(const QJsonObject& line, const char* key)
{
    return line.value(QLatin1String(key)).toString();
}

QString shown(const QJsonValue& value)
{
    const QByteArray array = QJsonDocument(QJsonArray{value}).toJson(QJsonDocument::Compact);
    return QString::fromUtf8(array.mid(1, array.size() - 2));
}

}  // namespace

Result<void> ScriptRunner::run(const QString& file)
{
    QFile script(file);
    if (!script.open(QIODevice::ReadOnly))
        return fail(ErrorCode::Unreadable,
                    file.toStdString() + ": cannot be read: " + script.errorString().toStdString());
    // All at once: a pipe says that it is at its end before anything has come.
    const QList<QByteArray> lines = script.readAll().split('\n');
    for (qsizetype number = 1; number <= lines.size() && !quits_; ++number) {
        const QByteArray line = lines[number - 1].trimmed();
        if (line.isEmpty())
            continue;
        const auto where = [&](const std::string& message) {
            return file.toStdString() + ":" + std::to_string(number) + ": " + message;
        };
        QJsonParseError error;
        const QJsonDocument document = QJsonDocument::fromJson(line, &error);
        if (!document.isObject())
            return fail(ErrorCode::GateFailed,
                        where("is no JSON object: " + error.errorString().toStdString() +
                              "; a line is like {\"do\":\"open\",\"address\":\"sim:corridor?seed=7\"}"));
        if (const auto done = perform(document.object()); !done)
            return fail(ErrorCode::GateFailed, where(done.error().message));
    }
    return {};
}

Result<void> ScriptRunner::perform(const QJsonObject& line)
{
    const QString what = text(line, "do");
    if (what == QLatin1String("open"))
        return open(line);
    if (what == QLatin1String("goto"))
        return goTo(line);
    if (what == QLatin1String("select"))
        return select(line);
    if (what == QLatin1String("action"))
        return trigger(line);
    if (what == QLatin1String("set"))
        return set(line);
    if (what == QLatin1String("wait"))
        return wait(line);
    if (what == QLatin1String("screenshot"))
        return screenshot(line);
    if (what == QLatin1String("expect"))
        return expect(line);
    if (what == QLatin1String("quit")) {
        quits_ = true;
        return {};
    }
    return wrong(QStringLiteral("\"do\" is %1; known are open, goto, select, action, set, wait, screenshot, expect and "
                                "quit")
                     .arg(shown(line.value(QLatin1String("do")))));
}

void ScriptRunner::settle()
{
    // What an action leads to comes by events as well: layouts above all.
    QCoreApplication::processEvents();
    waitUntil([this] { return !parts_.isAtWork() && isShown(parts_); }, kSettleTime);
}

Result<void> ScriptRunner::open(const QJsonObject& line)
{
    const QString file = text(line, "file");
    const QString address = text(line, "address");
    if (file.isEmpty() == address.isEmpty())
        return wrong(QStringLiteral("open needs one of \"file\" and \"address\""));
    scan_.open(file.isEmpty() ? address : file, true);
    waitUntil([&] { return parts_.fault || parts_.session.state() != SessionState::Connecting; }, kSettleTime);
    if (parts_.fault)
        return tl::unexpected{*parts_.fault};
    if (parts_.session.state() == SessionState::Empty)
        return wrong(QStringLiteral("%1 cannot be opened").arg(file.isEmpty() ? address : file));
    return {};
}

Result<void> ScriptRunner::goTo(const QJsonObject& line)
{
    const QJsonValue step = line.value(QLatin1String("step"));
    if (!step.isDouble())
        return wrong(QStringLiteral("goto needs a number as \"step\""));
    if (auto gone = lookAtStep(parts_, step.toInt()); !gone)
        return gone;
    waitUntil([&] { return parts_.session.map()->step <= step.toInt(); }, kSettleTime);
    settle();
    return {};
}

Result<void> ScriptRunner::select(const QJsonObject& line)
{
    settle();
    if (const QJsonValue plane = line.value(QLatin1String("plane")); plane.isDouble()) {
        const PlaneId id = plane.toInt();
        const auto& planes = parts_.shown->planes;
        if (std::none_of(planes.begin(), planes.end(), [id](const ShownPlane& p) { return p.plane->id == id; }))
            return wrong(QStringLiteral("there is no plane %1 at this step").arg(id));
        parts_.selection.select({id});
        return {};
    }
    if (const auto id = segmentIdOf(text(line, "segment"))) {
        const auto snapshot = parts_.shown->snapshot;
        const std::size_t slice = snapshot ? snapshot->segments.find(id->step) : 0;
        if (snapshot && slice < snapshot->segments.slices() &&
            static_cast<std::size_t>(id->index) < snapshot->segments.slice(slice).size()) {
            parts_.selection.select({}, {*id});
            return {};
        }
    }
    return wrong(
        QStringLiteral("select needs the id of a \"plane\", or a \"segment\" as \"step.index\", that is there"));
}

Result<void> ScriptRunner::trigger(const QJsonObject& line)
{
    const QString name = text(line, "name");
    auto* action = parts_.window->findChild<QAction*>(name);
    if (action == nullptr)
        return wrong(QStringLiteral("there is no action %1; the list of shortcuts names them").arg(name));
    if (!action->isEnabled())
        return wrong(QStringLiteral("%1 is not possible now").arg(name));
    action->trigger();
    settle();
    return {};
}

Result<QObject*> ScriptRunner::objectOf(const QJsonObject& line)
{
    const QString name = text(line, "object");
    QObject* object =
        parts_.window->objectName() == name ? parts_.window.get() : parts_.window->findChild<QObject*>(name);
    if (object == nullptr)
        return wrong(QStringLiteral("there is no object %1").arg(name));
    const QString property = text(line, "property");
    if (object->metaObject()->indexOfProperty(property.toUtf8().constData()) < 0)
        return wrong(QStringLiteral("%1 has no property %2").arg(name, property));
    return object;
}

Result<void> ScriptRunner::set(const QJsonObject& line)
{
    const auto object = objectOf(line);
    if (!object)
        return tl::unexpected{object.error()};
    if (!(*object)->setProperty(text(line, "property").toUtf8().constData(),
                                line.value(QLatin1String("value")).toVariant()))
        return wrong(QStringLiteral("%1 of %2 cannot be %3")
                         .arg(text(line, "property"), text(line, "object"), shown(line.value(QLatin1String("value")))));
    settle();
    return {};
}

Result<void> ScriptRunner::wait(const QJsonObject& line)
{
    const std::string wanted = text(line, "state").toStdString();
    const auto known = std::find(kSessionStateNames.begin(), kSessionStateNames.end(), wanted);
    if (known == kSessionStateNames.end())
        return wrong(QStringLiteral("there is no state %1").arg(QString::fromStdString(wanted)));
    const auto state = static_cast<SessionState>(known - kSessionStateNames.begin());
    const double timeout = line.value(QLatin1String("timeout")).toDouble(kDefaultTimeout);
    const bool reached = waitUntil([&] { return parts_.session.state() == state; },
                                   std::chrono::milliseconds(static_cast<long>(1000.0 * timeout)));
    if (!reached)
        return wrong(QStringLiteral("the session is %1 and not %2 after %3 s")
                         .arg(QString::fromUtf8(name(parts_.session.state()).data()), QString::fromStdString(wanted))
                         .arg(timeout));
    settle();
    return {};
}

Result<void> ScriptRunner::screenshot(const QJsonObject& line)
{
    settle();
    QSize size;
    if (const QString given = text(line, "size"); !given.isEmpty()) {
        const auto read = readPictureSize(given.toStdString());
        if (!read)
            return wrong(QStringLiteral("\"size\" is like \"1280x800\", each side from %1 to %2")
                             .arg(kFewestPixels)
                             .arg(kMostPixels));
        size = {read->width, read->height};
    }
    return savePicture(takePicture(parts_, size, line.value(QLatin1String("window")).toBool()), text(line, "file"));
}

Result<void> ScriptRunner::expect(const QJsonObject& line)
{
    settle();
    const auto object = objectOf(line);
    if (!object)
        return tl::unexpected{object.error()};
    const QJsonValue value = QJsonValue::fromVariant((*object)->property(text(line, "property").toUtf8().constData()));
    const auto holds = [&](const char* key, auto compare) {
        const QJsonValue limit = line.value(QLatin1String(key));
        return limit.isUndefined() || compare(limit);
    };
    const bool good =
        holds("equals", [&](const QJsonValue& v) { return v == value; }) &&
        holds("atLeast", [&](const QJsonValue& v) { return value.isDouble() && value.toDouble() >= v.toDouble(); }) &&
        holds("atMost", [&](const QJsonValue& v) { return value.isDouble() && value.toDouble() <= v.toDouble(); });
    if (!good)
        return wrong(QStringLiteral("%1 of %2 is %3").arg(text(line, "property"), text(line, "object"), shown(value)));
    return {};
}

}  // namespace planewright
