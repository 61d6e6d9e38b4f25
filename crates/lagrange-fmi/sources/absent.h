// Functions of FMI 3.0 for what no system has: other types, clocks, partitions, arrays, derivatives of
// outputs.

// Functions of a type that no variable has; clocks and binaries have other arguments.
#define OTHER_TYPE(type) \
    FUNCTION(fmi3Status, fmi3Get##type, \
             (fmi3Instance instance, const fmi3ValueReference references[], size_t count, fmi3##type values[], \
              size_t value_count)) \
    { \
        (void)values, (void)value_count; \
        return other_type(instance, __func__, references, count); \
    } \
    FUNCTION(fmi3Status, fmi3Set##type, \
             (fmi3Instance instance, const fmi3ValueReference references[], size_t count, \
              const fmi3##type values[], size_t value_count)) \
    { \
        (void)values, (void)value_count; \
        return other_type(instance, __func__, references, count); \
    }

OTHER_TYPE(Float32)
OTHER_TYPE(Int8)
OTHER_TYPE(UInt8)
OTHER_TYPE(Int16)
OTHER_TYPE(UInt16)
OTHER_TYPE(Int32)
OTHER_TYPE(UInt32)
OTHER_TYPE(Int64)
OTHER_TYPE(UInt64)
OTHER_TYPE(Boolean)
OTHER_TYPE(String)

FUNCTION(fmi3Status, fmi3GetBinary,
         (fmi3Instance instance, const fmi3ValueReference references[], size_t count, size_t sizes[],
          fmi3Binary values[], size_t value_count))
{
    (void)sizes, (void)values, (void)value_count;
    return other_type(instance, __func__, references, count);
}

FUNCTION(fmi3Status, fmi3SetBinary,
         (fmi3Instance instance, const fmi3ValueReference references[], size_t count, const size_t sizes[],
          const fmi3Binary values[], size_t value_count))
{
    (void)sizes, (void)values, (void)value_count;
    return other_type(instance, __func__, references, count);
}

// Functions of clocks with one or two arrays behind the value references.
#define CLOCK_1(name, one) \
    FUNCTION(fmi3Status, name, \
             (fmi3Instance instance, const fmi3ValueReference references[], size_t count, one values[])) \
    { \
        (void)values; \
        return other_type(instance, __func__, references, count); \
    }
#define CLOCK_2(name, one, two) \
    FUNCTION(fmi3Status, name, \
             (fmi3Instance instance, const fmi3ValueReference references[], size_t count, one values[], \
              two others[])) \
    { \
        (void)values, (void)others; \
        return other_type(instance, __func__, references, count); \
    }

CLOCK_1(fmi3GetClock, fmi3Clock)
CLOCK_1(fmi3SetClock, const fmi3Clock)
CLOCK_1(fmi3GetShiftDecimal, fmi3Float64)
CLOCK_1(fmi3SetShiftDecimal, const fmi3Float64)
CLOCK_1(fmi3SetIntervalDecimal, const fmi3Float64)
CLOCK_2(fmi3GetIntervalDecimal, fmi3Float64, fmi3IntervalQualifier)
CLOCK_2(fmi3GetShiftFraction, fmi3UInt64, fmi3UInt64)
CLOCK_2(fmi3SetShiftFraction, const fmi3UInt64, const fmi3UInt64)
CLOCK_2(fmi3SetIntervalFraction, const fmi3UInt64, const fmi3UInt64)

FUNCTION(fmi3Status, fmi3GetIntervalFraction,
         (fmi3Instance instance, const fmi3ValueReference references[], size_t count, fmi3UInt64 counters[],
          fmi3UInt64 resolutions[], fmi3IntervalQualifier qualifiers[]))
{
    (void)counters, (void)resolutions, (void)qualifiers;
    return other_type(instance, __func__, references, count);
}

FUNCTION(fmi3Status, fmi3ActivateModelPartition,
         (fmi3Instance instance, fmi3ValueReference clock, fmi3Float64 time))
{
    (void)clock, (void)time;
    return fail(instance, __func__, "there are no partitions");
}

FUNCTION(fmi3Status, fmi3GetNumberOfVariableDependencies,
         (fmi3Instance instance, fmi3ValueReference reference, size_t *count))
{
    (void)reference, (void)count;
    return fail(instance, __func__, "dependencies are those of the model description");
}

FUNCTION(fmi3Status, fmi3GetVariableDependencies,
         (fmi3Instance instance, fmi3ValueReference reference, size_t elements[],
          fmi3ValueReference independents[], size_t elements_of_independents[], fmi3DependencyKind kinds[],
          size_t count))
{
    (void)reference, (void)elements, (void)independents, (void)elements_of_independents;
    (void)kinds, (void)count;
    return fail(instance, __func__, "dependencies are those of the model description");
}

FUNCTION(fmi3Status, fmi3GetOutputDerivatives,
         (fmi3Instance instance, const fmi3ValueReference references[], size_t count, const fmi3Int32 orders[],
          fmi3Float64 values[], size_t value_count))
{
    (void)references, (void)count, (void)orders, (void)values, (void)value_count;
    return fail(instance, __func__, "derivatives of outputs are not known");
}
