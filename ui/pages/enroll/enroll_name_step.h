// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/enrollment_draft.h"

#include <QFrame>
#include <QScrollArea>

#include <optional>
#include <vector>

class QLabel;
class QLineEdit;
class QPushButton;
class QVBoxLayout;

namespace gripscope {

class EnrollPictureField;
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

/// A card of readable width in the middle of a step that is a form; its column.
[[nodiscard]] QVBoxLayout* makeFormCard(QWidget* step);

/// The first step of an enrolment: what was begun before, or a new name, with a picture of the part. A name
/// is suggested, so that a type can be enrolled without typing.
class EnrollNameStep : public QScrollArea {
    Q_OBJECT
public:
    explicit EnrollNameStep(Workbench& workbench, QWidget* parent = nullptr);
    void begin();   ///< a new enrolment: suggests a name
    void refresh(); ///< the types may be others
    void submit();
    void focusField();
    [[nodiscard]] EnrollDrafts& drafts() { return *m_drafts; }

signals:
    void named(const QString& name);
    void goOn(const QString& name);

private:
    QWidget* makeForm(QWidget* parent);
    [[nodiscard]] QString suggestion() const;
    Workbench* m_workbench;
    EnrollDrafts* m_drafts;
    EnrollPictureField* m_picture;
    QLineEdit* m_name;
    QLabel* m_hint;
    QPushButton* m_next;
    QString m_suggested; ///< stands in the field, unless another name was typed
};

} // namespace gripscope
