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
#include "tests/ui/made_history.h"
#include "ui/charts/charts_panel.h"
#include "ui/common/scan_charts.h"

using namespace planewright;

namespace {

constexpr std::chrono::minutes kPatience{10};
constexpr std::chrono::milliseconds kSliceTime{25};
constexpr std::chrono::seconds kRest{2};

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
            if (blocked > most_) {
                most_ = blocked;
                longest = what;
            }
            events.push_back(blocked);
        }
        return done;
    }

    void forget()
    {
        events.clear();
        draws.clear();
        longest.clear();
        most_ = 0.0;
    }

    QObject* presenter = nullptr;
    std::vector<double> events;  // [ms], without drawing
    std::vector<double> draws;   // [ms]
    QByteArray longest;          // receiver and type of the longest event
    std::function<void()> onPainted;

private:
    int depth_ = 0;
    double most_ = 0.0;
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

/// How long after it was due each slice of a scan had come so far.
class SliceDelays {
public:
    explicit SliceDelays(const QElapsedTimer& sinceStart) : sinceStart_(sinceStart) {}

    /// All slices up to a step have come.
    void note(int step)
    {
        if (!sinceStart_.isValid())
            return;
        const double now = static_cast<double>(sinceStart_.nsecsElapsed()) / 1e6;
        for (; last_ < step; ++last_)
            delays_.push_back(now - static_cast<double>(last_ + 1) * static_cast<double>(kSliceTime.count()));
    }

    /// Without what all of them have in common [ms].
    std::vector<double> without(double offset) const
    {
        std::vector<double> delays = delays_;
        for (double& delay : delays)
            delay -= offset;
        return delays;
    }
    double least() const { return delays_.empty() ? 0.0 : *std::min_element(delays_.begin(), delays_.end()); }

private:
    const QElapsedTimer& sinceStart_;
    int last_ = -1;
    std::vector<double> delays_;  // [ms]
};

/// A scan at 40 slices a second: when its slices are seen, and what holds up the window. False if it fails.
bool reportLive(TimedApplication& app, WindowParts& parts, ScanControl& scan, const SimulatedScanner& simulation)
{
    QElapsedTimer sinceStart;
    SliceDelays extracted(sinceStart);
    SliceDelays edited(sinceStart);
    SliceDelays seen(sinceStart);
    QObject context;
    QObject::connect(&parts.session, &ScanSession::stateChanged, &context, [&](SessionState state) {
        if (state == SessionState::Scanning && !sinceStart.isValid())
            sinceStart.start();
    });
    QObject::connect(&parts.session, &ScanSession::mapChanged, &context,
                     [&](const auto& map) { extracted.note(map->step); });
    QObject::connect(&parts, &WindowParts::mapShown, &context, [&] { edited.note(parts.shown->step); });
    app.onPainted = [&] { seen.note(parts.shown->step); };
    app.forget();

    scan.openRoom(simulation, QStringLiteral("sim:corridor?seed=1"));
    waitUntil([&] { return parts.session.state() == SessionState::Review; }, kPatience);
    const bool rested = waitForRest(parts, kPatience).has_value();
    const std::vector<double> pictures = app.draws;
    const std::vector<double> events = app.events;
    const QByteArray longest = app.longest;
    // The picture with all points comes when it rests, part by part where that takes long.
    app.forget();
    waitUntil([] { return false; }, kRest);
    app.onPainted = nullptr;

    // The source's own beginning is not known here: the slice that came through soonest counts as coming at once.
    const double offset = extracted.least();
    const auto print = [&](const char* what, const std::vector<double>& values) {
        std::printf("  %-44s %6.1f ms median, %6.1f in 95 %%, %6.1f most\n", what, median(values), share(values, 0.95),
                    share(values, 1.0));
    };
    print("a slice is extracted after", extracted.without(offset));
    print("has the operator's edits after", edited.without(offset));
    print("is seen after", seen.without(offset));
    print("a picture takes", pictures);
    print("any other event takes", events);
    std::printf("  the longest of these: %s\n", longest.constData());
    print("at rest, a part of the picture takes", app.events);
    return rested;
}

/// All charts of the longest scan that is kept, made and drawn as while a scan runs.
void reportCharts()
{
    const auto history = MadeHistory().scan(1024).get();
    ChartsPanel panel;
    panel.resize(1240, 520);
    std::vector<double> made;
    std::vector<double> drawn;
    for (int i = 0; i < 11; ++i) {
        QElapsedTimer timer;
        timer.start();
        panel.setCharts(scanCharts(history, 4.0));
        made.push_back(static_cast<double>(timer.nsecsElapsed()) / 1e6);
        timer.restart();
        panel.grab();
        drawn.push_back(static_cast<double>(timer.nsecsElapsed()) / 1e6);
    }
    std::printf("charts of 1024 steps: made in %.1f ms, drawn in %.1f ms (medians of 11)\n", median(made),
                median(drawn));
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

        if (!reportLive(app, parts, controllers.scan, scanner(setting)))
            return 1;
    }
    reportCharts();
    parts.session.close();
    return 0;
}
