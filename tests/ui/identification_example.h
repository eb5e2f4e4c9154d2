// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"
#include "ui/pages/fit/fit_page_squeezes.h"

namespace gripscope::test {

/// Can A in SI.
inline constexpr MassDampingStiffness canA{0.0396, 43.0, 9990};

/// A simulated squeeze of can A, identified by output error and the ARX models.
inline Identification identifiedCanA()
{
    IdentificationOptions options;
    options.estimators = {Estimator::Arx, Estimator::OutputError, Estimator::Arx221};
    return identify(simulatedSqueeze(canA, 1), options);
}

} // namespace gripscope::test
