#include "engine/core/statistics.h"

#include <boost/math/distributions/students_t.hpp>

namespace lathelier {

double median(std::vector<double> values)
{
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) return *middle;
    return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

double studentQuantile(double probability, std::int64_t degrees_of_freedom)
{
    if (degrees_of_freedom < 1) return std::numeric_limits<double>::quiet_NaN();
    // In double precision: long double takes ten times as long without visible effect.
    using Plain = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
    const boost::math::students_t_distribution<double, Plain> student(static_cast<double>(degrees_of_freedom));
    return quantile(student, probability);
}

}  // namespace lathelier
