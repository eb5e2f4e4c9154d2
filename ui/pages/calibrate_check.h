// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/reference_check.h"

#include <QWidget>

#include <memory>

namespace gripscope {

class Workbench;

/// The check on a reference spring before a shift: how the gripper stands, the check itself, and how the
/// checks went over time.
class CalibrateCheck : public QWidget {
    Q_OBJECT
public:
    explicit CalibrateCheck(Workbench& workbench, QWidget* parent = nullptr);
    ~CalibrateCheck() override;

    void setActive(bool active);
    void act(); ///< what Space does
    void leave();
    /// Asks for the checks of the gripper anew.
    void reload();
    [[nodiscard]] bool loaded() const; ///< there are checks to be seen

private:
    QWidget* makeCheck();
    QWidget* makeHistory();
    void showStanding();
    void showChecks(std::vector<ReferenceCheckRecord> checks);
    void editReference();
    void keepReference(const ReferenceObject& reference);
    [[nodiscard]] QString serial() const;

    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
