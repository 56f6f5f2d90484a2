// An organ-like solid, drawn in mm, for organ.prm: an ellipsoid of 60 x 40 x 30
// of soft tissue with a stiff one inside, which lies on a bed and is touched
// from above.
SetFactory("OpenCASCADE");
Sphere(1) = {0, 0, 0, 15};
Sphere(2) = {4, 3, 2, 5};

// What lies below and above two planes, so that the skin has a bed and a patch.
Box(3) = {-20, -20, -20, 40, 40, 10};
Box(4) = {-20, -20, 11, 40, 40, 10};
below() = BooleanIntersection{ Volume{3}; Delete; }{ Volume{1}; };
above() = BooleanIntersection{ Volume{4}; Delete; }{ Volume{1}; };
all() = BooleanFragments{ Volume{1}; Delete; }{ Volume{2, below(0), above(0)}; Delete; };

e = 0.2;
inclusion() = Volume In BoundingBox {-1 - e, -2 - e, -3 - e, 9 + e, 8 + e, 7 + e};
tissue() = Volume{:};
tissue() -= inclusion();

Dilate {{0, 0, 0}, {2, 1.3333, 1}} { Volume{:}; }

Physical Volume("tissue", 1) = tissue();
Physical Volume("inclusion", 2) = inclusion();
// As the fragments number the skin.
Physical Surface("bed", 10) = {22};
Physical Surface("touched", 11) = {24};
Physical Surface("side", 12) = {25};
