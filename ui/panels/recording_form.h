// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include <QStringList>
#include <QWidget>

class QCheckBox;
class QComboBox;
class QLineEdit;
class QListWidget;

namespace planewright {

/// Which recording is to be opened, and whether it is played as it was taken.
class RecordingForm : public QWidget {
    Q_OBJECT

public:
    explicit RecordingForm(QWidget* parent = nullptr);

    QString file() const;
    void setFile(const QString& file);
    /// The file is to be played, 1 in real time; nothing: only looked at.
    void setPlayed(std::optional<double> speed);
    void setRecentFiles(const QStringList& files);

    /// What is wrong with the file, or nothing.
    QString problem() const;
    /// The file, or `replay:FILE?speed=X` where it is to be played.
    QString address() const;

signals:
    void changed();

private:
    void browse();

    QLineEdit* file_;
    QCheckBox* play_;
    QComboBox* speed_;
    QListWidget* recent_;
};

}  // namespace planewright
