// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <memory>

namespace gripscope {

struct CalibrationRecord;
class Workbench;

/// Calibrating the channels: how they stand, what was done before, and a new calibration, point by point.
class CalibrateSensors : public QWidget {
    Q_OBJECT
public:
    explicit CalibrateSensors(Workbench& workbench, QWidget* parent = nullptr);
    ~CalibrateSensors() override;

    void setActive(bool active);
    void act();  ///< what Space does
    void undo(); ///< what Backspace does
    void reload();
    [[nodiscard]] bool loaded() const; ///< there are calibrations to be seen

signals:
    void takingChanged(bool taking); ///< points are being taken: nothing else should be in the way

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QWidget* makeOverview();
    QWidget* makeHistory();
    QLayout* makeStatus(QWidget* card);
    void refresh();
    void showStatus();
    void showSelected();
    void saveCertificate();
    [[nodiscard]] const CalibrationRecord* selected() const;

    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
