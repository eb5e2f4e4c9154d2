// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/pages/page.h"

#include <memory>

class QBoxLayout;

namespace gripscope {

/// One part after another: squeeze, and read the verdict from 3 m. Space squeezes.
class InspectPage : public Page {
    Q_OBJECT
public:
    explicit InspectPage(Workbench& workbench, QWidget* parent = nullptr);
    ~InspectPage() override;

    [[nodiscard]] QString id() const override;
    [[nodiscard]] QString title() const override;
    [[nodiscard]] QString iconName() const override;
    void setActive(bool active) override;
    void prepareTour() override;
    [[nodiscard]] bool tourReady() const override;

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void buildTop(QBoxLayout* column);
    void buildVerdict(QBoxLayout* column);
    void buildActions(QBoxLayout* column);
    void squeeze();
    void refresh();
    void refreshExpected();
    void refreshActions();
    void refreshVerdict();
    void showHint();
    void showFacts();
    void refreshRates();
    void editRates();
    [[nodiscard]] QString timeText() const; ///< how long a squeeze takes
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
