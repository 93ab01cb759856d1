// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QByteArray>
#include <QMap>
#include <QString>
#include <QStringList>

/// What the program said and returned.
struct ProgramRun {
    int code = -1;  ///< -1 where it crashed
    QByteArray out;
    QByteArray err;
};

/// Runs planewright-cli in a folder, with additions to the environment, and waits for it.
ProgramRun runProgram(const QStringList& arguments, const QString& folder = {},
                      const QMap<QString, QString>& environment = {});

/// The bytes of a file; a file that is not there gives a null array.
QByteArray bytesOf(const QString& path);

/// Writes a file.
void writeBytes(const QString& path, const QByteArray& bytes);

/// A recording of so many slices of so many beams, all with one range [mm], levelled upwards from 60 degrees.
QByteArray recordingText(int slices, int beams, int range, const QByteArray& scanner = "UTM-30LX");

/// Simulates the twelve planes at a coarse setting without noise to scan.csv, truth.csv and truth.labels in a folder.
ProgramRun simulateTwelve(const QString& folder);

/// A real recording: in $PLANEWRIGHT_TEST_DATA, else among the samples of the source tree; empty if neither has it.
QString realRecording(const QString& name);
