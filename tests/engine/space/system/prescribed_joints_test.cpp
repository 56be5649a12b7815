// Joints whose motion is prescribed.

#include <doctest/doctest.h>

#include <cmath>

#include "tests/engine/space/system/models.h"
#include "tests/engine/space/system/runs.h"

using namespace spoke;
using namespace spoke::test;
