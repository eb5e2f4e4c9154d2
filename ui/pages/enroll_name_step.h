// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QScrollArea>

class QLabel;
class QLineEdit;
class QPushButton;
class QVBoxLayout;

namespace gripscope {

class EnrollDrafts;
class EnrollPictureField;
class Workbench;

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
