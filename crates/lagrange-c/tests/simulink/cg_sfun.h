// Runs the block by the classical method of Runge and Kutta: parameters of the block in the command
// line, input 3, up to t = 2. Prints the sizes, the state, the outputs and the zeros; or the error.

#include <stdio.h>
#include <stdlib.h>

static void add_rates(SimStruct *S, const double *y, double t, double h, double weight, double *sum)
{
    S->t = t + h;
    for (int i = 0; i < S->states; i++)
        S->y[i] = y[i] + h * S->rates[i];
    mdlDerivatives(S);
    for (int i = 0; i < S->states; i++)
        sum[i] += weight * S->rates[i];
}

int main(int count, char **words)
{
    static SimStruct block;
    SimStruct *S = &block;
    const double h = 1.0 / 512.0;
    for (int i = 1; i < count; i++)
        S->parameter.values[S->parameter.count++] = atof(words[i]);
    mdlInitializeSizes(S);
    if (S->error != NULL) {
        printf("%s\n", S->error);
        return 1;
    }
    mdlInitializeSampleTimes(S);
    mdlInitializeConditions(S);
    S->input[0] = 3.0;
    for (int step = 0; step < 1024; step++) {
        double y[16], sum[16] = { 0.0 };
        const double t = step * h;
        memcpy(y, S->y, sizeof y);
        memset(S->rates, 0, sizeof S->rates);
        add_rates(S, y, t, 0.0, h / 6.0, sum);
        add_rates(S, y, t, h / 2.0, h / 3.0, sum);
        add_rates(S, y, t, h / 2.0, h / 3.0, sum);
        add_rates(S, y, t, h, h / 6.0, sum);
        for (int i = 0; i < S->states; i++)
            S->y[i] = y[i] + sum[i];
        S->t = (step + 1) * h;
    }
    mdlOutputs(S, 0);
    mdlZeroCrossings(S);
    printf("%d %d %d %d %.17g %.17g %.17g %.17g\n", S->states, S->inputs, S->outputs, S->zeros, S->y[0],
           S->y[1], S->output[0], S->zero[0]);
    mdlTerminate(S);
    return 0;
}
