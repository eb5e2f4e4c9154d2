// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/math/policies/policy.hpp>

namespace gripscope {

/// Boost.Math with errors as values, not exceptions, and in double precision throughout: by itself it
/// computes in long double for the last digit, which costs three times as long, and a verdict is mostly
/// quantiles.
using QuietPolicy = boost::math::policies::policy<
    boost::math::policies::overflow_error<boost::math::policies::ignore_error>,
    boost::math::policies::evaluation_error<boost::math::policies::ignore_error>,
    boost::math::policies::promote_double<false>>;

} // namespace gripscope
