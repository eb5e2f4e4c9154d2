// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/library/records/enrollment_draft.h"

#include <QImage>
#include <QPixmap>
#include <QWidget>

#include <optional>

namespace gripscope {

class Workbench;

/// Enough to tell parts apart on any screen, and small beside a recording.
inline constexpr int largestPictureSide = 1024;

/// A PNG or JPEG file, turned as its camera says and made smaller where it is larger than
/// largestPictureSide. FileUnreadable, with the reason: no such file, neither of the two, damaged, too large.
/// Takes up to a second with a large photograph: for the pool.
[[nodiscard]] Expected<PartPicture> readPartPicture(const QString& file);
/// The same of a picture from the clipboard. Usage when there is none.
[[nodiscard]] Expected<PartPicture> toPartPicture(const QImage& image);

/// At most `side` wide and high; a null image where it cannot be read. For the pool, too.
[[nodiscard]] QImage shownPicture(const PartPicture& picture, int side);

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
