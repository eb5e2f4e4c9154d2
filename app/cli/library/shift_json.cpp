// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/library/shift_json.h"

#include "core/base/json_value.h"
#include "core/math/matrix_json.h"

namespace gripscope::cli {

using namespace Qt::StringLiterals;

QJsonObject vectorJson(const Eigen::Vector3d& values)
{
    return {
        {u"m"_qs, jsonNumber(values(0))}, {u"b"_qs, jsonNumber(values(1))}, {u"k"_qs, jsonNumber(values(2))}};
}

QJsonObject shiftJson(const TypeShift& shift)
{
    return {{u"type"_qs, shift.type},
            {u"squeezes"_qs, shift.squeezes},
            {u"log"_qs, vectorJson(shift.log)},
            {u"standard_errors"_qs, vectorJson(shift.covariance.diagonal().cwiseSqrt())},
            {u"t_squared"_qs, jsonNumber(shift.tSquared)},
            {u"p"_qs, jsonNumber(shift.pValue)}};
}

QJsonObject commonShiftJson(const CommonShift& shift)
{
    return {{u"value"_qs, vectorJson(shift.value)},
            {u"standard_errors"_qs, vectorJson(shift.covariance.diagonal().cwiseSqrt())},
            {u"covariance"_qs, matrixJson(shift.covariance)},
            {u"p"_qs, jsonNumber(shift.pValue)},
            {u"agreement_p"_qs, jsonNumber(shift.agreement)}};
}

} // namespace gripscope::cli
