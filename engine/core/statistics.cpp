#include "engine/core/statistics.h"

#include <boost/math/distributions/students_t.hpp>

namespace lathelier {

double median(std::vector<double> values)
{
    return medianInPlace(values);
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
