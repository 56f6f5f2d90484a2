// A plate of 30 mm x 20 mm with a hole; lengths in mm.
SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, 30, 20};
Disk(2) = {15, 10, 0, 4};
BooleanDifference(3) = { Surface{1}; Delete; }{ Surface{2}; Delete; };
left() = Curve In BoundingBox {-0.1, -0.1, -0.1, 0.1, 20.1, 0.1};
right() = Curve In BoundingBox {29.9, -0.1, -0.1, 30.1, 20.1, 0.1};
Physical Curve("left", 4) = {left()};
Physical Curve("right", 8) = {right()};
Physical Surface("steel", 2) = {3};
