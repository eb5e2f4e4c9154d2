// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/pages/page.h"

#include <memory>

namespace gripscope {

/// A new type in five steps: name, recipe, squeezes, review, approval. A name that the library knows is gone
/// on with.
class EnrollPage : public Page {
    Q_OBJECT
public:
    explicit EnrollPage(Workbench& workbench, QWidget* parent = nullptr);
    ~EnrollPage() override;

    [[nodiscard]] QString id() const override;
    [[nodiscard]] QString title() const override;
    [[nodiscard]] QString iconName() const override;
    void setActive(bool active) override;
    void prepareTour() override;
    [[nodiscard]] bool tourReady() const override;

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    QWidget* makeNameStep();
    QWidget* makeRecipeStep();
    QWidget* makeDoneStep();
    void refresh();
    void refreshNameHint();
    void submitName();
    void showRecipe(); ///< what the type of the name begins with
    void submitRecipe();
    void focusStep();
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
