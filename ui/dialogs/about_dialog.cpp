// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/dialogs/about_dialog.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace planewright {

AboutDialog::AboutDialog(const QList<QPair<QString, QString>>& parts, QWidget* parent) : QDialog(parent)
{
    setObjectName(QStringLiteral("aboutDialog"));
    setWindowTitle(tr("About Planewright"));
    setMinimumWidth(440);
    QString table = QStringLiteral("<table cellspacing=\"4\">");
    QString plain;
    for (const auto& [name, version] : parts) {
        table += QStringLiteral("<tr><td>%1</td><td>&nbsp;</td><td>%2</td></tr>")
                     .arg(name.toHtmlEscaped(), version.toHtmlEscaped());
        plain += name + ' ' + version + '\n';
    }
    auto* text = new QLabel(
        tr("<h2>Planewright</h2>"
           "<p>A laser scanner that nods sees a room one slice at a time. Planewright turns these slices into the "
           "planes of the room while the scan is still going on.</p>"
           "<p>The method: <i>Line segment-based fast 3D plane extraction using nodding 2D laser "
           "rangefinder</i>.</p>") +
            table + QStringLiteral("</table>") +
            tr("<p>Copyright 2026 The Planewright authors. BSD-3-Clause licence. It uses Qt under the LGPL, version 3, "
               "and VTK under the BSD licence.</p><p>Nothing is sent anywhere.</p>"),
        this);
    text->setObjectName(QStringLiteral("aboutText"));
    text->setAccessibleName(tr("About Planewright"));
    text->setWordWrap(true);
    text->setTextFormat(Qt::RichText);
    text->setTextInteractionFlags(Qt::TextBrowserInteraction);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    QPushButton* copy = buttons->addButton(tr("Copy versions"), QDialogButtonBox::ActionRole);
    copy->setObjectName(QStringLiteral("copyVersions"));
    copy->setAutoDefault(false);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(text, 1);
    layout->addWidget(buttons);
    connect(copy, &QPushButton::clicked, this, [plain] { QGuiApplication::clipboard()->setText(plain); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

}  // namespace planewright
