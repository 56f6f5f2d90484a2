// An angle bracket with a rounded corner, drawn in mm, for bracket.prm.
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 40, 8, 15};
Box(2) = {0, 0, 0, 8, 30, 15};
v() = BooleanUnion{ Volume{1}; Delete; }{ Volume{2}; Delete; };
e() = Curve In BoundingBox {7.9, 7.9, -0.1, 8.1, 8.1, 15.1};
f() = Fillet{ v(0) }{ e(0) }{ 5 };

Physical Volume("gel", 10) = f();
Physical Surface("wall", 20) = Surface In BoundingBox {-0.1, -0.1, -0.1, 0.1, 30.1, 15.1};
Physical Surface("tip", 30) = Surface In BoundingBox {39.9, -0.1, -0.1, 40.1, 8.1, 15.1};
