// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/pages/page.h"

#include <memory>

namespace gripscope {

/// The enrolled types in the space of m, b and k, and how K-means finds them without labels.
class TypesPage : public Page {
    Q_OBJECT
public:
    explicit TypesPage(Workbench& workbench, QWidget* parent = nullptr);
    ~TypesPage() override;

    [[nodiscard]] QString id() const override;
    [[nodiscard]] QString title() const override;
    [[nodiscard]] QString iconName() const override;

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
