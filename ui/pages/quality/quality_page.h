// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/quality/study_session.h"
#include "ui/pages/page.h"

#include <memory>

namespace gripscope {

/// Studies of how well the gripper measures: the list of them, a form for a new one, the view that leads
/// through its squeezes, and what it says in the end; and the charts of a process. What counts is what the
/// library has: a study goes on after a pause, another page, or the end of the program.
class QualityPage : public Page {
    Q_OBJECT
public:
    explicit QualityPage(Workbench& workbench, QWidget* parent = nullptr);
    ~QualityPage() override;

    [[nodiscard]] QString id() const override;
    [[nodiscard]] QString title() const override;
    [[nodiscard]] QString iconName() const override;
    void setActive(bool active) override;
    void prepareTour() override;
    [[nodiscard]] bool tourReady() const override;

signals:
    void squeezeAsked(const QString& graspId); ///< an inspection, to be shown in the history

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    enum class View { List, Form, Lead, Outcome, Drift, Transfer, Process };
    void show(View view);
    void follow(); ///< the session
    void beginForm(StudyKind kind);
    void begin(const StudyRequest& request);
    void open(const QString& studyId);
    void showStudy(); ///< that the session has, in its view
    void leaveStudy();
    void tell(const Expected<void>& done);
    void focusView();
    [[nodiscard]] QString suggestedName(StudyKind kind) const;
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
