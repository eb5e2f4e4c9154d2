// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/type_space.h"
#include "ui/pages/page.h"

#include <memory>

namespace gripscope {

class ClustersPanel;
class SceneView;
struct SpaceClustering;

/// The enrolled types in the space of m, b and k, and how they are found without labels.
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
    /// The iteration of the clustering that is shown; from then on points are coloured by cluster.
    void showStep(int step);
    [[nodiscard]] int stepCount() const; ///< 0 while there is no clustering
    [[nodiscard]] ClustersPanel* clusters() const;

private:
    [[nodiscard]] QWidget* buildSceneCard();
    [[nodiscard]] QWidget* buildEmpty();
    void refreshEmpty();
    void load();
    void takeSpace(TypeSpace space);
    void cluster();
    void takeClustering(std::optional<SpaceClustering> clustering, const QString& words);
    void advise();
    void dropAdvice();
    void takeInspection();
    void refresh();
    void takePick(const QString& id);
    [[nodiscard]] QString tipOf(const QString& id) const;
    void openPicked();

    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
