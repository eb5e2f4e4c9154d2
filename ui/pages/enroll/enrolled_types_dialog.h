// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/library.h"
#include "core/people/permission.h"
#include "ui/windows/dialog.h"

#include <QImage>

#include <functional>

class QBoxLayout;
class QComboBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QTableWidget;
class QVBoxLayout;

namespace gripscope {

class TypeChangeForm;
class Workbench;

/// The types of the library with what can be done to them, and its versions, any of which can be restored.
class EnrolledTypesDialog : public Dialog {
    Q_OBJECT
public:
    explicit EnrolledTypesDialog(Workbench& workbench, QWidget* parent = nullptr);

private:
    /// What the lists show, read on the library's thread.
    struct Contents {
        std::vector<TypeRecord> types; ///< those in use, then the retired
        std::vector<QImage> pictures;  ///< one a type, small; a null image where it has none
        std::vector<LibraryChange> changes;
        qint64 version = 0;
    };
    using Change = std::function<Expected<void>(Library&)>;

    QWidget* makeTypes();
    QWidget* makeVersions();
    QPushButton* addAction(QBoxLayout* column, const QString& text, const char* name,
                           void (EnrolledTypesDialog::*action)());
    [[nodiscard]] static Expected<Contents> read(Library& library, int pictureSide);
    void load();
    void show(Contents contents);
    void refresh();
    void change(Change work); ///< on the library's thread; then everything is read again
    /// The same with a supervisor\'s consent where that is needed.
    void changeSupervised(Change work, Permission permission = Permission::ChangeTypes);
    [[nodiscard]] const TypeRecord* selectedType() const;
    [[nodiscard]] const LibraryChange* selectedVersion() const;
    [[nodiscard]] ChangeNote note(const TypeChangeForm& form) const;
    void choosePicture();
    void rename();
    void editCode();
    void editLimits();
    void merge();
    void split();
    void approve();
    void retire();
    void putBack();
    void restoreSelected();
    void undo();
    void restore(qint64 version);

    Workbench* m_workbench;
    Contents m_contents;
    QTableWidget *m_types, *m_versions;
    QPushButton *m_picture, *m_rename, *m_code, *m_limits, *m_merge, *m_split, *m_approve, *m_retire,
        *m_putBack, *m_restore, *m_undo;
    QLabel* m_state;
};

/// Asks before the types of a library are changed: says what will happen, asks for what is needed and why.
/// It can be accepted once all of that is there.
class TypeChangeForm : public Dialog {
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
