// A ball in a box, coarse: how gmsh made the files beside this one, gmsh 4.8.4.
//   gmsh ball.geo -3 -format msh22 -o ball-22.msh ; ... -bin -format msh41 -o ball-41-binary.msh
SetFactory("OpenCASCADE");
Mesh.MeshSizeMin = 0.7;
Mesh.MeshSizeMax = 0.7;
Box(1) = {-1, -1, -1, 4, 2, 2};
Sphere(2) = {0, 0, 0, 0.5};
BooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
ball() = Surface In BoundingBox {-0.6, -0.6, -0.6, 0.6, 0.6, 0.6};
inlet() = Surface In BoundingBox {-1.1, -1.1, -1.1, -0.9, 1.1, 1.1};
outlet() = Surface In BoundingBox {2.9, -1.1, -1.1, 3.1, 1.1, 1.1};
all() = Surface {:};
Physical Surface("ball wall") = ball();
Physical Surface("inlet") = inlet();
Physical Surface("outlet") = outlet();
all() -= ball();
all() -= inlet();
all() -= outlet();
Physical Surface("symmetry sides") = all();
Physical Volume("air") = {3};
