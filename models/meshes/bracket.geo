// An L-bracket of aluminium, in mm: two arms of 400 x 100 x 40, a fillet in the inner
// corner and a hole in each arm. ROOT is the end face of the standing arm, TIP that of the
// lying one. The mesh beside this file was made by gmsh 4.8.4:
//   gmsh -3 -order 2 -format msh41 bracket.geo -o bracket.msh
SetFactory("OpenCASCADE");
Mesh.MeshSizeMax = 60;
Mesh.MeshSizeMin = 30;
Mesh.MeshSizeFromCurvature = 8;
Mesh.HighOrderOptimize = 0;
Mesh.SecondOrderLinear = 0;

a = 400;  // length of the arms
w = 100;  // width
t = 40;   // thickness
f = 60;   // radius of the fillet in the corner
d = 50;   // diameter of the holes

Box(1) = {0, 0, 0, a, w, t};
Box(2) = {0, 0, 0, t, w, a};
Box(3) = {t, 0, t, f, w, f};
Cylinder(4) = {t + f, 0, t + f, 0, w, 0, f};
BooleanDifference(5) = { Volume{3}; Delete; }{ Volume{4}; Delete; };
BooleanUnion(6) = { Volume{1}; Delete; }{ Volume{2, 5}; Delete; };
Cylinder(11) = {0.65 * a, w / 2, -1, 0, 0, t + 2, d / 2};
Cylinder(12) = {-1, w / 2, 0.65 * a, t + 2, 0, 0, d / 2};
BooleanDifference(20) = { Volume{6}; Delete; }{ Volume{11, 12}; Delete; };

e = 1e-3;
root() = Surface In BoundingBox {-e, -e, a - e, t + e, w + e, a + e};
tip() = Surface In BoundingBox {a - e, -e, -e, a + e, w + e, t + e};
Physical Surface("ROOT") = {root()};
Physical Surface("TIP") = {tip()};
Physical Volume("BRACKET") = {Volume{:}};
