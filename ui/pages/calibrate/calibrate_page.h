// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_record.h"
#include "core/library/library.h"
#include "ui/pages/page.h"

#include <memory>

namespace gripscope {

/// A force channel against weights, made up for demonstrations: 1.2 % too high, with a little hysteresis.
[[nodiscard]] SensorCalibration exampleCalibration();
/// A spring for the virtual gripper, whose can A stands in for it.
[[nodiscard]] ReferenceObject exampleReference();
/// These in the library, with some checks on the spring.
[[nodiscard]] Expected<void> storeExamples(Library& library);

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
    [[nodiscard]] bool underWay() const override;
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
