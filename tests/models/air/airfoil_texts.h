#pragma once

// Aerofoil files of made-up numbers.

#include <string>

namespace spoke::test {

/// A plain table: lines 1 and 2 are comments, rows are in lines 3 to 9.
inline const std::string kPlainAirfoil =
    "# made up\n"
    "! angle lift drag moment\n"
    "-180, 0.0, 0.02, 0.0\n"
    "-90   0.1  1.5   0.4   # flat\n"
    "-10\t-0.8\t0.03\t0.01\n"
    "0  0.3  0.01  -0.05\n"
    "10 1.2  0.02 -0.04\n"
    "90 0.05 1.4 -0.4\n"
    "180 0.0 0.02 0\n";

/// A file of AeroDyn with two tables and, in the first, parameters of an unsteady model. Re stands
/// in lines 6 and 22.
inline const std::string kAerodynAirfoil =
    "! ------------ made up ------------\n"
    "\"DEFAULT\"   InterpOrd   ! order\n"
    "1           NonDimArea  ! area\n"
    "@\"none.txt\" NumCoords   ! shape\n"
    "2           NumTabs     ! tables\n"
    "  0.5  Re         ! millions\n"
    "  0    UserProp   ! control\n"
    "True   InclUAdata ! parameters follow\n"
    "!.......\n"
    "  -3.2      alpha0   ! zero lift\n"
    "  7.1       C_nalpha ! slope\n"
    "\"DEFAULT\"   UACutout ! angle\n"
    "!.......\n"
    "  5    NumAlf     ! rows\n"
    "! Alpha Cl Cd Cm\n"
    " -180.00  0.000  0.0602  0.0000\n"
    "  -10.00 -0.700  0.0300  0.0100\n"
    "    0.00  0.400  0.0100 -0.0500\n"
    "   10.00  1.300  0.0200 -0.0600\n"
    "  180.00  0.000  0.0602  0.0000\n"
    "! table 2\n"
    "  2.0  Re\n"
    "  0    UserProp\n"
    "False  InclUAdata\n"
    "  4    NumAlf\n"
    " -180.00  0.000  0.0500  0.0000\n"
    "    0.00  0.500  0.0080 -0.0500\n"
    "   10.00  1.500  0.0150 -0.0600\n"
    "  180.00  0.000  0.0500  0.0000\n";

}  // namespace spoke::test
