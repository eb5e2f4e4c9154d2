// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/enrollment_draft.h"

#include <QFrame>

#include <optional>
#include <vector>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace gripscope {

class Workbench;

/// The enrolments that were begun and not finished: each can be gone on with or discarded, and a discarded
/// one brought back. Hidden where there is none.
class EnrollDrafts : public QFrame {
    Q_OBJECT
public:
    explicit EnrollDrafts(Workbench& workbench, QWidget* parent = nullptr);
    void load();
    [[nodiscard]] QStringList names() const;
    /// Whether undo() would bring one back.
    [[nodiscard]] bool canBringBack() const { return m_discarded.has_value(); }
    void bringBack();

signals:
    void goOn(const QString& name);
    void changed();

private:
    void show(std::vector<EnrollmentDraft> drafts);
    using QFrame::show;
    QWidget* makeRow(const EnrollmentDraft& draft);
    void discard(const EnrollmentDraft& draft);
    Workbench* m_workbench;
    std::vector<EnrollmentDraft> m_drafts;
    std::optional<EnrollmentDraft> m_discarded; ///< the last one
    QWidget* m_rows;
    QWidget* m_undone;
    QLabel* m_undoneWords;
};

/// "4 of 10 squeezes, one to decide. Left by Mai at 10:12."
[[nodiscard]] QString inWords(const EnrollmentDraft& draft);

} // namespace gripscope
