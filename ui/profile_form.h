// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/profile_field_row.h"

#include <QWidget>

namespace gripscope {

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

} // namespace gripscope
