// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/ui/view3d/reference_image.h"

#include <algorithm>
#include <cstdlib>

#include <QColor>
#include <QDir>
#include <QSet>

namespace planewright {

int coloursOf(const QImage& picture, int limit)
{
    QSet<QRgb> colours;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width() && colours.size() < limit; ++x)
            colours.insert(picture.pixel(x, y));
    }
    return static_cast<int>(colours.size());
}

QString differenceFromReference(const QImage& picture, const QString& name)
{
    const QString folder = QStringLiteral(PLANEWRIGHT_SOURCE_DIR "/tests/ui/reference_images/");
    const QString write = qEnvironmentVariable("PLANEWRIGHT_WRITE_REFERENCES");
    if (!write.isEmpty() && !(QDir().mkpath(write) && picture.save(write + "/" + name + ".png")))
        return QStringLiteral("cannot write %1/%2.png").arg(write, name);
    if (coloursOf(picture, kFewestColours) < kFewestColours)
        return QStringLiteral("%1 is blank: it has fewer than %2 colours").arg(name).arg(kFewestColours);
    const QImage reference(folder + name + ".png");
    if (reference.isNull())
        return QStringLiteral("there is no reference %1").arg(folder + name + ".png");
    if (reference.size() != picture.size())
        return QStringLiteral("%1 is %2×%3 pixels, its reference %4×%5")
            .arg(name)
            .arg(picture.width())
            .arg(picture.height())
            .arg(reference.width())
            .arg(reference.height());
    qint64 off = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const QColor a(picture.pixel(x, y));
            const QColor b(reference.pixel(x, y));
            const int most =
                std::max({std::abs(a.red() - b.red()), std::abs(a.green() - b.green()), std::abs(a.blue() - b.blue())});
            off += most > kChannelTolerance ? 1 : 0;
        }
    }
    const double share = static_cast<double>(off) / (static_cast<double>(picture.width()) * picture.height());
    if (share <= kShareTolerance)
        return {};
    const QString left = QDir::tempPath() + "/" + name + ".png";
    picture.save(left);
    return QStringLiteral("%1: %2 % of the pixels differ from the reference; see %3")
        .arg(name)
        .arg(100.0 * share)
        .arg(left);
}

}  // namespace planewright
