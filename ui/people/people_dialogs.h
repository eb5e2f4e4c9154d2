// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/audit/audit_trail.h"
#include "core/library/library.h"
#include "core/people/audit_entry.h"
#include "core/people/person.h"
#include "core/people/secret.h"
#include "ui/context/sign_in.h"
#include "ui/models/row_table_model.h"
#include "ui/windows/dialog.h"

#include <QByteArray>
#include <QTimer>

#include <vector>

class QComboBox;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableView;
class QTableWidget;
class QVBoxLayout;

namespace gripscope {

class Library;
class Workbench;

/// Asks for a new person, or for a new PIN or password of one who is there. Stays open with what was typed,
/// but for the secret, until told that it is done.
class PersonForm : public Dialog {
    Q_OBJECT
public:
    /// `first`: nobody is there yet, and this one will be a supervisor.
    static PersonForm* forNew(bool first, QWidget* parent);
    static PersonForm* forSecret(const Person& person, QWidget* parent);

    [[nodiscard]] QString name() const;
    [[nodiscard]] Role role() const;
    /// Once; the fields are empty then.
    [[nodiscard]] Secret takeSecret();
    void showProblem(const QString& problem);

signals:
    void asked(); ///< what was typed makes sense so far

private:
    PersonForm(const QString& title, const QString& words, const QString& verb, QWidget* parent);
    void addField(const QString& label, QWidget* field);
    void addSecrets();
    void check();
    QVBoxLayout* m_fields;
    QLineEdit* m_name = nullptr;
    QComboBox* m_role = nullptr;
    QLineEdit *m_secret = nullptr, *m_again = nullptr;
    QLabel* m_state;
    QPushButton* m_accept;
};

/// Who is in the library, and what they may; people are added, given another role or a new PIN or password,
/// and deactivated, never deleted. And who of them may arm the gripper.
class PeopleDialog : public Dialog {
    Q_OBJECT
public:
    explicit PeopleDialog(Workbench& workbench, QWidget* parent = nullptr);

private:
    using Change = std::function<Expected<void>(Library&)>;
    QPushButton* addAction(QVBoxLayout* column, const QString& text, const char* name,
                           void (PeopleDialog::*action)());
    void showPeople();
    void refresh();
    [[nodiscard]] const Person* selected() const;
    /// On the library's thread, with a supervisor's consent where that is needed; closes `form` when it is
    /// done.
    void change(Change work, PersonForm* form = nullptr);
    /// The same, after a reason was given for it.
    void changeBecause(const QString& title,
                       std::function<Expected<void>(Library&, const QString& reason)> work);
    void add();
    void changeRole();
    void changeSecret();
    void changeActive();
    void changeArming();
    void changeApproval();
    /// A policy to choose: its caption before it.
    [[nodiscard]] QHBoxLayout* makePolicyRow(const QString& caption, QComboBox* choice,
                                             void (PeopleDialog::*change)());
    [[nodiscard]] QHBoxLayout* makeArmingRow();
    [[nodiscard]] QHBoxLayout* makeApprovalRow();

    Workbench* m_workbench;
    std::vector<Person> m_shown;
    QTableWidget* m_table;
    QLabel *m_intro, *m_state;
    QComboBox* m_arming;   ///< who may arm the gripper
    QComboBox* m_approval; ///< who may approve a type
    QPushButton *m_add, *m_role, *m_secret, *m_active;
};

/// The audit trail, newest first, page by page: the view asks for more as it is scrolled, the owner fetches
/// each page away from the screen's thread and appends it.
class AuditModel : public RowTableModel {
    Q_OBJECT
public:
    enum class Column { Number, Time, Person, Action, Subject, Reason, Details, Station };
    static constexpr int columns = 8;
    static constexpr int pageSize = 200;

    using RowTableModel::RowTableModel;

    /// Starts anew with a list of `total` rows, of which `page` are the first.
    void restart(qint64 total, std::vector<AuditEntry> page);
    /// The page that was asked for at `offset`; ignored when that is no longer where the list ends. An empty
    /// one ends the list.
    void append(int offset, const std::vector<AuditEntry>& page);
    [[nodiscard]] const AuditEntry& entry(int row) const { return m_rows[static_cast<std::size_t>(row)]; }
    [[nodiscard]] qint64 total() const { return m_total; }

    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    [[nodiscard]] bool canFetchMore(const QModelIndex& parent) const override;
    void fetchMore(const QModelIndex& parent) override;

signals:
    void pageAsked(int offset);

private:
    [[nodiscard]] int length() const override { return static_cast<int>(m_rows.size()); }
    [[nodiscard]] int width() const override { return columns; }
    [[nodiscard]] QVariant head(int section, int role) const override;

    [[nodiscard]] static QString text(const AuditEntry& entry, Column column);
    std::vector<AuditEntry> m_rows;
    qint64 m_total = 0;
    bool m_waiting = false;
};

/// UTF-8 with a header line, oldest first, every field as it was hashed, so that the chain can be checked
/// from the file alone.
[[nodiscard]] QByteArray toCsv(const std::vector<AuditEntry>& entries);
/// All entries, whatever is filtered on the screen: a part would be no chain.
[[nodiscard]] Expected<QByteArray> auditCsv(Library& library);

/// Who did what, when and why: filtered, exported, and verified.
class AuditDialog : public Dialog {
    Q_OBJECT
public:
    explicit AuditDialog(Workbench& workbench, QWidget* parent = nullptr);
    void exportTo(const QString& file);

private:
    QWidget* makeBar();
    void makeTable();
    [[nodiscard]] AuditFilter filter(int offset = 0) const;
    void reload();
    void fetch(int offset);
    void verify();
    void chooseExport();

    Workbench* m_workbench;
    AuditModel* m_model;
    QTableView* m_table;
    QLineEdit* m_text;
    QComboBox* m_action;
    QPushButton* m_verify;
    QLabel *m_counts, *m_result;
    QTimer m_typing; ///< a filter is applied once a person stops typing
    int m_generation = 0;
};

} // namespace gripscope
