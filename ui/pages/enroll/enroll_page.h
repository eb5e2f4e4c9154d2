// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/enroll/enroll_session.h"
#include "ui/pages/page.h"

#include <memory>

namespace gripscope {

/// A new type in five steps: name, recipe, squeezes, review, approval. A name that the library knows is gone
/// on with. Enter continues on forms, Space squeezes; what was done can be undone, left and gone on with.
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
    QLayout* makeTop();
    QWidget* makeRecipeStep();
    QWidget* makeDoneStep();
    void refresh();
    void refreshUndo();
    [[nodiscard]] QString inWords(const EnrollSession::Act& act) const;
    void showRecipe();
    void submitName(const QString& name);
    void submitRecipe();
    void undo();
    /// With a supervisor's consent where undoing or redoing this needs it.
    void supervised(const std::optional<EnrollSession::Act>& act, std::function<void()> then);
    void redo();
    void startAnew(); ///< what was begun stays as a draft
    void tell(const Expected<void>& done);
    void focusStep();
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
