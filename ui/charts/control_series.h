// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/process/process_session.h"
#include "ui/format/shown_unit.h"

#include <QCoreApplication>

namespace gripscope {

/// One chart of a process as it is painted: m, b or k, their ranges or deviations, or T^2.
struct ControlPanel {
    enum class What { Location, Spread, Joint };
    What what = What::Location;
    std::size_t quantity = 2; ///< of m, b, k
    friend bool operator==(const ControlPanel&, const ControlPanel&) = default;
};

/// The numbers behind it, point by point, in the unit that they are shown in. Of a picture that outlives it.
class ControlSeries {
    Q_DECLARE_TR_FUNCTIONS(ControlSeries)
public:
    ControlSeries(const ProcessPicture& picture, const ControlPanel& panel);

    [[nodiscard]] std::size_t points() const { return m_points; }        ///< 0: there is no such chart
    [[nodiscard]] std::optional<double> value(std::size_t point) const;  ///< of a CUSUM the upper sum
    [[nodiscard]] std::optional<double> second(std::size_t point) const; ///< CUSUM: the lower sum, below zero
    [[nodiscard]] double lower(std::size_t point) const;
    [[nodiscard]] double upper(std::size_t point) const;
    [[nodiscard]] bool signal(std::size_t point) const;
    [[nodiscard]] double centre() const { return m_centre; }
    [[nodiscard]] std::uint32_t
    row(std::size_t point) const;                         ///< place in the values, the last of its subgroup
    [[nodiscard]] qint64 number(std::size_t point) const; ///< of that inspection
    /// The same limits at each point, but for few at the ends.
    [[nodiscard]] bool limitsAreLevel() const;

    [[nodiscard]] QString title() const; ///< "Stiffness k (kN/m)", "Moving range of k (kN/m)"
    [[nodiscard]] const ShownUnit& unit() const { return m_unit; }
    /// Smallest and largest of what stands from `first` on, before `last`; and whether a point signals there.
    struct Span {
        double low = 0, high = 0;
        bool signal = false, any = false;
    };
    [[nodiscard]] Span span(std::size_t first, std::size_t last) const;

    /// Of a quantity of these values, as everything about it is shown.
    [[nodiscard]] static ShownUnit unitOf(const ProcessValues& values, std::size_t quantity, double largest);

private:
    [[nodiscard]] const ChartPoint* point(std::size_t place) const;
    void addPoint(Span& span, std::size_t point) const;
    void addBlock(Span& span, const PointBlock& block) const;

    const ProcessPicture* m_picture;
    ControlPanel m_panel;
    const QuantityChart* m_chart = nullptr;
    const JointChart* m_joint = nullptr;
    std::size_t m_points = 0;
    ShownUnit m_unit;
    double m_centre = 0;
    bool m_sums = false;
};

} // namespace gripscope
