// Methods of integration, one motion a thread, behind the kernel of a system. Columns are `motions` long.

#if defined(__OPENCL_VERSION__)
#define LAGRANGE_KERNEL __kernel
#define LAGRANGE_GLOBAL __global
#define LAGRANGE_THREAD get_global_id(0)
#elif defined(__CUDACC__)
#ifdef __cplusplus
#define LAGRANGE_KERNEL extern "C" __global__
#else
#define LAGRANGE_KERNEL __global__
#endif
#define LAGRANGE_GLOBAL
#define LAGRANGE_THREAD (blockIdx.x * blockDim.x + threadIdx.x)
#endif

#define LAGRANGE_LENGTH (LAGRANGE_POSITIONS + LAGRANGE_VELOCITIES)

// What becomes of a motion, as `backend::work::Status` has it.
#define LAGRANGE_RUNNING 0u
#define LAGRANGE_DONE 1u
#define LAGRANGE_NOT_FINITE 2u
#define LAGRANGE_TOO_MANY_STEPS 3u
#define LAGRANGE_STEP_UNDERFLOW 4u

LAGRANGE_FUNCTION void lagrange_rhs(REAL t, const REAL *y, const REAL *p, REAL *rates)
{
    lagrange_position_rates(t, y, y + LAGRANGE_POSITIONS, p, rates);
    lagrange_acceleration(t, y, y + LAGRANGE_POSITIONS, p, rates + LAGRANGE_POSITIONS);
}

// A difference of infinities is not a number.
LAGRANGE_FUNCTION int lagrange_is_finite(const REAL *y)
{
    REAL sum = 0;
    for (int i = 0; i < LAGRANGE_LENGTH; i++)
        sum += y[i] - y[i];
    return sum == 0;
}

// Goes on in time by h. The time and its remainder are the exact sum of all steps but for the rounding of the remainder.
LAGRANGE_FUNCTION void lagrange_advance(REAL *t, REAL *t_rest, REAL h)
{
    const REAL wanted = *t_rest + h, before = *t;
    *t = before + wanted;
    *t_rest = wanted + (before - *t);
}

// The length of the shortest steps that count in the rounding of this time, whatever the remainder is.
LAGRANGE_FUNCTION REAL lagrange_least_step(REAL t)
{
    // A third has no finite binary expansion; rounding it leaves this much.
    const REAL epsilon = LAGRANGE_ABS(3 * ((REAL)4 / 3 - 1) - 1);
    return 2 * epsilon * LAGRANGE_ABS(t);
}

// The classical method of order four in equal steps, of which the last may be shorter. States and times are summed with compensation.
// Sources: Kutta 1901; Hairer, Lubich, Wanner, Geometric Numerical Integration, section VIII.5.
LAGRANGE_KERNEL void lagrange_runge_kutta_4(
    LAGRANGE_GLOBAL REAL *states, LAGRANGE_GLOBAL const REAL *parameters, LAGRANGE_GLOBAL REAL *times, LAGRANGE_GLOBAL REAL *controls,
    LAGRANGE_GLOBAL unsigned int *taken, LAGRANGE_GLOBAL unsigned int *statuses, const REAL end, const REAL step, const REAL relative,
    const REAL absolute, const unsigned int motions, const unsigned int budget, const unsigned int most)
{
    const unsigned int motion = (unsigned int)LAGRANGE_THREAD;
    if (motion >= motions || statuses[motion] != LAGRANGE_RUNNING)
        return;
    REAL y[LAGRANGE_LENGTH], rest[LAGRANGE_LENGTH], p[LAGRANGE_PARAMETERS + 1];
    for (int i = 0; i < LAGRANGE_LENGTH; i++) {
        y[i] = states[(size_t)i * motions + motion];
        rest[i] = 0;
    }
    for (int i = 0; i < LAGRANGE_PARAMETERS; i++)
        p[i] = parameters[(size_t)i * motions + motion];
    REAL t = times[motion], t_rest = controls[(size_t)2 * motions + motion];
    unsigned int steps = taken[motion], status = LAGRANGE_RUNNING;
    (void)relative, (void)absolute;

    for (unsigned int left = budget; left > 0 && status == LAGRANGE_RUNNING; left--) {
        if (steps == most) {
            status = LAGRANGE_TOO_MANY_STEPS;
            break;
        }
        const REAL way = (end - t) - t_rest;
        const int is_last = LAGRANGE_ABS(way) <= step * (1 + (REAL)1e-9);
        const REAL h = is_last ? way : way < 0 ? -step : step;
        if (!is_last && (t + step == t || t - step == t)) {
            controls[motion] = step;
            status = LAGRANGE_STEP_UNDERFLOW;
            break;
        }
        REAL k[LAGRANGE_LENGTH], sum[LAGRANGE_LENGTH], z[LAGRANGE_LENGTH];
        lagrange_rhs(t, y, p, k);
        for (int i = 0; i < LAGRANGE_LENGTH; i++) {
            sum[i] = k[i];
            z[i] = y[i] + h / 2 * k[i];
        }
        lagrange_rhs(t + h / 2, z, p, k);
        for (int i = 0; i < LAGRANGE_LENGTH; i++) {
            sum[i] += 2 * k[i];
            z[i] = y[i] + h / 2 * k[i];
        }
        lagrange_rhs(t + h / 2, z, p, k);
        for (int i = 0; i < LAGRANGE_LENGTH; i++) {
            sum[i] += 2 * k[i];
            z[i] = y[i] + h * k[i];
        }
        lagrange_rhs(t + h, z, p, k);
        for (int i = 0; i < LAGRANGE_LENGTH; i++) {
            k[i] = rest[i] + h / 6 * (sum[i] + k[i]);
            z[i] = y[i] + k[i];
            k[i] += y[i] - z[i];
        }
        lagrange_normalise(z);
        if (!lagrange_is_finite(z)) {
            status = LAGRANGE_NOT_FINITE;
            break;
        }
        for (int i = 0; i < LAGRANGE_LENGTH; i++) {
            y[i] = z[i];
            rest[i] = k[i];
        }
        steps++;
        if (is_last) {
            t = end;
            status = LAGRANGE_DONE;
        } else {
            lagrange_advance(&t, &t_rest, h);
        }
    }

    for (int i = 0; i < LAGRANGE_LENGTH; i++)
        states[(size_t)i * motions + motion] = y[i];
    times[motion] = t;
    controls[(size_t)2 * motions + motion] = t_rest;
    taken[motion] = steps;
    statuses[motion] = status;
}

// The error of a step as a part of what is tolerated, in the mean of squares.
LAGRANGE_FUNCTION REAL lagrange_measured(const REAL *error, const REAL *y, const REAL *z, REAL relative, REAL absolute)
{
    REAL sum = 0;
    for (int i = 0; i < LAGRANGE_LENGTH; i++) {
        const REAL a = LAGRANGE_ABS(y[i]), b = LAGRANGE_ABS(z[i]);
        const REAL part = error[i] / (absolute + relative * (a > b ? a : b));
        sum += part * part;
    }
    return LAGRANGE_SQRT(sum / LAGRANGE_LENGTH);
}

// The length of a first step: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, section II.4.
LAGRANGE_FUNCTION REAL lagrange_first_step(
    REAL t, const REAL *y, const REAL *rates, const REAL *p, REAL way, REAL relative, REAL absolute)
{
    REAL z[LAGRANGE_LENGTH], k[LAGRANGE_LENGTH];
    const REAL most = LAGRANGE_ABS(way), size = lagrange_measured(y, y, y, relative, absolute);
    const REAL slope = lagrange_measured(rates, y, y, relative, absolute);
    REAL h = size < (REAL)1e-5 || slope < (REAL)1e-5 ? (REAL)1e-6 : (REAL)0.01 * (size / slope);
    h = h < most ? h : most;
    const REAL signed_h = way < 0 ? -h : h;
    for (int i = 0; i < LAGRANGE_LENGTH; i++)
        z[i] = y[i] + signed_h * rates[i];
    lagrange_rhs(t + signed_h, z, p, k);
    for (int i = 0; i < LAGRANGE_LENGTH; i++)
        k[i] -= rates[i];
    const REAL curvature = lagrange_measured(k, y, y, relative, absolute) / h;
    const REAL larger = curvature > slope ? curvature : slope;
    const REAL wanted = larger > (REAL)1e-15 ? LAGRANGE_POWF((REAL)0.01 / larger, (REAL)0.2) : (REAL)1e-3 * h;
    const REAL limited = wanted < 100 * h ? wanted : 100 * h;
    return limited < most ? limited : most;
}

// The pair of orders five and four of Dormand and Prince, whose steps a proportional and integral controller chooses; none is longer than
// `step`.
// Sources: Dormand, Prince 1980; Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, table II.5.2;
// Hairer, Wanner, Solving Ordinary Differential Equations II, section IV.2.
LAGRANGE_KERNEL void lagrange_dormand_prince(
    LAGRANGE_GLOBAL REAL *states, LAGRANGE_GLOBAL const REAL *parameters, LAGRANGE_GLOBAL REAL *times, LAGRANGE_GLOBAL REAL *controls,
    LAGRANGE_GLOBAL unsigned int *taken, LAGRANGE_GLOBAL unsigned int *statuses, const REAL end, const REAL step, const REAL relative,
    const REAL absolute, const unsigned int motions, const unsigned int budget, const unsigned int most)
{
    const unsigned int motion = (unsigned int)LAGRANGE_THREAD;
    if (motion >= motions || statuses[motion] != LAGRANGE_RUNNING)
        return;
    REAL y[LAGRANGE_LENGTH], p[LAGRANGE_PARAMETERS + 1];
    REAL k1[LAGRANGE_LENGTH], k2[LAGRANGE_LENGTH], k3[LAGRANGE_LENGTH], k4[LAGRANGE_LENGTH], k5[LAGRANGE_LENGTH];
    REAL k6[LAGRANGE_LENGTH], k7[LAGRANGE_LENGTH], z[LAGRANGE_LENGTH], error[LAGRANGE_LENGTH];
    for (int i = 0; i < LAGRANGE_LENGTH; i++)
        y[i] = states[(size_t)i * motions + motion];
    for (int i = 0; i < LAGRANGE_PARAMETERS; i++)
        p[i] = parameters[(size_t)i * motions + motion];
    REAL t = times[motion], t_rest = controls[(size_t)2 * motions + motion];
    REAL size = controls[motion], before = controls[(size_t)motions + motion];
    unsigned int steps = taken[motion], status = LAGRANGE_RUNNING;
    int was_rejected = 0;
    lagrange_rhs(t, y, p, k1);
    if (!lagrange_is_finite(y) || !lagrange_is_finite(k1))
        status = LAGRANGE_NOT_FINITE;
    else if (size == 0)
        size = lagrange_first_step(t, y, k1, p, end - t, relative, absolute);

    for (unsigned int left = budget; left > 0 && status == LAGRANGE_RUNNING; left--) {
        const REAL way = (end - t) - t_rest;
        if (way == 0) {
            status = LAGRANGE_DONE;
            break;
        }
        if (steps == most) {
            status = LAGRANGE_TOO_MANY_STEPS;
            break;
        }
        size = size < step ? size : step;
        const REAL least = lagrange_least_step(t);
        if (size < least) {
            if (was_rejected || step < least) {
                status = LAGRANGE_STEP_UNDERFLOW;
                break;
            }
            size = least;
        }
        steps++;
        // A last step is stretched a little, so that none behind it is lost in rounding.
        const int is_last = LAGRANGE_ABS(way) <= size * (REAL)1.01;
        const REAL h = is_last ? way : way < 0 ? -size : size;
        for (int i = 0; i < LAGRANGE_LENGTH; i++)
            z[i] = y[i] + h * ((REAL)1 / 5 * k1[i]);
        lagrange_rhs(t + h / 5, z, p, k2);
        for (int i = 0; i < LAGRANGE_LENGTH; i++)
            z[i] = y[i] + h * ((REAL)3 / 40 * k1[i] + (REAL)9 / 40 * k2[i]);
        lagrange_rhs(t + h * 3 / 10, z, p, k3);
        for (int i = 0; i < LAGRANGE_LENGTH; i++)
            z[i] = y[i] + h * ((REAL)44 / 45 * k1[i] - (REAL)56 / 15 * k2[i] + (REAL)32 / 9 * k3[i]);
        lagrange_rhs(t + h * 4 / 5, z, p, k4);
        for (int i = 0; i < LAGRANGE_LENGTH; i++)
            z[i] = y[i] + h * ((REAL)19372 / 6561 * k1[i] - (REAL)25360 / 2187 * k2[i] + (REAL)64448 / 6561 * k3[i]
                               - (REAL)212 / 729 * k4[i]);
        lagrange_rhs(t + h * 8 / 9, z, p, k5);
        for (int i = 0; i < LAGRANGE_LENGTH; i++)
            z[i] = y[i] + h * ((REAL)9017 / 3168 * k1[i] - (REAL)355 / 33 * k2[i] + (REAL)46732 / 5247 * k3[i]
                               + (REAL)49 / 176 * k4[i] - (REAL)5103 / 18656 * k5[i]);
        lagrange_rhs(t + h, z, p, k6);
        for (int i = 0; i < LAGRANGE_LENGTH; i++)
            z[i] = y[i] + h * ((REAL)35 / 384 * k1[i] + (REAL)500 / 1113 * k3[i] + (REAL)125 / 192 * k4[i]
                               - (REAL)2187 / 6784 * k5[i] + (REAL)11 / 84 * k6[i]);
        lagrange_normalise(z);
        lagrange_rhs(t + h, z, p, k7);
        for (int i = 0; i < LAGRANGE_LENGTH; i++)
            error[i] = h * ((REAL)71 / 57600 * k1[i] - (REAL)71 / 16695 * k3[i] + (REAL)71 / 1920 * k4[i]
                            - (REAL)17253 / 339200 * k5[i] + (REAL)22 / 525 * k6[i] - (REAL)1 / 40 * k7[i]);
        const REAL measured = lagrange_measured(error, y, z, relative, absolute);
        // What is not a number fails this comparison.
        if (measured <= 1 && lagrange_is_finite(z) && lagrange_is_finite(k7)) {
            const REAL part = LAGRANGE_POWF(measured, (REAL)0.17) / LAGRANGE_POWF(before, (REAL)0.04) / (REAL)0.9;
            const REAL most_growth = was_rejected ? (REAL)1 : (REAL)0.1;
            const REAL divisor = part < most_growth ? most_growth : part > 5 ? (REAL)5 : part;
            if (!is_last || divisor > 1)
                size = LAGRANGE_ABS(h) / divisor;
            before = measured > (REAL)1e-4 ? measured : (REAL)1e-4;
            was_rejected = 0;
            if (is_last) {
                t = end;
                t_rest = 0;
            } else {
                lagrange_advance(&t, &t_rest, h);
            }
            for (int i = 0; i < LAGRANGE_LENGTH; i++) {
                y[i] = z[i];
                k1[i] = k7[i];
            }
        } else {
            const REAL part = LAGRANGE_POWF(measured, (REAL)0.17) / (REAL)0.9;
            size = LAGRANGE_ABS(h) / (part < 5 ? part > (REAL)1.1 ? part : (REAL)1.1 : (REAL)5);
            was_rejected = 1;
            if (size < lagrange_least_step(t))
                status = measured - measured == 0 ? LAGRANGE_STEP_UNDERFLOW : LAGRANGE_NOT_FINITE;
        }
    }

    for (int i = 0; i < LAGRANGE_LENGTH; i++)
        states[(size_t)i * motions + motion] = y[i];
    times[motion] = t;
    controls[motion] = size;
    controls[(size_t)motions + motion] = before;
    controls[(size_t)2 * motions + motion] = t_rest;
    taken[motion] = steps;
    statuses[motion] = status;
}
