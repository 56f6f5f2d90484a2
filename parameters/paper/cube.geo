// A cube of 2 cm with one corner in the origin, for cube_tetrahedra.prm. The
// field makes the tetrahedra finer inside than at the surface, where the
// entry "Cell size" rules: with cells of equal size a mesh of 592 tetrahedra
// has more nodes on its surface, and more of them in all, than the published
// 170.
SetFactory("Built-in");
a = 0.02;
Point(1) = {0, 0, 0};
line[] = Extrude {0, a, 0} { Point{1}; };
face[] = Extrude {0, 0, a} { Line{line[1]}; };
body[] = Extrude {a, 0, 0} { Surface{face[1]}; };

Mesh.CharacteristicLengthExtendFromBoundary = 0;
Mesh.CharacteristicLengthFromPoints = 0;
Field[1] = MathEval;
Field[1].F = Sprintf("0.0034 + 0.0017 * ((2 * x / %g - 1)^4 + (2 * y / %g - 1)^4 + (2 * z / %g - 1)^4)", a, a, a);
Background Field = 1;

Physical Surface("x min", 10) = {face[1]};
Physical Surface("x max", 20) = {body[0]};
Physical Surface("sides", 30) = {body[2], body[3], body[4], body[5]};
Physical Volume("cube", 1) = {body[1]};
