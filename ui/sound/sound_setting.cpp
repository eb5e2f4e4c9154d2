// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sound/sound_setting.h"

#include <QSettings>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {
const auto key = u"inspect/sound"_s;
}

bool soundIsOn()
{
    return QSettings().value(key, true).toBool();
}

void setSoundOn(bool on)
{
    QSettings().setValue(key, on);
}

} // namespace gripscope
