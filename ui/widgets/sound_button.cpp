// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/sound_button.h"

#include "ui/settings/settings.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"

using namespace Qt::StringLiterals;

namespace gripscope {

SoundButton::SoundButton(Settings& settings, QWidget* parent) : QPushButton(parent), m_settings(&settings)
{
    setRole(this, "quiet");
    setCheckable(true);
    setIconSize({22, 22});
    setFixedWidth(64);
    setFocusPolicy(Qt::TabFocus); // a click must not take Space from the squeeze
    connect(this, &QPushButton::clicked, this,
            [this](bool on) { m_settings->set(setting::soundOnVerdict, on); });
    connect(m_settings, &Settings::changed, this, &SoundButton::refresh);
    connect(&Theme::instance(), &Theme::changed, this, &SoundButton::refresh);
    refresh();
}

void SoundButton::refresh()
{
    const bool on = m_settings->get(setting::soundOnVerdict);
    setChecked(on);
    setIcon(Theme::instance().icon(on ? u"audio-volume-high"_s : u"audio-volume-muted"_s));
    setAccessibleName(on ? tr("Sound on") : tr("Sound off"));
    setToolTip(on ? tr("Each verdict is heard. Click to switch the sound off.")
                  : tr("Verdicts are silent. Click to switch the sound on."));
}

} // namespace gripscope
