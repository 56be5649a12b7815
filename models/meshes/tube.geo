// A square tube of aluminium, in m: a quarter of a blade of the Wu-Haug rotor, 2 m along x. It has
// the area, 7.299e-5 m^2, and the second moment, 8.214e-9 m^4, of wu_haug_rotor.toml. ROOT and TIP
// are its end faces. The mesh beside this file was made by gmsh 4.8.4:
//   gmsh -3 -order 2 -format msh41 tube.geo -o tube.msh
Mesh.SecondOrderIncomplete = 1;  // hexahedra of 20 nodes

area = 7.299e-5;
second_moment = 8.214e-9;
squares = 12 * second_moment / area;    // of the outer and the inner side, their sum
a = 0.5 * Sqrt((squares + area) / 2);   // half of the outer side
b = 0.5 * Sqrt((squares - area) / 2);   // half of the inner one
length = 2;
elements = 12;  // along the tube; one for each wall, and one through it

y() = {-1, 1, 1, -1};
z() = {-1, -1, 1, 1};
For k In {0:3}
  Point(1 + k) = {0, a * y(k), a * z(k)};
  Point(5 + k) = {0, b * y(k), b * z(k)};
EndFor
For k In {0:3}
  Line(1 + k) = {1 + k, 1 + (k + 1) % 4};
  Line(5 + k) = {5 + k, 5 + (k + 1) % 4};
  Line(9 + k) = {1 + k, 5 + k};
EndFor
For k In {0:3}
  Curve Loop(1 + k) = {1 + k, 9 + (k + 1) % 4, -(5 + k), -(9 + k)};
  Plane Surface(1 + k) = {1 + k};
EndFor
Transfinite Curve {1:12} = 2;
Transfinite Surface {1:4};
Recombine Surface {1:4};
root() = {1:4};
tip() = {};
tube() = {};
For k In {0:3}
  wall() = Extrude {length, 0, 0} { Surface{1 + k}; Layers{elements}; Recombine; };
  tip() += {wall(0)};
  tube() += {wall(1)};
EndFor
Physical Surface("ROOT") = root();
Physical Surface("TIP") = tip();
Physical Volume("TUBE") = tube();
