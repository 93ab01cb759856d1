// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/window_program.h"

#include <cstdio>

#include <QApplication>
#include <QDir>
#include <QOpenGLContext>
#include <QStandardPaths>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <QTimer>

#include "app/cli/exit_code.h"
#include "app/window/screenshot.h"
#include "app/window/script_runner.h"
#include "app/window/waiting.h"
#include "app/window/window_controllers.h"
#include "ui/models/preferences_store.h"
#include "ui/models/preset_folder.h"
#include "ui/theme/theme_follower.h"

namespace planewright {

namespace {

constexpr std::chrono::minutes kLongestScan{60};

int tell(const Error& error)
{
    std::fprintf(stderr, "planewright: %s\n", error.message.c_str());
    return static_cast<int>(exitCodeOf(error.code));
}

/// Whether this display has an OpenGL that the view can be drawn with.
bool hasOpenGl()
{
    QSurfaceFormat wanted;
    wanted.setVersion(3, 2);
    wanted.setProfile(QSurfaceFormat::CoreProfile);
    QOpenGLContext context;
    context.setFormat(wanted);
    if (!context.create())
        return false;
    const QSurfaceFormat format = context.format();
    return format.renderableType() == QSurfaceFormat::OpenGL && format.version() >= qMakePair(3, 2);
}

PresenterSettings presenterSettings(const WindowOptions& options, Renderer preferred)
{
    PresenterSettings settings;
    const QString platform = QGuiApplication::platformName();
    settings.image = platform == QLatin1String("offscreen") || platform == QLatin1String("minimal") ||
                     options.renderer == RendererChoice::Osmesa || options.renderer == RendererChoice::Egl ||
                     (options.renderer == RendererChoice::Auto &&
                      (preferred == Renderer::Software || (preferred == Renderer::Automatic && !hasOpenGl())));
    settings.offscreen = options.renderer == RendererChoice::Egl      ? OffscreenRenderer::Egl
                         : options.renderer == RendererChoice::Osmesa ? OffscreenRenderer::Osmesa
                                                                      : OffscreenRenderer::Auto;
    return settings;
}

/// Somebody asked for safe mode now, or the last time for this start.
bool isSafeMode(const WindowOptions& options, const QString& config)
{
    if (options.safeMode || options.offscreen)
        return options.safeMode;
    QSettings settings(config + "/window.ini", QSettings::IniFormat);
    Preferences preferences = loadPreferences(settings);
    if (!preferences.safeModeNextStart)
        return false;
    preferences.safeModeNextStart = false;
    savePreferences(preferences, settings);
    return true;
}

/// What the command line asks for beyond showing the window; the exit code.
int perform(const WindowOptions& options, WindowParts& parts, ScanControl& scan)
{
    bool isDamaged = false;
    const auto tellDamage = [&] {
        if (const auto& damage = parts.session.damage()) {
            isDamaged = true;
            for (const std::string& warning : damage->warnings)
                std::fprintf(stderr, "planewright: warning: %s\n", warning.c_str());
        }
    };
    QObject listener;
    QObject::connect(&parts.session, &ScanSession::projectChanged, &listener, tellDamage);
    tellDamage();  // it may be open already
    if (!options.script.empty()) {
        ScriptRunner script(parts, scan);
        if (const auto done = script.run(QString::fromStdString(options.script)); !done)
            return tell(done.error());
    }
    const auto whenDone = [&isDamaged] { return static_cast<int>(isDamaged ? ExitCode::Damaged : ExitCode::Done); };
    if (options.screenshot.empty())
        return whenDone();
    if (const auto rested = waitForRest(parts, kLongestScan); !rested)
        return tell(rested.error());
    if (options.step >= 0) {
        if (const auto gone = lookAtStep(parts, options.step); !gone)
            return tell(gone.error());
        if (const auto rested = waitForRest(parts, kLongestScan); !rested)
            return tell(rested.error());
    }
    const QSize size = options.wholeWindow ? QSize() : QSize(options.size.width, options.size.height);
    const auto saved =
        savePicture(takePicture(parts, size, options.wholeWindow), QString::fromStdString(options.screenshot));
    return saved ? whenDone() : tell(saved.error());
}

}  // namespace

int runWindow(const WindowOptions& options, int& argc, char** argv)
{
    if (options.offscreen)
        qputenv("QT_QPA_PLATFORM", "offscreen");
    if (options.scale != 1.0)
        qputenv("QT_SCALE_FACTOR", QByteArray::number(options.scale));
    QApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QApplication app(argc, argv);
    QApplication::setApplicationName(QStringLiteral("planewright"));
    QApplication::setApplicationDisplayName(QStringLiteral("Planewright"));
    QApplication::setApplicationVersion(QStringLiteral(PLANEWRIGHT_VERSION));
    // Numbers look alike everywhere, in the window as in files.
    QLocale::setDefault(QLocale::c());

    const QString config = QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation) + "/planewright";
    // Pictures and scripts must not depend on what somebody has set up.
    const bool plain = options.offscreen || isSafeMode(options, config);
    const QTemporaryDir scratch;
    ThemeFollower follower;
    WindowParts parts(options.parameters, (plain ? scratch.path() : config) + "/window.ini");
    if (options.theme || plain)
        parts.preferences.theme = options.theme == Theme::Dark ? ThemeChoice::Dark : ThemeChoice::Light;
    const PresetFolder presets(config + "/presets");
    for (const QString& problem : presets.load(parts.parameters))
        parts.log(LogSeverity::Warning, QStringLiteral("presets"), problem);
    parts.parametersPanel->setPresetKeeper([&presets](const QString& name, const Parameters& parameters) {
        const auto saved = presets.save(name, parameters);
        return saved ? QString() : QString::fromStdString(saved.error().message);
    });

    const Renderer preferred = parts.preferences.renderer;
    if (const auto presented = parts.window->view().present(presenterSettings(options, preferred)); !presented)
        return tell(presented.error());
    WindowControllers controllers(parts, follower);
    ScanControl& scan = controllers.scan;
    if (!plain)
        parts.window->restoreLayout(parts.settings);
    controllers.kept.setWrites(!options.offscreen);
    parts.window->beforeClose = [&] {
        controllers.kept.save();
        (void)parts.session.stopMotion();
        if (!plain)
            parts.window->saveLayout(parts.settings);
    };
    if (options.offscreen && options.wholeWindow) {
        if (const auto sized = resizeForPicture(parts, {options.size.width, options.size.height}); !sized)
            return tell({ErrorCode::Usage, "--size: " + sized.error().message});
    }
    if (options.theme == std::nullopt && !plain)
        follower.askDesktop();
    parts.window->show();
    if (!options.input.empty())
        scan.open(QString::fromStdString(options.input), true);

    const bool endsBySelf = !options.script.empty() || !options.screenshot.empty();
    if (endsBySelf)
        QTimer::singleShot(0, &app, [&] { QApplication::exit(perform(options, parts, scan)); });
    const int code = QApplication::exec();
    parts.session.close();
    return code;
}

}  // namespace planewright
