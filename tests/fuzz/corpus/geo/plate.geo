h = 0.2; r = Sqrt(2) / 8;
Point(1) = {0, 0, 0, h}; Point(2) = {2, 0, 0, h}; Point(3) = {2, 1, 0, h / 10}; Point(4) = {0, 1, 0, h};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Point(10) = {1, 0.5, 0};
For i In {0:3}
  Point(11 + i) = {1 + r * Cos(i * Pi / 2), 0.5 + r * Sin(i * Pi / 2), 0, h / 4};
EndFor
For i In {0:3}
  If (i < 3)
    Circle(11 + i) = {11 + i, 10, 12 + i};
  Else
    Circle(14) = {14, 10, 11};
  EndIf
  c[] += 11 + i;
EndFor
Curve Loop(1) = {1:4}; Curve Loop(2) = {c[]}; Plane Surface(1) = {1, 2};
Transfinite Curve {1} = 11 Using Progression 1.1;
Physical Surface("plate", 5) = {1}; Physical Curve("hole") = {c[]}; Physical Point(9) = {1};
