// Steps a unit: token, kind (2 with event mode), length of a step, number of steps, and pairs of a value
// reference and a value.
// Prints the status of the last step, the time, and the values of the first two variables.

#include "unit.h"

int main(int count, char **words)
{
    const unsigned references[] = { 0, 1, TIME };
    if (count < 5)
        return 2;
    const int kind = atoi(words[2]);
    void *unit = instantiate(words[1], kind, print);
    if (unit == NULL)
        return 1;
    const double length = atof(words[3]);
    double values[3];
    int status = initialize(unit, 1e-13, 0.0);
    for (int i = 5; i + 1 < count; i += 2) {
        const unsigned reference = (unsigned)atoi(words[i]);
        const double value = atof(words[i + 1]);
        if (set(unit, &reference, 1, &value) != 0)
            return 3;
    }
    finish_initialization(unit);
#ifdef FMI3
    bool is_end;
    if (kind == STEPS_WITH_EVENTS && status == 0)
        status = handle_events(unit, &is_end);
#endif
    for (int i = 0; i < atoi(words[4]) && status == 0; i++)
        status = step(unit, i * length, length);
    get(unit, references, 3, values);
    printf("%d %.17g %.17g %.17g\n", status, values[2], values[0], values[1]);
    free_instance(unit);
    return 0;
}
