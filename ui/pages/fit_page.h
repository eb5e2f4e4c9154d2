// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/pages/page.h"

#include <memory>

namespace gripscope {

/// One squeeze in full: measured against model, residuals and their tests, the estimate and its checks.
class FitPage : public Page {
    Q_OBJECT
public:
    explicit FitPage(Workbench& workbench, QWidget* parent = nullptr);
    ~FitPage() override;

    [[nodiscard]] QString id() const override;
    [[nodiscard]] QString title() const override;
    [[nodiscard]] QString iconName() const override;

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
