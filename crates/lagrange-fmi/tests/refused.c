// Sets pairs of values of which one is refused, before and during a run. Arguments: kind, and value
// references of a state, of a parameter in 0..1, of a period and of a count.
// Prints the status of each call, the state, the parameter and the period, and after a step of co-simulation its
// status and the count.

#include "unit.h"

int main(int count, char **words)
{
    unsigned references[4];
    if (count < 6)
        return 2;
    for (int i = 0; i < 4; i++)
        references[i] = (unsigned)atoi(words[2 + i]);
    const unsigned shortens[] = { references[2], references[1] };
    void *unit = instantiate(GUID, atoi(words[1]), print);
    initialize(unit, 1e-9, 0.0);
    printf("%d ", set(unit, references, 2, (const double[]) { 5.0, 2.0 }));
    printf("%d ", set(unit, shortens, 2, (const double[]) { 1e-300, 2.0 }));
    printf("%d ", set(unit, references + 1, 1, (const double[]) { 0.25 }));
    printf("%d ", finish_initialization(unit));
    printf("%d ", set(unit, shortens, 2, (const double[]) { 1e-300, 2.0 }));
    double values[4];
    get(unit, references, 3, values);
    printf("%g %g %g ", values[0], values[1], values[2]);
    const int status = step(unit, 0.0, 1.0);
    get(unit, references, 4, values);
    printf("%d %g", status, values[3]);
    free_instance(unit);
    return 0;
}
