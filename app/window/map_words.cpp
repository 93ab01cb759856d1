// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/map_words.h"

#include <QObject>

#include "core/types/plane_words.h"

namespace planewright {

QString lineOf(const MapEdit& edit)
{
    const QString scan = QObject::tr("Scan %1: ").arg(edit.scan);
    const auto label = [](PlaneId plane) { return QString::fromStdString(planeLabel(plane)); };
    switch (edit.kind) {
        case MapEdit::Kind::Omit:
            return scan + (edit.on ? QObject::tr("taken out of the map") : QObject::tr("taken into the map again"));
        case MapEdit::Kind::Order:
            return scan +
                   (edit.before ? QObject::tr("comes before scan %1").arg(*edit.before) : QObject::tr("comes last"));
        case MapEdit::Kind::Match:
            return scan + (edit.as ? QObject::tr("%1 is %2 of scan %3")
                                         .arg(label(edit.plane), label(edit.as->plane))
                                         .arg(edit.as->scan)
                                   : QObject::tr("%1 is a plane of its own").arg(label(edit.plane)));
        case MapEdit::Kind::Odometry:
        case MapEdit::Kind::Floor:
            break;
    }
    const bool isFloor = edit.kind == MapEdit::Kind::Floor;
    const std::optional<Pose>& pose = isFloor ? edit.place : edit.odometry;
    if (!pose)
        return scan +
               (isFloor ? QObject::tr("its floor is where odometry says") : QObject::tr("odometry is not known"));
    const Eigen::Vector3d& place = pose->translation;
    return scan + (isFloor ? QObject::tr("it and its floor are at x %1 y %2 z %3 m")
                           : QObject::tr("odometry says x %1 y %2 z %3 m"))
                      .arg(place.x(), 0, 'f', 3)
                      .arg(place.y(), 0, 'f', 3)
                      .arg(place.z(), 0, 'f', 3);
}

}  // namespace planewright
