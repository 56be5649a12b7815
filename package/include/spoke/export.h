#pragma once

/// Marks symbols that a program outside may link to. All other symbols of the shared library are
/// hidden: its sources are compiled with -fvisibility=hidden.
#define SPOKE_EXPORT __attribute__((visibility("default")))
