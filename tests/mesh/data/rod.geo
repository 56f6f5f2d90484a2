// A rod of 1 x 1 x 3 with a tetrahedral mesh to be made; lengths in cm.
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 3, 1, 1};
