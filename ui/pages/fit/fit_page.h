// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"
#include "ui/pages/page.h"

#include <memory>

namespace gripscope {

struct FitSubject;

/// One squeeze in full: measured against model, residuals and their tests, the estimate and its checks.
class FitPage : public Page {
    Q_OBJECT
public:
    explicit FitPage(Workbench& workbench, QWidget* parent = nullptr);
    ~FitPage() override;

    [[nodiscard]] QString id() const override;
    [[nodiscard]] QString title() const override;
    [[nodiscard]] QString iconName() const override;
    void setActive(bool active) override;
    void prepareTour() override;
    [[nodiscard]] bool tourReady() const override;

    /// Reads a recording (CSV) and identifies it, in the pool; errors go to the message bar.
    void openRecording(const QString& file);

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    [[nodiscard]] QWidget* buildBar();
    [[nodiscard]] QWidget* buildEmpty();
    void prepareExport();
    void prepareValidation();
    void chooseFile();
    void copyNumbers();
    void takeSubject();
    void runAllEstimators();
    void showSubject();
    void showPlots(Estimator estimator);
    void takeTourSqueeze();

    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
