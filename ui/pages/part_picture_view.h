// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/enrollment_draft.h"

#include <QPixmap>
#include <QWidget>

#include <optional>

namespace gripscope {

class Workbench;

/// The picture of a part in a square; without one, a frame that says so, or nothing at all.
class PartPictureView : public QWidget {
    Q_OBJECT
public:
    enum class Empty { Frame, Hidden };
    PartPictureView(Workbench& workbench, int side, Empty empty, QWidget* parent = nullptr);
    void setPicture(const std::optional<PartPicture>& picture);
    [[nodiscard]] bool hasPicture() const { return !m_pixmap.isNull(); }
    [[nodiscard]] QSize sizeHint() const override { return {m_side, m_side}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    Workbench* m_workbench;
    int m_side;
    Empty m_empty;
    std::optional<PartPicture> m_picture;
    QPixmap m_pixmap;
};

} // namespace gripscope
