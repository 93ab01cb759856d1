// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "run_program.h"

#include <QFile>
#include <QProcess>
#include <QProcessEnvironment>

ProgramRun runProgram(const QStringList& arguments, const QString& folder, const QMap<QString, QString>& environment)
{
    QProcess process;
    QProcessEnvironment all = QProcessEnvironment::systemEnvironment();
    for (auto it = environment.begin(); it != environment.end(); ++it)
        all.insert(it.key(), it.value());
    process.setProcessEnvironment(all);
    process.setWorkingDirectory(folder);
    process.start(PLANEWRIGHT_CLI, arguments);
    process.closeWriteChannel();
    process.waitForFinished(-1);
    return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1, process.readAllStandardOutput(),
            process.readAllStandardError()};
}

QByteArray bytesOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() + QByteArray("") : QByteArray();
}

void writeBytes(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("cannot write %s", qPrintable(path));
}

QByteArray recordingText(int slices, int beams, int range, const QByteArray& scanner)
{
    QByteArray text = "# format = nodding-laser-csv 1\n# scanner = " + scanner +
                      "\n# bearing_start_deg = 0\n# bearing_step_deg = 1\n# beams = " + QByteArray::number(beams) +
                      "\n# range_min_m = 0.1\n# range_max_m = 30\n# pitch_axis_offset_m = 0.05\nslice,time_s,pitch_deg";
    for (int beam = 0; beam < beams; ++beam)
        text += ",r" + QByteArray::number(beam);
    text += "\n";
    for (int slice = 0; slice < slices; ++slice) {
        text += QByteArray::number(slice) + "," + QByteArray::number(0.025 * slice, 'f', 6) + "," +
                QByteArray::number(60 + slice) + ".00";
        for (int beam = 0; beam < beams; ++beam)
            text += "," + QByteArray::number(range);
        text += "\n";
    }
    return text;
}

ProgramRun simulateTwelve(const QString& folder)
{
    return runProgram({"simulate", "twelve", "-o", "scan.csv", "--truth", "truth.csv", "--truth-labels", "truth.labels",
                       "--noise", "none", "--tilt", "10:170:2", "--bearing", "0:180:0.5"},
                      folder);
}

QString realRecording(const QString& name)
{
    const QStringList folders{qEnvironmentVariable("PLANEWRIGHT_TEST_DATA"),
                              QStringLiteral(PLANEWRIGHT_SOURCE_DIR "/resources/samples")};
    for (const QString& folder : folders) {
        const QString path = folder + "/" + name;
        if (!folder.isEmpty() && QFile::exists(path))
            return path;
    }
    return {};
}
