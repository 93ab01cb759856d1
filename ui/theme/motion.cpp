// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/theme/motion.h"

#include <QApplication>
#include <QStyle>
#include <QVariant>

namespace planewright {

namespace {

constexpr const char* kMotionReduced = "planewrightMotionReduced";

}  // namespace

bool isMotionReduced()
{
    return qApp->property(kMotionReduced).toBool() ||
           QApplication::style()->styleHint(QStyle::SH_Widget_Animation_Duration) == 0;
}

void setMotionReduced(bool reduced)
{
    qApp->setProperty(kMotionReduced, reduced);
}

}  // namespace planewright
