// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/profile/gripper_profile.h"
#include "devices/profile/report_statistics.h"
#include "ui/models/row_table_model.h"
#include "ui/windows/dialog.h"

#include <QObject>
#include <QWidget>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QSpinBox;

namespace gripscope {

class Workbench;

/// The bytes of a gripper's reports, a row each: the last value, the range, how often it changes, and what it
/// belongs to by a profile. Bytes that move have a mark and stand in strong type; those of the field that is
/// chosen have an arrow and a tint.
class ByteTableModel : public RowTableModel {
    Q_OBJECT
public:
    enum class Column { Byte, Last, Least, Most, Changes, Field };
    explicit ByteTableModel(QObject* parent = nullptr) : RowTableModel(parent) {}

    void setBytes(const ReportStatistics& seen);
    void setProfile(const std::optional<GripperProfile>& profile);
    void setChosenField(const QString& name);

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

private:
    [[nodiscard]] int length() const override { return static_cast<int>(m_seen.bytes().size()); }
    [[nodiscard]] int width() const override { return static_cast<int>(Column::Field) + 1; }
    [[nodiscard]] QVariant head(int column, int role) const override;

    [[nodiscard]] QString text(std::size_t byte, Column column) const;
    [[nodiscard]] QString owners(std::size_t byte) const;
    [[nodiscard]] bool chosen(std::size_t byte) const;

    ReportStatistics m_seen;
    std::optional<GripperProfile> m_profile;
    QString m_chosen;
};

/// One field of a profile as a row of a form: where its bytes are, what they are, what they mean, and what
/// they say just now. What the row does not show (bits, ends of the range) stays as it was set.
class ProfileFieldRow : public QObject {
    Q_OBJECT
public:
    enum class Kind { Force, Position, Sequence, Time, Status };
    /// Puts the editors into row `row` of `grid`; they belong to `parent`.
    ProfileFieldRow(Kind kind, QGridLayout* grid, int row, QWidget* parent);

    [[nodiscard]] QString name() const; ///< as in the document: "force"
    void take(const GripperProfile& profile);
    void put(GripperProfile& profile) const;
    void setValue(const QString& text);

signals:
    void edited();
    void chosen(const QString& name); ///< a person went to it, by pointer or key

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void build(QGridLayout* grid, int row, QWidget* parent);
    void addEditor(QGridLayout* grid, QWidget* editor, int row, int column, int columns,
                   const QString& caption);
    void takeField(const ProfileField& field);
    [[nodiscard]] ProfileField field() const;
    [[nodiscard]] ProfileChannel channel() const;
    void showWhatApplies();

    Kind m_kind;
    ProfileField m_field;     ///< with what the row does not show
    ProfileChannel m_channel; ///< the same, for force and position
    QCheckBox* m_present = nullptr;
    QSpinBox* m_byte = nullptr;
    QComboBox *m_type = nullptr, *m_endian = nullptr, *m_unit = nullptr;
    QLineEdit *m_scale = nullptr, *m_offset = nullptr, *m_flags = nullptr;
    QLabel* m_value = nullptr;
    bool m_taking = false;
};

/// A profile as a form. What a person typed need not be a profile yet.
class ProfileForm : public QWidget {
    Q_OBJECT
public:
    explicit ProfileForm(QWidget* parent = nullptr);

    void setProfile(const GripperProfile& profile);
    /// As typed.
    [[nodiscard]] GripperProfile profile() const;
    /// What each field of `profile` says in the report; nothing without one, or where it is not one of it.
    void showValues(const std::optional<GripperProfile>& profile, const std::vector<std::uint8_t>& report);

signals:
    void edited();
    void fieldChosen(const QString& name);

private:
    void build();
    [[nodiscard]] QWidget* buildDevice();
    [[nodiscard]] QWidget* buildFields();

    GripperProfile m_profile; ///< with what the form does not show
    QLineEdit *m_name, *m_vendor, *m_product, *m_rate;
    QSpinBox *m_id, *m_length, *m_samples, *m_stride;
    QComboBox* m_hold;
    std::vector<ProfileFieldRow*> m_rows;
    bool m_taking = false;
};

/// Where a profile for another maker's gripper is written: on the left the bytes of its reports as they come,
/// on the right what they are taken for, and what that says just now. Listens only, beside any connection.
class ProfileDialog : public Dialog {
    Q_OBJECT
public:
    explicit ProfileDialog(Workbench& workbench, QWidget* parent = nullptr);
    ~ProfileDialog() override;

    /// Listens at `address`, and takes the profile that is known for it.
    void listen(const QString& address);

private:
    void build();
    [[nodiscard]] QWidget* buildBytes();
    [[nodiscard]] QWidget* buildProfile();
    void connectEditors();
    void refresh();
    void takeEdit();
    void load();
    void save();

    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
