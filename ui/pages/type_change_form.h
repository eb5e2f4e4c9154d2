// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/library.h"

#include <QDialog>

class QComboBox;
class QLineEdit;
class QListWidget;
class QPushButton;
class QVBoxLayout;

namespace gripscope {

/// Asks before the types of a library are changed: says what will happen, asks for what is needed and why.
/// It can be accepted once all of that is there.
class TypeChangeForm : public QDialog {
    Q_OBJECT
public:
    /// `verb`: what the button says.
    TypeChangeForm(const QString& title, const QString& consequence, const QString& verb, QWidget* parent);
    void askName(const QString& label, const QString& initial = {});
    void askCode(const QString& label, const QString& initial); ///< may be left empty
    void askType(const QString& label, const QStringList& names);
    /// The accepted ones, some to be ticked; not all can be.
    void askSqueezes(const QString& label, const std::vector<GraspRecord>& grasps);

    [[nodiscard]] QString name() const;
    [[nodiscard]] QString code() const;
    [[nodiscard]] QString type() const;
    [[nodiscard]] QStringList squeezes() const; ///< keys of those that are ticked
    [[nodiscard]] QString reason() const;

private:
    void refresh();
    void addField(const QString& label, QWidget* field);
    QVBoxLayout* m_fields;
    QLineEdit *m_name = nullptr, *m_code = nullptr;
    QComboBox* m_type = nullptr;
    QListWidget* m_squeezes = nullptr;
    QLineEdit* m_reason;
    QPushButton* m_accept;
};

} // namespace gripscope
