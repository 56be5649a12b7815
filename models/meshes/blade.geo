// A solid rotor blade, in m: from x = 0.3 to 3 its chord along y tapers from 0.24 to 0.14, its thickness
// along z from 0.048 to 0.017; it is twisted from 12 degrees to 0 about its quarter chord, and its tip
// is swept back by 0.12. ROOT and TIP are its end faces, SURFACE its upper side. The mesh beside this
// file was made by gmsh 4.8.4:
//   gmsh -3 -order 2 -format msh41 blade.geo -o blade.msh
Mesh.SecondOrderIncomplete = 1;  // hexahedra of 20 nodes
Mesh.HighOrderOptimize = 0;

stations = 5;     // sections that the edges are drawn through
elements_x = 16;  // elements along the span, the chord and the thickness
elements_y = 5;
elements_z = 2;

For k In {0:stations - 1}
  s = k / (stations - 1);
  x = 0.3 + 2.7 * s;
  c = 0.24 - 0.10 * s;
  h = c * (0.10 - 0.04 * s);
  twist = 12 * Pi / 180 * (1 - s);
  back = -0.12 * s * s;
  // Leading and trailing edge, above and below, and the thickest place.
  y() = {0.25 * c, -0.75 * c, -0.75 * c, 0.25 * c, -0.05 * c, -0.05 * c};
  z() = {0.5 * h, 0.25 * h, -0.25 * h, -0.5 * h, h, -h};
  For n In {0:5}
    Point(10 * k + n + 1) = {x, back + y(n) * Cos(twist) - z(n) * Sin(twist),
                             y(n) * Sin(twist) + z(n) * Cos(twist)};
  EndFor
EndFor

t = 10 * (stations - 1);  // points of the tip
For n In {1:4}
  Spline(n) = {n, 10 + n, 20 + n, 30 + n, t + n};
EndFor
Spline(11) = {1, 5, 2};  // root: above, trailing edge, below, leading edge
Line(12) = {2, 3};
Spline(13) = {3, 6, 4};
Line(14) = {4, 1};
Spline(21) = {t + 1, t + 5, t + 2};  // tip
Line(22) = {t + 2, t + 3};
Spline(23) = {t + 3, t + 6, t + 4};
Line(24) = {t + 4, t + 1};

Curve Loop(1) = {11, 12, 13, 14};
Plane Surface(1) = {1};
Curve Loop(2) = {21, 22, 23, 24};
Plane Surface(2) = {2};
Curve Loop(3) = {11, 2, -21, -1};
Surface(3) = {3};
Curve Loop(4) = {12, 3, -22, -2};
Surface(4) = {4};
Curve Loop(5) = {13, 4, -23, -3};
Surface(5) = {5};
Curve Loop(6) = {14, 1, -24, -4};
Surface(6) = {6};
Surface Loop(1) = {1:6};
Volume(1) = {1};

Transfinite Curve {1:4} = elements_x + 1;
Transfinite Curve {11, 13, 21, 23} = elements_y + 1;
Transfinite Curve {12, 14, 22, 24} = elements_z + 1;
Transfinite Surface {1:6};
Recombine Surface {1:6};
Transfinite Volume {1};

Physical Surface("ROOT") = {1};
Physical Surface("TIP") = {2};
Physical Surface("SURFACE") = {3};
Physical Volume("BLADE") = {1};
