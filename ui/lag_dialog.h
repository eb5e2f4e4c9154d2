// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include <memory>

namespace gripscope {

class Workbench;

/// Measures the lag between a gripper's channels with the person in front of it: what to grip, arming, the
/// squeezes as they come, the result, and whether to use it.
class LagDialog : public QDialog {
    Q_OBJECT
public:
    explicit LagDialog(Workbench& workbench, QWidget* parent = nullptr);
    ~LagDialog() override;

protected:
    void done(int result) override;

private:
    void build();
    [[nodiscard]] QString found() const;
    [[nodiscard]] QString outcome() const;

    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
