//! Robots with inertia as parameters. Written by `tools/spatial_benches.py`.

lagrange::system! {
    /// `ur5` of `lagrange-core/tests/spatial/models`; its inertias are parameters.
    pub(crate) struct Ur5;
    param p0 = 3.7, p1 = 0.010267495893, p2 = 0.010267495893, p3 = 0.00666, p4 = 8.393, p5 = 0.28;
    param p6 = 0.22689067591, p7 = 0.22689067591, p8 = 0.0151074, p9 = 2.275, p10 = 0.24999999999999994, p11 = 0.049443313556;
    param p12 = 0.049443313556, p13 = 0.004095, p14 = 1.219, p15 = 0.111172755531, p16 = 0.111172755531, p17 = 0.21942;
    param p18 = 1.219, p19 = 0.111172755531, p20 = 0.111172755531, p21 = 0.21942, p22 = 0.1879, p23 = 0.0171364731454;
    param p24 = 0.0171364731454, p25 = 0.033822;
    gravity = (0, 0, -9.81);
    body l1 { mass: p0; inertia: (p1, p2, p3, 0, 0, 0); }
    revolute q1 = ground to l1 { at: (0, 0, 0.089159); }
    body l2 { mass: p4; centroid: (0, 0, p5); inertia: (p6, p7, p8, 0, 0, 0); }
    revolute q2 = l1 to l2 { at: (0, 0.13585, 0); turned: (0, pi/2, 0); axis: (0, 1, 0); }
    body l3 { mass: p9; centroid: (0, 0, p10); inertia: (p11, p12, p13, 0, 0, 0); }
    revolute q3 = l2 to l3 { at: (0, -0.1197, 0.425); axis: (0, 1, 0); }
    body l4 { mass: p14; inertia: (p15, p16, p17, 0, 0, 0); }
    revolute q4 = l3 to l4 { at: (0, 0, 0.39225); turned: (0, pi/2, 0); axis: (0, 1, 0); }
    body l5 { mass: p18; inertia: (p19, p20, p21, 0, 0, 0); }
    revolute q5 = l4 to l5 { at: (0, 0.093, 0); }
    body l6 { mass: p22; inertia: (p23, p24, p25, 0, 0, 0); }
    revolute q6 = l5 to l6 { at: (0, 0, 0.09465); axis: (0, 1, 0); }
    emit { prepared, no momenta, no forcing, no kinetic_energy, no potential_energy, no energy }
}

lagrange::system! {
    /// `panda` of `lagrange-core/tests/spatial/models`; its inertias are parameters.
    pub(crate) struct Panda;
    param p0 = 4.970684, p1 = 0.003875, p2 = 0.002081, p3 = -0.04762, p4 = 0.70337, p5 = 0.70661;
    param p6 = 0.009117, p7 = -0.000139, p8 = 0.006772, p9 = 0.019169, p10 = 0.646926, p11 = -0.003141;
    param p12 = -0.02872, p13 = 0.003495, p14 = 0.007962, p15 = 0.02811, p16 = 0.025995, p17 = -0.003925;
    param p18 = 0.010254, p19 = 0.000704, p20 = 3.228604, p21 = 0.027518, p22 = 0.039252, p23 = -0.066502;
    param p24 = 0.037242, p25 = 0.036155, p26 = 0.01083, p27 = -0.004761, p28 = -0.011396, p29 = -0.012805;
    param p30 = 3.587895, p31 = -0.05316999999999998, p32 = 0.10441899999999996, p33 = 0.02745399999999999, p34 = 0.025853, p35 = 0.019552;
    param p36 = 0.028323, p37 = 0.007796, p38 = -0.001332, p39 = 0.008641, p40 = 1.225946, p41 = -0.011953;
    param p42 = 0.041065, p43 = -0.038437, p44 = 0.035549, p45 = 0.029474, p46 = 0.008627, p47 = -0.002117;
    param p48 = -0.004037, p49 = 0.000229, p50 = 1.666555, p51 = 0.060149, p52 = -0.014117, p53 = -0.010517;
    param p54 = 0.0019640000000000005, p55 = 0.004354, p56 = 0.005433, p57 = 0.000109, p58 = -0.001158, p59 = 0.000341;
    param p60 = 1.4955219999999998, p61 = 0.0017208742976286579, p62 = 0.00136035441716123, p63 = 0.1004852811486558, p64 = 0.016529853712634626, p65 = 0.014107248642161839;
    param p66 = 0.006676955556640956, p67 = 0.0003948922971191777, p68 = -0.0007066957106145017, p69 = -0.001051105327046708;
    gravity = (0, 0, -9.81);
    body l1 { mass: p0; centroid: (p1, p2, p3); inertia: (p4, p5, p6, p7, p8, p9); }
    revolute q1 = ground to l1 { at: (0, 0, 0.333); }
    body l2 { mass: p10; centroid: (p11, p12, p13); inertia: (p14, p15, p16, p17, p18, p19); }
    revolute q2 = l1 to l2 { turned: (-pi/2, 0, 0); }
    body l3 { mass: p20; centroid: (p21, p22, p23); inertia: (p24, p25, p26, p27, p28, p29); }
    revolute q3 = l2 to l3 { at: (0, -0.316, 0); turned: (pi/2, 0, 0); }
    body l4 { mass: p30; centroid: (p31, p32, p33); inertia: (p34, p35, p36, p37, p38, p39); }
    revolute q4 = l3 to l4 { at: (0.0825, 0, 0); turned: (pi/2, 0, 0); }
    body l5 { mass: p40; centroid: (p41, p42, p43); inertia: (p44, p45, p46, p47, p48, p49); }
    revolute q5 = l4 to l5 { at: (-0.0825, 0.384, 0); turned: (-pi/2, 0, 0); }
    body l6 { mass: p50; centroid: (p51, p52, p53); inertia: (p54, p55, p56, p57, p58, p59); }
    revolute q6 = l5 to l6 { turned: (pi/2, 0, 0); }
    body l7 { mass: p60; centroid: (p61, p62, p63); inertia: (p64, p65, p66, p67, p68, p69); }
    revolute q7 = l6 to l7 { at: (0.088, 0, 0); turned: (pi/2, 0, 0); }
    emit { prepared, no momenta, no forcing, no kinetic_energy, no potential_energy, no energy }
}
