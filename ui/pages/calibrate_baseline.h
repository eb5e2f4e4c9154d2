// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <memory>

namespace gripscope {

class Workbench;

/// The empty gripper: its own m, b, k are measured on squeezes of nothing and taken off those of the parts.
class CalibrateBaseline : public QWidget {
    Q_OBJECT
public:
    explicit CalibrateBaseline(Workbench& workbench, QWidget* parent = nullptr);
    ~CalibrateBaseline() override;

    void act(); ///< what Space does
    void leave();

private:
    QWidget* makeMeasuring();
    QWidget* makeInUse();
    void showInUse();
    void remove();
    [[nodiscard]] QString found() const;
    [[nodiscard]] QString outcome() const;

    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
