// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/gripper_factory.h"

#include <QDialog>

namespace gripscope {

class Workbench;

/// What to type so that this user may open a gripper: a command a line, to be copied. Closes by itself when
/// the gripper is connected.
class AccessDialog : public QDialog {
    Q_OBJECT
public:
    AccessDialog(Workbench& workbench, const FoundDevice& device, QWidget* parent = nullptr);
};

} // namespace gripscope
