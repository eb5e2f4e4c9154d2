// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/display_units.h"

#include <QLineEdit>

#include <optional>
#include <vector>

namespace gripscope {

/// A field for several numbers with commas between. As with QuantityBox, the program keeps them in SI, and
/// what nobody has typed comes out as it went in.
class QuantityListEdit : public QLineEdit {
    Q_OBJECT
public:
    explicit QuantityListEdit(QWidget* parent = nullptr);
    /// In which numbers are typed from here on; what stands there means nothing any more.
    void setUnit(const ShownUnit& unit);
    /// Nothing where something else than numbers is typed.
    [[nodiscard]] std::optional<std::vector<double>> si() const;
    void setSi(const std::vector<double>& numbers);

private:
    double m_factor = 1;
    std::optional<std::vector<double>> m_si; ///< as set; nothing once it was typed over
    bool m_setting = false;
};

} // namespace gripscope
