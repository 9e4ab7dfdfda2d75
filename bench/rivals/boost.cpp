// Boost.Math: jacobi_elliptic and ellint_1 take the modulus k; errors give NaN instead of exceptions. Its own dn keeps
// few digits next to a turning point, so dn is formed from its cn, which costs one square root. Without
// promotion to long double it takes an eighth of the time and loses a factor of three to five: the faster way is run.
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <boost/version.hpp>

namespace policies = boost::math::policies;
static const policies::policy<
    policies::domain_error<policies::ignore_error>, policies::overflow_error<policies::ignore_error>,
    policies::pole_error<policies::ignore_error>, policies::evaluation_error<policies::ignore_error>,
    policies::promote_double<false>>
    quiet;

static inline void jacobi(double u, double k, double &sn, double &cn, double &dn) {
    sn = boost::math::jacobi_elliptic(k, u, &cn, &dn, quiet);
    dn = std::sqrt((1 - k) * (1 + k) + k * k * cn * cn);
}
static inline double first_kind(double phi, double k) { return boost::math::ellint_1(k, phi, quiet); }
static inline double complete_k(double k) { return boost::math::ellint_1(k, quiet); }

#include "jacobi.hpp"

extern "C" const char *version() { return BOOST_LIB_VERSION; }
