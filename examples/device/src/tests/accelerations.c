
LAGRANGE_KERNEL void lagrange_runge_kutta_4(
    LAGRANGE_GLOBAL REAL *states, LAGRANGE_GLOBAL const REAL *parameters, LAGRANGE_GLOBAL REAL *times, LAGRANGE_GLOBAL REAL *controls,
    LAGRANGE_GLOBAL unsigned int *taken, LAGRANGE_GLOBAL unsigned int *statuses, const REAL end, const REAL step, const REAL relative,
    const REAL absolute, const unsigned int motions, const unsigned int budget, const unsigned int most)
{
    if (LAGRANGE_THREAD != 0)
        return;
    REAL y[LAGRANGE_LENGTH], p[LAGRANGE_PARAMETERS + 1], a[LAGRANGE_VELOCITIES];
    for (int i = 0; i < LAGRANGE_LENGTH; i++)
        y[i] = states[i];
    for (int i = 0; i < LAGRANGE_PARAMETERS; i++)
        p[i] = parameters[i];
    lagrange_acceleration(times[0], y, y + LAGRANGE_POSITIONS, p, a);
    for (int i = 0; i < LAGRANGE_VELOCITIES; i++)
        states[LAGRANGE_POSITIONS + i] = a[i];
    statuses[0] = LAGRANGE_DONE;
}
