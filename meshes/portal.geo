// A portal of two legs under a flat circular arch, in mm. The span is 2400,
// the legs are 1500 high, the arch rises by 400 over their heads: its radius is
// (1200^2 + 400^2) / (2 * 400) = 2000.

Point(1) = {   0,    0, 0};
Point(2) = {   0, 1500, 0};
Point(3) = {1200, 1900, 0};
Point(4) = {2400, 1500, 0};
Point(5) = {2400,    0, 0};
Point(6) = {1200, -100, 0}; // centre of the arch

Line(1)   = {1, 2};
Circle(2) = {2, 6, 3};
Circle(3) = {3, 6, 4};
Line(4)   = {4, 5};

// One line element, that is one strut, for every curve. The second order gives
// it a node in its middle, which makes a strut of the arch an arc.
Transfinite Curve {1:4} = 2;
Mesh.ElementOrder = 2;

Physical Point("feet")  = {1, 5};
Physical Point("crown") = {3};

Physical Curve("legs")      = {1, 4};
Physical Curve("arch")      = {2, 3};
Physical Curve("left half") = {1, 2};
