// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/pages/page.h"

#include <memory>

namespace gripscope {

/// Every inspection of the library, newest first.
class HistoryPage : public Page {
    Q_OBJECT
public:
    explicit HistoryPage(Workbench& workbench, QWidget* parent = nullptr);
    ~HistoryPage() override;

    [[nodiscard]] QString id() const override;
    [[nodiscard]] QString title() const override;
    [[nodiscard]] QString iconName() const override;

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
