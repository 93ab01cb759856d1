// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QtTest>

#include "tests/test_program.h"
#include "ui/opengl/offscreen_window.h"
#include "ui/opengl/opengl_source.h"

namespace planewright {

class OpenGlFunctionsTest : public QObject {
    Q_OBJECT

private slots:
    void everyFunctionThatVtkCallsByNameIsPassedOn();
    void thePassedFunctionsAreTheProgramsOwn();
    void osmesaIsTakenOnceAndForAll();
};

namespace {

QSet<QString> passedFunctions()
{
    QSet<QString> names;
#define PASS(result, name, parameters, arguments) names.insert(QStringLiteral(#name));
#include "ui/opengl/opengl_functions.h"
#undef PASS
    return names;
}

/// The libraries of VTK that this program has loaded.
QSet<QString> loadedVtkLibraries()
{
    QFile maps(QStringLiteral("/proc/self/maps"));
    QSet<QString> libraries;
    if (!maps.open(QIODevice::ReadOnly))
        return libraries;
    static const QRegularExpression kLibrary(QStringLiteral("(/\\S*/libvtk\\S+\\.so\\S*)"));
    auto matches = kLibrary.globalMatch(QString::fromUtf8(maps.readAll()));
    while (matches.hasNext())
        libraries.insert(matches.next().captured(1));
    return libraries;
}

/// What `nm` says of a file's dynamic symbols, line by line.
QStringList symbols(const QString& file, const QStringList& options)
{
    QProcess nm;
    nm.start(QStringLiteral("nm"), QStringList{QStringLiteral("-D")} + options + QStringList{file});
    if (!nm.waitForFinished() || nm.exitCode() != 0)
        return {};
    return QString::fromUtf8(nm.readAllStandardOutput()).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
}

}  // namespace

void OpenGlFunctionsTest::everyFunctionThatVtkCallsByNameIsPassedOn()
{
    static const QRegularExpression kOpenGl(QStringLiteral("\\bU (gl[A-Z]\\w*)"));
    const QSet<QString> passed = passedFunctions();
    QSet<QString> called;
    for (const QString& library : loadedVtkLibraries()) {
        for (const QString& line : symbols(library, {QStringLiteral("--undefined-only")})) {
            const auto match = kOpenGl.match(line);
            // GLX is called by VTK's window for X, which is not used.
            if (match.hasMatch() && !match.captured(1).startsWith(QLatin1String("glX")))
                called.insert(match.captured(1));
        }
    }

    QVERIFY(called.size() > 30);
    QVERIFY2((called - passed).isEmpty(), qPrintable(QStringList((called - passed).values()).join(' ')));
}

void OpenGlFunctionsTest::thePassedFunctionsAreTheProgramsOwn()
{
    static const QRegularExpression kDefined(QStringLiteral("\\bT (gl\\w+)"));
    QSet<QString> defined;
    for (const QString& line : symbols(QCoreApplication::applicationFilePath(), {QStringLiteral("--defined-only")})) {
        const auto match = kDefined.match(line);
        if (match.hasMatch())
            defined.insert(match.captured(1));
    }

    QVERIFY((passedFunctions() - defined).isEmpty());
    QVERIFY(defined.contains(QStringLiteral("glXGetProcAddressARB")));
}

void OpenGlFunctionsTest::osmesaIsTakenOnceAndForAll()
{
    const auto window = OffscreenWindow::open(OffscreenRenderer::Auto, 64, 48);
    QVERIFY2(window, window ? "" : window.error().message.c_str());
    QVERIFY(openGlSource() == OpenGlSource::Osmesa);

    QVERIFY(useOsmesa());
    QVERIFY((*window)->IsCurrent());
    QVERIFY(QByteArray((*window)->ReportCapabilities()).contains("llvmpipe"));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::OpenGlFunctionsTest)
#include "opengl_functions_test.moc"
