// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

// How long pictures of the 3D view take in software, how soon a slice is seen while a scan runs, and how long the
// window is held up by anything else than drawing.

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include <QApplication>
#include <QElapsedTimer>
#include <QTemporaryDir>

#include "app/window/waiting.h"
#include "app/window/window_controllers.h"

using namespace planewright;

namespace {

constexpr std::chrono::minutes kPatience{10};
constexpr std::chrono::milliseconds kSliceTime{25};

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values.empty() ? 0.0 : values[values.size() / 2];
}

double share(std::vector<double> values, double part)
{
    std::sort(values.begin(), values.end());
    return values.empty() ? 0.0
                          : values[std::min(values.size() - 1,
                                            static_cast<std::size_t>(part * static_cast<double>(values.size())))];
}

/// Times every event of the GUI's thread, those of drawing apart.
class TimedApplication : public QApplication {
public:
    using QApplication::QApplication;

    bool notify(QObject* receiver, QEvent* event) override
    {
        const QEvent::Type type = event->type();
        const QByteArray what = QByteArray(receiver->metaObject()->className()) + ' ' + QByteArray::number(type);
        const bool paints = receiver == presenter && type == QEvent::Paint;
        QElapsedTimer timer;
        timer.start();
        ++depth_;
        const bool done = QApplication::notify(receiver, event);
        --depth_;
        const double took = static_cast<double>(timer.nsecsElapsed()) / 1e6;
        if (paints) {
            drawing_ += took;
            draws.push_back(took);
            if (onPainted)
                onPainted();
        }
        if (depth_ == 0) {
            const double blocked = took - drawing_;
            drawing_ = 0.0;
            if (measures) {
                events.push_back(blocked);
                if (blocked > longest) {
                    longest = blocked;
                    longestWhat = what;
                }
            }
        }
        return done;
    }

    QObject* presenter = nullptr;
    bool measures = false;
    std::vector<double> events;  // [ms], without drawing
    std::vector<double> draws;   // [ms]
    double longest = 0.0;
    QByteArray longestWhat;
    std::function<void()> onPainted;

private:
    int depth_ = 0;
    double drawing_ = 0.0;
};

SimulatedScanner scanner(const char* setting)
{
    SimulatedScanner simulation{{}, *simulationNoise("default"), 1, 1.0};
    if (std::strcmp(setting, "largest") == 0)
        simulation.settings = *acquisitionSettings("largest");
    simulation.settings.sliceTime = kSliceTime;
    return simulation;
}

/// Median times of pictures at 1280 x 800: all points, and those of a view that moves.
void reportFrames(WindowParts& parts, const std::string& name)
{
    View3d& view = parts.window->view();
    std::vector<double> rest;
    std::vector<double> moving;
    constexpr int kFrames = 15;
    for (int i = 0; i < kFrames; ++i) {
        ViewCamera camera = view.camera();
        camera.heading += 0.02;
        view.setCamera(camera);
        QElapsedTimer timer;
        timer.start();
        (void)view.presenter()->picture({1280, 800}, 1.0);
        rest.push_back(static_cast<double>(timer.nsecsElapsed()) / 1e6);
        view.scene().setPointBudget(static_cast<std::size_t>(1000.0 * parts.preferences.pointBudget));
        timer.start();
        view.presenter()->requestPicture(Detail::Moving);
        view.presenter()->widget().repaint();
        moving.push_back(static_cast<double>(timer.nsecsElapsed()) / 1e6);
    }
    std::printf("%-24s at rest %6.1f ms, moving %6.1f ms (widget of %d x %d)\n", name.c_str(), median(rest),
                median(moving), view.presenter()->widget().width(), view.presenter()->widget().height());
}

}  // namespace

int main(int argc, char** argv)
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    TimedApplication app(argc, argv);
    QApplication::setApplicationName(QStringLiteral("planewright"));
    QLocale::setDefault(QLocale::c());
    const QTemporaryDir folder;
    ThemeFollower follower;
    WindowParts parts({}, folder.filePath(QStringLiteral("window.ini")));
    PresenterSettings presenter;
    presenter.image = true;
    if (const auto presented = parts.window->view().present(presenter); !presented) {
        std::fprintf(stderr, "window_report: %s\n", presented.error().message.c_str());
        return 9;
    }
    WindowControllers controllers(parts, follower);
    parts.window->resize(1920, 1120);
    parts.window->show();
    app.presenter = &parts.window->view().presenter()->widget();

    for (const char* setting : {"table8", "largest"}) {
        // As fast as possible first, for the pictures.
        controllers.scan.openRoom(scanner(setting), QStringLiteral("sim:corridor?seed=1&speed=0"));
        waitUntil([&] { return parts.session.state() == SessionState::Review; }, kPatience);
        if (!waitForRest(parts, kPatience))
            return 1;
        std::size_t points = 0;
        for (const auto& slice : parts.shown->slices)
            points += slice->ranges.size();
        reportFrames(parts, std::to_string(points) + " points");

        // Then at 40 slices a second.
        app.events.clear();
        app.draws.clear();
        app.longest = 0.0;
        std::vector<double> latencies;
        int painted = -1;
        QElapsedTimer sinceStart;
        QObject context;
        QObject::connect(&parts.session, &ScanSession::stateChanged, &context, [&](SessionState state) {
            if (state == SessionState::Scanning && !sinceStart.isValid())
                sinceStart.start();
        });
        app.onPainted = [&] {
            const int shown = parts.shown->step;
            const double now = static_cast<double>(sinceStart.isValid() ? sinceStart.nsecsElapsed() : 0) / 1e6;
            for (; sinceStart.isValid() && painted < shown; ++painted)
                latencies.push_back(now - static_cast<double>(painted + 1) * static_cast<double>(kSliceTime.count()));
        };
        std::vector<double> extracted;
        std::vector<double> ready;
        const auto since = [&] {
            return static_cast<double>(sinceStart.isValid() ? sinceStart.nsecsElapsed() : 0) / 1e6;
        };
        int lastExtracted = -1;
        int lastReady = -1;
        const auto note = [&](int step, int& last, std::vector<double>& delays) {
            for (; sinceStart.isValid() && last < step; ++last)
                delays.push_back(since() - static_cast<double>(last + 1) * static_cast<double>(kSliceTime.count()));
        };
        QObject::connect(&parts.session, &ScanSession::mapChanged, &context,
                         [&](const auto& map) { note(map->step, lastExtracted, extracted); });
        QObject::connect(&parts, &WindowParts::mapShown, &context, [&] { note(parts.shown->step, lastReady, ready); });
        app.measures = true;
        controllers.scan.openRoom(scanner(setting), QStringLiteral("sim:corridor?seed=1"));
        waitUntil([&] { return parts.session.state() == SessionState::Review; }, kPatience);
        if (!waitForRest(parts, kPatience))
            return 1;
        app.measures = false;
        app.onPainted = nullptr;
        // The source's own beginning is not known here: the slice that came through soonest counts as having come at
        // once.
        const double offset = extracted.empty() ? 0.0 : *std::min_element(extracted.begin(), extracted.end());
        for (std::vector<double>* delays : {&extracted, &ready, &latencies}) {
            for (double& delay : *delays)
                delay -= offset;
        }
        std::printf("%-24s extracted after %5.1f ms (median), %5.1f (95 %%); with edits after %5.1f, %5.1f\n", "",
                    median(extracted), share(extracted, 0.95), median(ready), share(ready, 0.95));
        std::printf(
            "%-24s seen after %5.1f ms (median), %5.1f (95 %%), %5.1f (most); pictures %5.1f ms; "
            "held up %5.1f ms at most (%s), %5.1f in 99.9 %% of %zu events\n",
            "  at 40 slices a second", median(latencies), share(latencies, 0.95), share(latencies, 1.0),
            median(app.draws), app.longest, app.longestWhat.constData(), share(app.events, 0.999), app.events.size());
    }
    parts.session.close();
    return 0;
}
