// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/view3d/pointer_tip.h"

#include <algorithm>

#include <QObject>

#include "core/types/plane_words.h"

namespace planewright {

QString pointerTip(const Picked& picked, const ShownMap& map)
{
    if (picked.plane == kNoPlane && picked.segment)
        return QObject::tr("segment %1, unfitted").arg(QString::fromStdString(segmentLabel(*picked.segment)));
    const auto shown = std::find_if(map.planes.begin(), map.planes.end(),
                                    [&](const ShownPlane& plane) { return plane.plane->id == picked.plane; });
    if (shown == map.planes.end())
        return {};
    return QObject::tr("%1 %2, %3 m², E %4")
        .arg(QString::fromStdString(planeLabel(picked.plane)))
        .arg(QString::fromStdString(shown->name.empty() ? shown->className : shown->name))
        .arg(shown->outline ? shown->outline->outline.area : 0.0, 0, 'f', 2)
        .arg(shown->plane->fittingError, 0, 'f', 2);
}

}  // namespace planewright
