// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/file_control.h"

#include <QComboBox>
#include <QDateTime>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QSpinBox>
#include <QStandardPaths>

#include "app/files/recording_file.h"
#include "app/window/asking.h"
#include "app/window/screenshot.h"

namespace planewright {

namespace {

QString filtersOf(ExportKind kind)
{
    QStringList filters;
    for (const std::string_view suffix : suffixesOf(kind))
        filters.push_back(
            QStringLiteral("%1 (*%2)")
                .arg(QString::fromUtf8(suffix.data() + 1, static_cast<qsizetype>(suffix.size()) - 1).toUpper(),
                     QString::fromUtf8(suffix.data(), static_cast<qsizetype>(suffix.size()))));
    return filters.join(QStringLiteral(";;"));
}

}  // namespace

FileControl::FileControl(WindowParts& parts, ScanControl& scan) : QObject(&parts), parts_(parts), scan_(scan)
{
    WindowActions& actions = parts_.window->actions();
    const auto on = [&](const char* name, auto&& call) {
        connect(actions[QLatin1String(name)], &QAction::triggered, this, call);
    };
    on("actOpen", [this] { openWithDialog(); });
    connect(&parts_.window->welcome(), &WelcomePage::openDialogRequested, this, &FileControl::openWithDialog);
    on("actImportCloud", [this] { importWithDialog(); });
    on("actSave", [this] {
        const QString file = QString::fromStdString(parts_.session.status().recording);
        parts_.say(file.isEmpty() ? tr("This scan is not recorded; Save a copy as… writes it to a file.")
                                  : tr("Everything is already in %1").arg(file));
    });
    on("actSaveCopy", [this] { saveCopy(); });
    on("actExportPlanes",
       [this] { exportWithDialog(ExportKind::PlanesFound, tr("Export planes"), QStringLiteral("planes.csv")); });
    on("actExportPoints",
       [this] { exportWithDialog(ExportKind::ScanPoints, tr("Export points"), QStringLiteral("points.ply")); });
    on("actExportSegments",
       [this] { exportWithDialog(ExportKind::LineSegments, tr("Export segments"), QStringLiteral("segments.csv")); });
    on("actExportFloorPlan",
       [this] { exportWithDialog(ExportKind::FloorPlan, tr("Export floor plan"), QStringLiteral("plan.dxf")); });
    on("actExportReport",
       [this] { exportWithDialog(ExportKind::PageOfScan, tr("Export report"), QStringLiteral("report.html")); });
    on("actScreenshot", [this] { takeScreenshot(); });
    on("actScreenshotOptions", [this] { takeScreenshotWithOptions(); });
    on("actValidate", [this] { validate(); });
    on("actQuit", [this] { parts_.window->close(); });
    const auto refresh = [this, &actions] {
        const bool any = parts_.shown->snapshot != nullptr;
        for (const char* name : {"actSaveCopy", "actExportPlanes", "actExportPoints", "actExportSegments",
                                 "actExportFloorPlan", "actExportReport", "actScreenshot", "actScreenshotOptions"})
            actions[QLatin1String(name)]->setEnabled(any);
    };
    connect(&parts_, &WindowParts::mapShown, this, refresh);
    refresh();
}

QString FileControl::folder() const
{
    return parts_.settings
        .value(QStringLiteral("folder"), QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation))
        .toString();
}

void FileControl::openWithDialog()
{
    const QString file = QFileDialog::getOpenFileName(
        parts_.window.get(), tr("Open a recording"), folder(),
        tr("Recordings (*.pwscan *.csv *.csv.gz);;Clouds (*.pcd *.ptx *.3d);;All files (*)"));
    openChosen(file);
}

void FileControl::importWithDialog()
{
    openChosen(QFileDialog::getOpenFileName(parts_.window.get(), tr("Import a cloud"), folder(),
                                            tr("Clouds (*.pcd *.ptx *.3d);;All files (*)")));
}

void FileControl::openChosen(const QString& file)
{
    if (file.isEmpty())
        return;
    parts_.settings.setValue(QStringLiteral("folder"), QFileInfo(file).absolutePath());
    scan_.open(file);
}

QString FileControl::chosenTarget(const QString& title, const QString& name, const QString& filters)
{
    const QString file = QFileDialog::getSaveFileName(parts_.window.get(), title, folder() + "/" + name, filters);
    if (!file.isEmpty())
        parts_.settings.setValue(QStringLiteral("folder"), QFileInfo(file).absolutePath());
    return file;
}

void FileControl::saveCopy()
{
    const QString file = chosenTarget(tr("Save a copy as"), QStringLiteral("scan.pwscan"),
                                      tr("Projects with edits (*.pwscan);;Slices only (*.csv.gz *.csv)"));
    if (file.isEmpty())
        return;
    write(tr("save"), file, copyOf(parts_, file));
}

void FileControl::exportWithDialog(ExportKind kind, const QString& title, const QString& name)
{
    const QString file = chosenTarget(title, name, filtersOf(kind));
    if (!file.isEmpty())
        write(tr("export"), file, exportOf(parts_, kind, file));
}

void FileControl::write(const QString& source, const QString& file,
                        const Result<std::function<Result<void>()>>& writing)
{
    if (!writing) {
        parts_.problem(source, writing.error());
        return;
    }
    parts_.say(tr("Writing %1…").arg(file));
    parts_.background.start<Result<void>>(*writing, [this, source, file](const Result<void>& done) {
        if (!done) {
            parts_.problem(source, done.error());
            return;
        }
        parts_.log(LogSeverity::Info, source, tr("Wrote %1").arg(file));
        parts_.say(tr("Wrote %1").arg(file));
    });
}

void FileControl::save(const QImage& picture, const QString& file)
{
    write(tr("screenshot"), file,
          std::function<Result<void>()>([picture, file] { return savePicture(picture, file); }));
}

void FileControl::takeScreenshot()
{
    const QString pictures = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
    QDir().mkpath(pictures);
    const QString name = QDateTime::currentDateTime().toString(QStringLiteral("'planewright-'yyyyMMdd-HHmmss'.png'"));
    save(takePicture(parts_, {}, false), pictures + "/" + name);
}

void FileControl::takeScreenshotWithOptions()
{
    auto* dialog = new QDialog(parts_.window.get());
    dialog->setObjectName(QStringLiteral("screenshotDialog"));
    dialog->setWindowTitle(tr("Screenshot"));
    auto* form = new QFormLayout(dialog);
    auto* what = new QComboBox;
    what->setObjectName(QStringLiteral("screenshotWhat"));
    what->addItems({tr("3D view"), tr("Whole window, as it is")});
    auto* width = new QSpinBox;
    auto* height = new QSpinBox;
    width->setObjectName(QStringLiteral("screenshotWidth"));
    height->setObjectName(QStringLiteral("screenshotHeight"));
    for (QSpinBox* box : {width, height}) {
        box->setRange(kFewestPixels, kMostPixels);
        box->setSuffix(tr(" px"));
    }
    width->setValue(1920);
    height->setValue(1080);
    form->addRow(tr("&Show"), what);
    form->addRow(tr("&Width"), width);
    form->addRow(tr("&Height"), height);
    connect(what, &QComboBox::currentIndexChanged, dialog, [=](int index) {
        width->setEnabled(index == 0);
        height->setEnabled(index == 0);
    });
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel);
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::accepted, dialog, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    connect(dialog, &QDialog::accepted, this, [=, this] {
        const QSize size(width->value(), height->value());
        const bool isWhole = what->currentIndex() == 1;
        const QString file =
            chosenTarget(tr("Save screenshot"), QStringLiteral("planewright.png"), tr("Pictures (*.png)"));
        if (!file.isEmpty())
            save(takePicture(parts_, size, isWhole), file);
    });
    ask(dialog);
}

void FileControl::validate()
{
    const QString file =
        QFileDialog::getOpenFileName(parts_.window.get(), tr("Validate a recording"), folder(),
                                     tr("Recordings and clouds (*.pwscan *.csv *.csv.gz *.pcd *.ptx *.3d)"));
    if (file.isEmpty())
        return;
    parts_.say(tr("Checking %1…").arg(file));
    parts_.background.start<Result<RecordingProblems>>(
        [path = file.toStdString()] { return problemsOfRecordingFile(path); },
        [this, file](const Result<RecordingProblems>& problems) { tellProblems(file, problems); });
}

void FileControl::tellProblems(const QString& file, const Result<RecordingProblems>& problems)
{
    parts_.say({});
    if (!problems) {
        parts_.problem(tr("validate"), problems.error());
        return;
    }
    for (const std::string& text : problems->problems)
        parts_.log(LogSeverity::Error, tr("validate"), QString::fromStdString(text));
    for (const std::string& text : problems->warnings)
        parts_.log(LogSeverity::Warning, tr("validate"), QString::fromStdString(text));
    const std::size_t count = problems->problems.size() + problems->more;
    parts_.window->showBottomPanel(QStringLiteral("logPanel"));
    parts_.window->banner().showMessage(count > 0 ? Banner::Kind::Problem : Banner::Kind::Notice,
                                        count > 0
                                            ? tr("%1: problems found: %2; the log lists them.").arg(file).arg(count)
                                            : tr("%1: no problem found.").arg(file));
}

}  // namespace planewright
