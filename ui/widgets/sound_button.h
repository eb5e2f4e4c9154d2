// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPushButton>

namespace gripscope {

class Settings;

/// Switches the sound of verdicts on and off, for good.
class SoundButton : public QPushButton {
    Q_OBJECT
public:
    explicit SoundButton(Settings& settings, QWidget* parent = nullptr);

private:
    void refresh();
    Settings* m_settings;
};

} // namespace gripscope
