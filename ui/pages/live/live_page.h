// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/pages/page.h"

#include <memory>

namespace gripscope {

/// Force and position as they come, over 2 s to 10 min, with the link at a glance; held, to be measured in;
/// and a trial squeeze whose result opens on the Fit page.
class LivePage : public Page {
    Q_OBJECT
public:
    explicit LivePage(Workbench& workbench, QWidget* parent = nullptr);
    ~LivePage() override;

    [[nodiscard]] QString id() const override;
    [[nodiscard]] QString title() const override;
    [[nodiscard]] QString iconName() const override;
    void setActive(bool active) override;
    void prepareTour() override;
    [[nodiscard]] bool tourReady() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void buildToolbar(class QBoxLayout* row);
    void addSpans(QBoxLayout* row);
    void buildHint(QBoxLayout* column);
    void buildCharts(QBoxLayout* column);
    void buildPause(QBoxLayout* column);
    void makeShortcuts();
    void refresh();
    void refreshNumbers();
    void refreshControls();
    void setHeld(bool on);
    void setTared(bool on);
    void dropMarker();
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
