// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/screenshot.h"

#include <algorithm>

#include <QImageWriter>
#include <QPainter>
#include <QSaveFile>

#include "app/window/asking.h"
#include "app/window/view_text.h"
#include "core/params/registry.h"

namespace planewright {

namespace {

/// What is open over the window is where it is seen, or as near to it as it fits in.
void drawOver(QImage& image, QWidget& window, QWidget& dialog)
{
    const QPoint left(std::max(0, window.width() - dialog.width()), std::max(0, window.height() - dialog.height()));
    const QPoint place = window.mapFromGlobal(dialog.mapToGlobal(QPoint()));
    const QRect frame(QPoint(std::clamp(place.x(), 0, left.x()), std::clamp(place.y(), 0, left.y())), dialog.size());
    QPainter painter(&image);
    painter.drawPixmap(frame.topLeft(), dialog.grab());
    painter.setPen(dialog.palette().color(QPalette::WindowText));
    painter.drawRect(frame.adjusted(0, 0, -1, -1));
}

}  // namespace

QImage takePicture(WindowParts& parts, QSize size, bool wholeWindow)
{
    View3d& view = parts.window->shownView();
    const double ratio = parts.window->devicePixelRatioF();
    QImage image;
    if (wholeWindow) {
        image = parts.window->grab().toImage();
        if (QWidget* dialog = openDialog(); dialog != nullptr && dialog->window() != parts.window.get())
            drawOver(image, *parts.window, *dialog);
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

Result<void> resizeForPicture(WindowParts& parts, QSize size)
{
    parts.window->resize(size);
    const QSize made = parts.window->size();
    if (made == size)
        return {};
    return fail(ErrorCode::Usage, "the window cannot be " + std::to_string(size.width()) + "x" +
                                      std::to_string(size.height()) + ", only " + std::to_string(made.width()) + "x" +
                                      std::to_string(made.height()) + "; choose another size");
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
