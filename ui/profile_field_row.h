// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/profile/gripper_profile.h"

#include <QObject>

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QSpinBox;

namespace gripscope {

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

} // namespace gripscope
