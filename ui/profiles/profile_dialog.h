// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/windows/dialog.h"

#include <memory>

namespace gripscope {

class Workbench;

/// Where a profile for another maker's gripper is written: on the left the bytes of its reports as they come,
/// on the right what they are taken for, and what that says just now. Listens only, beside any connection.
class ProfileDialog : public Dialog {
    Q_OBJECT
public:
    explicit ProfileDialog(Workbench& workbench, QWidget* parent = nullptr);
    ~ProfileDialog() override;

    /// Listens at `address`, and takes the profile that is known for it.
    void listen(const QString& address);

private:
    void build();
    [[nodiscard]] QWidget* buildBytes();
    [[nodiscard]] QWidget* buildProfile();
    void connectEditors();
    void refresh();
    void takeEdit();
    void load();
    void save();

    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
