// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/early_stop.h"

namespace gripscope {

/// The verdict on a squeeze that ended early, from the verdict on its record (judge()) and the decision that
/// ended it. Where the two agree it stands, and says when it was decided. Where they do not, the part is
/// neither: Inconclusive, and both answers are said. A measurement that is not valid stays that.
/// `decided_s`: from the start of the movement to the last sample the decision knew.
[[nodiscard]] Verdict verdictOnEarlyEnd(Verdict verdict, const EarlyEnd& end, double decided_s);

/// "A after 0.12 s, posterior 0.9996": for the record's provenance.
[[nodiscard]] QString inWords(const EarlyEnd& end, double decided_s);

} // namespace gripscope
