// GSL: gsl_sf_elljac_e takes the parameter m, gsl_sf_ellint_F and _Kcomp the modulus k.
#include <gsl/gsl_errno.h>
#include <gsl/gsl_sf_elljac.h>
#include <gsl/gsl_sf_ellint.h>
#include <gsl/gsl_version.h>

static inline void jacobi(double u, double k, double &sn, double &cn, double &dn) {
    gsl_sf_elljac_e(u, k * k, &sn, &cn, &dn);
}
static inline double first_kind(double phi, double k) { return gsl_sf_ellint_F(phi, k, GSL_PREC_DOUBLE); }
static inline double complete_k(double k) { return gsl_sf_ellint_Kcomp(k, GSL_PREC_DOUBLE); }

#include "jacobi.hpp"

extern "C" const char *version() {
    gsl_set_error_handler_off();
    return GSL_VERSION;
}
