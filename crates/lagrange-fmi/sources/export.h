// Heads of exported functions.

#ifndef EXPORT_H
#define EXPORT_H

#ifdef _WIN32
#define EXPORT __declspec(dllexport)
#elif defined(__GNUC__)
#define EXPORT __attribute__((visibility("default")))
#else
#define EXPORT
#endif

// Programs that link several models define a prefix for each.
#ifdef FMI2_FUNCTION_PREFIX
#define PREFIX FMI2_FUNCTION_PREFIX
#elif defined(FMI3_FUNCTION_PREFIX)
#define PREFIX FMI3_FUNCTION_PREFIX
#endif
#ifdef PREFIX
#define PASTED(prefix, name) prefix##name
#define WITH_PREFIX(prefix, name) PASTED(prefix, name)
#define EXPORTED(name) WITH_PREFIX(PREFIX, name)
#else
#define EXPORTED(name) name
#endif

// The head of a function: its declaration, which warnings ask for, and that of its definition.
#define FUNCTION(type, name, arguments) \
    EXPORT type EXPORTED(name) arguments; \
    type EXPORTED(name) arguments

#endif
