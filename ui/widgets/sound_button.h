// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPushButton>

namespace gripscope {

/// Switches the sound of verdicts on and off, for good.
class SoundButton : public QPushButton {
    Q_OBJECT
public:
    explicit SoundButton(QWidget* parent = nullptr);
    void refresh(); ///< the setting may have been changed elsewhere
};

} // namespace gripscope
