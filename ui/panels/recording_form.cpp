// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/recording_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/panels/plain_fields.h"
#include "ui/panels/simulator_form.h"

namespace planewright {

RecordingForm::RecordingForm(QWidget* parent)
    : QWidget(parent),
      file_(new QLineEdit(this)),
      play_(new QCheckBox(tr("Play as it was taken"), this)),
      speed_(new QuietComboBox(this)),
      recent_(new QListWidget(this))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    auto* label = new QLabel(tr("&File"), this);
    label->setBuddy(file_);
    auto* browse = new QPushButton(tr("Browse…"), this);
    auto* line = new QHBoxLayout;
    line->addWidget(file_, 1);
    line->addWidget(browse);
    auto* playLine = new QHBoxLayout;
    playLine->addWidget(play_);
    playLine->addWidget(speed_, 1);
    auto* recentLabel = new QLabel(tr("&Recent"), this);
    recentLabel->setBuddy(recent_);
    layout->addWidget(label);
    layout->addLayout(line);
    layout->addLayout(playLine);
    layout->addWidget(recentLabel);
    layout->addWidget(recent_);

    file_->setObjectName(QStringLiteral("recordingFile"));
    file_->setAccessibleName(tr("Recording file"));
    file_->setPlaceholderText(tr("A .pwscan, .csv or .csv.gz file"));
    browse->setObjectName(QStringLiteral("browseRecording"));
    browse->setAccessibleName(tr("Browse for a recording"));
    play_->setObjectName(QStringLiteral("playRecording"));
    play_->setAccessibleName(play_->text());
    play_->setToolTip(tr("Slice by slice at its own pace, as a scanner would give it"));
    speed_->setObjectName(QStringLiteral("playSpeed"));
    speed_->setAccessibleName(tr("Speed"));
    addSpeeds(speed_);
    speed_->setEnabled(false);
    recent_->setObjectName(QStringLiteral("recentRecordings"));
    recent_->setAccessibleName(tr("Recent recordings"));
    recent_->setTextElideMode(Qt::ElideMiddle);
    recent_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setRecentFiles({});

    connect(file_, &QLineEdit::textChanged, this, &RecordingForm::changed);
    connect(browse, &QPushButton::clicked, this, &RecordingForm::browse);
    connect(play_, &QCheckBox::toggled, speed_, &QWidget::setEnabled);
    connect(play_, &QCheckBox::toggled, this, &RecordingForm::changed);
    connect(speed_, &QComboBox::currentIndexChanged, this, &RecordingForm::changed);
    connect(recent_, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
        if (item != nullptr)
            setFile(item->data(Qt::UserRole).toString());
    });
}

QString RecordingForm::file() const
{
    return file_->text().trimmed();
}

void RecordingForm::setFile(const QString& file)
{
    file_->setText(file);
}

void RecordingForm::setPlayed(std::optional<double> speed)
{
    play_->setChecked(speed.has_value());
    if (speed)
        chooseSpeed(speed_, *speed);
}

void RecordingForm::setRecentFiles(const QStringList& files)
{
    recent_->clear();
    for (const QString& file : files) {
        auto* item = new QListWidgetItem(QFileInfo(file).fileName(), recent_);
        item->setData(Qt::UserRole, file);
        item->setToolTip(file);
    }
    // Without any the list only says so.
    recent_->setEnabled(!files.isEmpty());
    if (files.isEmpty())
        new QListWidgetItem(tr("None yet"), recent_);
}

QString RecordingForm::problem() const
{
    const QFileInfo info(file());
    if (file().isEmpty())
        return tr("Choose a recording.");
    if (!info.exists())
        return tr("There is no file %1.").arg(file());
    if (info.isDir())
        return tr("%1 is a folder. Choose a file in it.").arg(file());
    return info.isReadable() ? QString{} : tr("%1 may not be read. Ask its owner for permission.").arg(file());
}

QString RecordingForm::address() const
{
    if (!play_->isChecked())
        return file();
    return QStringLiteral("replay:%1?speed=%2").arg(file(), QString::number(speed_->currentData().toDouble()));
}

void RecordingForm::browse()
{
    const QString chosen = QFileDialog::getOpenFileName(
        this, tr("Open recording"), QFileInfo(file()).absolutePath(),
        tr("Recordings (*.pwscan *.csv *.csv.gz);;Clouds (*.pcd *.ptx *.3d);;All files (*)"));
    if (!chosen.isEmpty())
        setFile(chosen);
}

}  // namespace planewright
