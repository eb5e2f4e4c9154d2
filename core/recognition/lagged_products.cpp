// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/lagged_products.h"

namespace gripscope {

LaggedProducts::LaggedProducts(Eigen::Index columns)
    : m_same(Matrix::Zero(columns, columns)), m_next(m_same), m_ends(m_same), m_last(Row::Zero(columns))
{
}

void LaggedProducts::add(Eigen::Index time, const Eigen::Ref<const Eigen::RowVectorXd>& row)
{
    if (m_rows > 0 && time == m_lastTime + 1) {
        m_next.noalias() += row.transpose() * m_last;
    } else {
        if (m_rows > 0)
            m_ends.noalias() += m_last.transpose() * m_last;
        m_ends.noalias() += row.transpose() * row;
        ++m_stretches;
    }
    m_same.noalias() += row.transpose() * row;
    m_last = row;
    m_lastTime = time;
    ++m_rows;
}

LaggedProducts::Matrix LaggedProducts::whitened(double pole) const
{
    const Matrix ends = m_ends + m_last.transpose() * m_last;
    const double square = pole * pole;
    return (1 + square) * m_same - square * ends - pole * (m_next + m_next.transpose());
}

} // namespace gripscope
