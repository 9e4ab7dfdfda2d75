// The motion of a pendulum (omega0 = 1) by a library's Jacobi functions, one sample after the other, as a C or C++ user
// writes it: starting phase from the incomplete integral, then theta = 2 atan2(k sn, dn) or 2 am, in double throughout.
// A library gives jacobi(u, k, sn, cn, dn), first_kind(phi, k) and complete_k(k), all of the modulus k.
#include <cmath>

struct Phase {
    double k, modulus, u0, sign, quarter;
};

static inline Phase phase(double theta0, double velocity0) {
    const double turn = 6.283185307179586, angle = theta0 - turn * std::round(theta0 / turn);
    const double s = std::sin(angle / 2), half = velocity0 / 2, k = std::hypot(s, half);
    if (k <= 1) return {k, k, first_kind(std::atan2(s, half), k), 1, 0};
    const double sign = std::copysign(1.0, velocity0);
    return {k, 1 / k, sign * first_kind(angle / 2, 1 / k), sign, complete_k(1 / k)};
}

static inline void sample(const Phase &p, double theta0, double t, double *theta, double *velocity) {
    const double pi = 3.141592653589793, turns = 2 * pi * std::round(theta0 / (2 * pi));
    double sn, cn, dn;
    if (p.k <= 1) {
        jacobi(p.u0 + t, p.modulus, sn, cn, dn);
        *theta = turns + 2 * std::atan2(p.k * sn, dn);
        *velocity = 2 * p.k * cn;
        return;
    }
    const double u = p.u0 + p.k * t;
    jacobi(u, p.modulus, sn, cn, dn);
    const double rest = std::atan2(sn, cn);
    const double am = rest + 2 * pi * std::round((pi * u / (2 * p.quarter) - rest) / (2 * pi));
    *theta = turns + 2 * p.sign * am;
    *velocity = 2 * p.sign * p.k * dn;
}

extern "C" void one_orbit(long n, double theta0, double velocity0, const double *t, double *theta, double *velocity) {
    const Phase p = phase(theta0, velocity0);
    for (long i = 0; i < n; i++) sample(p, theta0, t[i], theta + i, velocity + i);
}

extern "C" void own_states(
    long n, const double *theta0, const double *velocity0, const double *t, double *theta, double *velocity) {
    for (long i = 0; i < n; i++) sample(phase(theta0[i], velocity0[i]), theta0[i], t[i], theta + i, velocity + i);
}
