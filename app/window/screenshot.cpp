// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/screenshot.h"

#include <algorithm>

#include <QImageWriter>
#include <QSaveFile>

#include "app/window/view_text.h"
#include "core/params/registry.h"

namespace planewright {

QImage takePicture(WindowParts& parts, QSize size, bool wholeWindow)
{
    View3d& view = parts.window->view();
    const double ratio = parts.window->devicePixelRatioF();
    QImage image;
    if (wholeWindow) {
        image = parts.window->grab().toImage();
    } else {
        // Lines and text keep their size against the picture: at twice the size of the view they are twice as large.
        const QSize shown = view.size().expandedTo({1, 1});
        const double scale = size.isEmpty()
                                 ? ratio
                                 : std::max(1.0, std::min(static_cast<double>(size.width()) / shown.width(),
                                                          static_cast<double>(size.height()) / shown.height()));
        const QSize pixels = size.isEmpty() ? (QSizeF(shown) * ratio).toSize() : size;
        image = view.picture(pixels.boundedTo({kMostPixels, kMostPixels}), scale);
    }
    image.setText(QStringLiteral("Software"), QStringLiteral("planewright " PLANEWRIGHT_VERSION));
    image.setText(QStringLiteral("Step"), QString::number(parts.shown->step));
    image.setText(QStringLiteral("Camera"), textOf(view.camera()));
    QStringList parameters;
    for (const ParameterRow& row : parameterRows())
        parameters.push_back(QString::fromUtf8(row.key.data(), static_cast<qsizetype>(row.key.size())) +
                             QLatin1Char('=') +
                             QString::fromStdString(printParameter(parts.session.parameters(), row.key)));
    image.setText(QStringLiteral("Parameters"), parameters.join(QLatin1Char('\n')));
    return image;
}

Result<void> savePicture(const QImage& picture, const QString& file)
{
    if (!file.endsWith(QLatin1String(".png"), Qt::CaseInsensitive))
        return fail(ErrorCode::Usage, file.toStdString() + ": pictures are written as .png");
    if (picture.isNull())
        return fail(ErrorCode::NotWritten,
                    file.toStdString() + ": there is no picture to write; choose a smaller size");
    QSaveFile target(file);
    target.setDirectWriteFallback(false);
    const auto failure = [&] {
        return fail(ErrorCode::NotWritten,
                    file.toStdString() + ": cannot be written: " + target.errorString().toStdString());
    };
    if (!target.open(QIODevice::WriteOnly))
        return failure();
    QImageWriter writer(&target, "png");
    if (!writer.write(picture)) {
        target.cancelWriting();
        return fail(ErrorCode::NotWritten,
                    file.toStdString() + ": cannot be written: " + writer.errorString().toStdString());
    }
    if (!target.commit())
        return failure();
    return {};
}

}  // namespace planewright
