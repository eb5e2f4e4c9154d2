// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/pages/page.h"

#include <memory>

namespace gripscope {

class SceneView;

/// The enrolled types in the space of m, b and k, and how K-means finds them without labels.
class TypesPage : public Page {
    Q_OBJECT
public:
    explicit TypesPage(Workbench& workbench, QWidget* parent = nullptr);
    ~TypesPage() override;

    [[nodiscard]] QString id() const override;
    [[nodiscard]] QString title() const override;
    [[nodiscard]] QString iconName() const override;
    void setActive(bool active) override;
    void prepareTour() override;
    [[nodiscard]] bool tourReady() const override;

    [[nodiscard]] SceneView* view() const;
    /// The paper's tables instead of the library, or back.
    void showPaper(bool paper);
    /// The K-means iteration shown; from then on points are coloured by cluster.
    void showStep(int step);
    [[nodiscard]] int stepCount() const;

private:
    [[nodiscard]] QWidget* buildSceneCard();
    [[nodiscard]] QWidget* buildEmpty();
    void load();
    void cluster();
    void takeInspection();
    void refresh();
    void loadExamples();
    void openPicked();

    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
