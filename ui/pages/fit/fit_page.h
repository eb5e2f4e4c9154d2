// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"
#include "ui/pages/page.h"

#include <functional>
#include <memory>
#include <optional>

class QMenu;

namespace gripscope {

struct BodeContent;
struct EmpiricalResponse;
class WorkWatch;
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

    /// Reads recordings (CSV) and identifies them, in the pool; errors go to the message bar. The first is
    /// shown, the others are an arrow away.
    void openRecordings(const QStringList& files);

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    [[nodiscard]] QWidget* buildBar();
    [[nodiscard]] QWidget* buildEmpty();
    void buildBack();
    void showBack(); ///< where the squeeze was chosen on another page
    void prepareExport();
    void prepareValidation();
    void identifyOpened(const QString& name, const Recording& recording);
    /// Copies the numbers of `subject`, as it is then, in one of several forms, and tells `copied`
    /// (fit_page_numbers.cpp).
    [[nodiscard]] static QMenu* makeCopyMenu(QWidget* parent, std::function<const FitSubject&()> subject,
                                             std::function<void()> copied);
    void takeSubject();
    void runAllEstimators();
    /// By every estimator: the button cancels it from now on.
    [[nodiscard]] std::shared_ptr<WorkWatch> beginIdentifying();
    void stopIdentifying();
    [[nodiscard]] QString identifyingWords() const; ///< and how far
    void nameButton(const QString& words);          ///< that identifies, or stops that
    void showSubject();
    void showPlots(Estimator estimator);
    /// What the Bode plot of a squeeze shows: `measured`, and the model that `estimator` found, with the band
    /// of its own covariance. What both have in common (calibration, the empty gripper) is in neither
    /// interval (fit_page_bode.cpp).
    [[nodiscard]] static BodeContent bodeContent(const FitSubject& subject, Estimator estimator,
                                                 const std::optional<EmpiricalResponse>& measured);
    void measureResponse(); ///< in the pool
    void takeTourSqueeze();

    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
