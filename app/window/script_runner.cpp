// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/script_runner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include <QAction>
#include <QCoreApplication>
#include <QDialog>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QMetaProperty>

#include "app/window/asking.h"
#include "app/window/history_control.h"
#include "app/window/screenshot.h"
#include "app/window/view_text.h"
#include "app/window/waiting.h"

namespace planewright {

namespace {

constexpr std::chrono::seconds kSettleTime{60};
constexpr double kDefaultTimeout = 30.0;      // [s]
constexpr double kLongestTimeout = 86'400.0;  // [s]
constexpr double kLargestNumber = 1e9;        // of steps, as in files

tl::unexpected<Error> wrong(const QString& what)
{
    return fail(ErrorCode::GateFailed, what.toStdString());
}

QString text(const QJsonObject& line, const char* key)
{
    return line.value(QLatin1String(key)).toString();
}

/// Empty where it is none, or too large for a step or a plane.
std::optional<int> wholeNumber(const QJsonValue& value)
{
    const double number = value.toDouble(0.5);
    const bool isWhole = std::abs(number) <= kLargestNumber && number == std::floor(number);
    return isWhole ? std::optional(static_cast<int>(number)) : std::nullopt;
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
    struct Verb {
        const char* name;
        QStringList keys;
        Result<void> (ScriptRunner::*perform)(const QJsonObject&);
    };
    static const std::array kVerbs{
        Verb{"open", {"file", "address"}, &ScriptRunner::open},
        Verb{"goto", {"step"}, &ScriptRunner::goTo},
        Verb{"select", {"plane", "segment"}, &ScriptRunner::select},
        Verb{"action", {"name"}, &ScriptRunner::trigger},
        Verb{"set", {"object", "property", "value"}, &ScriptRunner::set},
        Verb{"wait", {"state", "timeout"}, &ScriptRunner::wait},
        Verb{"screenshot", {"file", "size", "window"}, &ScriptRunner::screenshot},
        Verb{"expect", {"object", "property", "equals", "atLeast", "atMost"}, &ScriptRunner::expect},
        Verb{"quit", {}, &ScriptRunner::quit}};
    const QString what = text(line, "do");
    const auto verb = std::find_if(kVerbs.begin(), kVerbs.end(),
                                   [&](const Verb& candidate) { return what == QLatin1String(candidate.name); });
    if (verb == kVerbs.end())
        return wrong(QStringLiteral("\"do\" is %1; known are open, goto, select, action, set, wait, screenshot, expect "
                                    "and quit")
                         .arg(shown(line.value(QLatin1String("do")))));
    for (const QString& key : line.keys()) {
        if (key != QLatin1String("do") && !verb->keys.contains(key))
            return wrong(verb->keys.isEmpty() ? QStringLiteral("%1 has no key \"%2\"; it has none").arg(what, key)
                                              : QStringLiteral("%1 has no key \"%2\"; it has %3")
                                                    .arg(what, key, verb->keys.join(QStringLiteral(", "))));
    }
    return (this->*verb->perform)(line);
}

Result<void> ScriptRunner::quit(const QJsonObject& /*line*/)
{
    quits_ = true;
    return {};
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
    const auto step = wholeNumber(line.value(QLatin1String("step")));
    if (!step)
        return wrong(QStringLiteral("goto needs a whole number as \"step\", counted from 0"));
    int last = -1;
    for (const auto& snapshot : parts_.playhead.history())
        last = std::max(last, snapshot->report.step);
    if (last >= 0 && (*step < 0 || *step > last))
        return wrong(QStringLiteral("there is no step %1; the scan has steps 0 to %2").arg(*step).arg(last));
    if (auto gone = lookAtStep(parts_, *step); !gone)
        return gone;
    if (last < 0)
        return wrong(QStringLiteral("the scan has no step yet; wait for its state first"));
    waitUntil([&] { return parts_.session.map()->step <= *step; }, kSettleTime);
    settle();
    return {};
}

Result<void> ScriptRunner::select(const QJsonObject& line)
{
    settle();
    if (line.contains(QLatin1String("plane")) == line.contains(QLatin1String("segment")))
        return wrong(QStringLiteral("select needs one of \"plane\" and \"segment\""));
    if (line.contains(QLatin1String("plane"))) {
        const auto id = wholeNumber(line.value(QLatin1String("plane")));
        const auto& planes = parts_.shown->planes;
        if (!id || std::none_of(planes.begin(), planes.end(), [id](const ShownPlane& p) { return p.plane->id == *id; }))
            return wrong(
                QStringLiteral("there is no plane %1 at this step").arg(shown(line.value(QLatin1String("plane")))));
        parts_.selection.select({*id});
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
    return wrong(QStringLiteral("there is no segment %1 at this step; one is named as \"step.index\"")
                     .arg(shown(line.value(QLatin1String("segment")))));
}

Result<void> ScriptRunner::trigger(const QJsonObject& line)
{
    const QString name = text(line, "name");
    auto* action = parts_.window->findChild<QAction*>(name);
    if (action == nullptr)
        return wrong(QStringLiteral("there is no action %1; the list of shortcuts names them").arg(name));
    if (!action->isEnabled())
        return wrong(QStringLiteral("%1 is not possible now").arg(name));
    // A dialog that goes on by itself stays open: its fields are set like others, and "visible" false leaves it.
    if (const QString asked = performUnasked([action] { action->trigger(); }); !asked.isEmpty())
        return wrong(QStringLiteral("%1 waits for an answer in \"%2\", which a script cannot give").arg(name, asked));
    settle();
    return {};
}

Result<QObject*> ScriptRunner::objectOf(const QJsonObject& line)
{
    const QString name = text(line, "object");
    QObject* object = nullptr;
    for (QWidget* top : {openDialog(), static_cast<QWidget*>(parts_.window.get())}) {
        if (object == nullptr && top != nullptr)
            object = top->objectName() == name ? top : top->findChild<QObject*>(name);
    }
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
    if (!line.contains(QLatin1String("value")))
        return wrong(QStringLiteral("set needs a \"value\""));
    if (auto* dialog = qobject_cast<QDialog*>(*object); dialog != nullptr && dialog == openDialog() &&
                                                        text(line, "property") == QLatin1String("visible") &&
                                                        line.value(QLatin1String("value")) == QJsonValue(false)) {
        dialog->reject();
        // By itself it would go only when the script is over.
        QCoreApplication::sendPostedEvents(dialog, QEvent::DeferredDelete);
        settle();
        return {};
    }
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
    const double timeout =
        line.contains(QLatin1String("timeout")) ? line.value(QLatin1String("timeout")).toDouble(-1.0) : kDefaultTimeout;
    if (!(timeout >= 0.0 && timeout <= kLongestTimeout))
        return wrong(QStringLiteral("\"timeout\" is a number of seconds, from 0 to %1").arg(kLongestTimeout));
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
    const QJsonValue given = line.value(QLatin1String("size"));
    const QJsonValue window = line.value(QLatin1String("window"));
    QSize size;
    if (!given.isUndefined()) {
        const auto read = readPictureSize(given.toString().toStdString());
        if (!read)
            return wrong(QStringLiteral("\"size\" is like \"1280x800\", each side from %1 to %2")
                             .arg(kFewestPixels)
                             .arg(kMostPixels));
        size = {read->width, read->height};
    }
    if (!window.isUndefined() && !window.isBool())
        return wrong(QStringLiteral("\"window\" is true or false"));
    if (!window.toBool() || size.isEmpty())
        return savePicture(takePicture(parts_, size, window.toBool()), text(line, "file"));
    const QSize before = parts_.window->size();
    Result<void> done = resizeForPicture(parts_, size);
    if (done) {
        settle();
        done = savePicture(takePicture(parts_, {}, true), text(line, "file"));
    }
    parts_.window->resize(before);
    return done;
}

Result<void> ScriptRunner::expect(const QJsonObject& line)
{
    settle();
    const auto object = objectOf(line);
    if (!object)
        return tl::unexpected{object.error()};
    int limits = 0;
    for (const char* key : {"equals", "atLeast", "atMost"}) {
        const QJsonValue limit = line.value(QLatin1String(key));
        limits += limit.isUndefined() ? 0 : 1;
        if (key != std::string_view("equals") && !limit.isUndefined() && !limit.isDouble())
            return wrong(QStringLiteral("\"%1\" is a number").arg(QLatin1String(key)));
    }
    if (limits == 0)
        return wrong(QStringLiteral("expect needs \"equals\", \"atLeast\" or \"atMost\""));
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
