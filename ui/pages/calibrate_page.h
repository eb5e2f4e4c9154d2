// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/pages/page.h"

#include <memory>

namespace gripscope {

/// What keeps the gripper a measuring instrument: its channels against references, the check on a spring
/// before a shift, and what the empty gripper adds.
class CalibratePage : public Page {
    Q_OBJECT
public:
    explicit CalibratePage(Workbench& bench, QWidget* parent = nullptr);
    ~CalibratePage() override;

    [[nodiscard]] QString id() const override;
    [[nodiscard]] QString title() const override;
    [[nodiscard]] QString iconName() const override;
    void setActive(bool active) override;
    void prepareTour() override;
    [[nodiscard]] bool tourReady() const override;

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void show(int part);

    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
