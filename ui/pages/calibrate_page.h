// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/pages/page.h"

#include <memory>

namespace gripscope {

struct CalibrationRecord;

/// Calibrating the channels: how they stand, what was done before, and a new calibration, point by point.
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
    QWidget* makeOverview();
    QWidget* makeHistory();
    void refresh();
    void reload();
    void showStatus();
    void saveCertificate();
    [[nodiscard]] const CalibrationRecord* selected() const;

    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
