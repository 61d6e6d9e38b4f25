lagrange::system! {
    /// Robot `TreeOf30`.
    #[derive(Clone, Debug)]
    pub struct TreeOf30;

    gravity = (0, 0, -9.81);

    body trunk { mass: 0.884; centroid: (-0.0212, -0.0287, 0.236); inertia: (0.0669, 0.0495, 0.0798); }
    free trunk;

    body link1 {
        mass: 3.75;
        centroid: (0.0411, -0.166, 0.0308);
        inertia: (0.15794778357198624, 0.14095174008818223, 0.14510047633983159,
            0.014664969187444858, 0.00008515567055911622, 0.00014009148909852672);
    }
    /// At most 10 N m and 2 rad/s.
    revolute joint1 = trunk to link1 { at: (-0.132, -0.227, -0.141); turned: (0.11, 0.651, 0.35); axis: (0, 1, 0); }

    body link2 { mass: 1.07; centroid: (-0.0284, 0.00852, 0.0374); inertia: (0.1102, 0.1829, 0.1243); }
    /// From -1 to 1 rad; at most 10 N m and 2 rad/s.
    revolute joint2 = link1 to link2 { at: (0.221, -0.0223, 0.175); turned: (-pi/2, -pi, -pi); axis: (1, 0, 0); }

    body link4 {
        mass: 1.86;
        centroid: (0.218, 0.00379, -0.0842);
        inertia: (0.16011629103693636, 0.13689279930322407, 0.11079090965983952,
            -0.012728019016592068, -0.012864540836813765, -0.0065776676029583245);
    }
    /// At most 10 N m and 2 rad/s.
    revolute joint4 = link1 to link4 { at: (0.188, -0.151, 0.296); turned: (pi, -pi/2, 0); axis: (0, 1, 0); }

    body link3 {
        mass: 1.66;
        centroid: (-0.0849, -0.219, 0.0405);
        inertia: (0.10470446683321838, 0.11210175055839802, 0.08319378260838357,
            -0.009200733315718981, -0.0037894900820889966, 0.00046862829872164856);
    }
    /// From -1 to 1 rad; at most 10 N m and 2 rad/s.
    revolute joint3 = trunk to link3 {
        at: (0.146, -0.435, 0.0154);
        turned: (0, -pi, pi/2);
        axis: (0.252, 0.221, -0.723);
    }

    body link5 {
        mass: 0.609;
        centroid: (0.227, 0.0225, 0.166);
        inertia: (0.17056338187650588, 0.16736438345515006, 0.17207223466834398,
            0.0023830267234388816, 0.0011612790732044055, 0.002890259406011758);
    }
    /// From -1 to 1 m; at most 10 N and 2 m/s.
    prismatic joint5 = link3 to link5 { at: (0.558, -0.397, 0.075); turned: (pi, pi, pi); }

    body link6 { mass: 3.68; centroid: (0.0274, -0.136, -0.096); inertia: (0.0847, 0.0896, 0.0885); }
    /// From -1 to 1 rad; at most 10 N m and 2 rad/s.
    revolute joint6 = link3 to link6 { at: (0.0448, -0.17, 0.128); turned: (pi, pi/2, pi); }

    body link7 { mass: 2.65; centroid: (0.163, 0.0946, 0.0493); inertia: (0.1455, 0.1815, 0.1374); }
    weld link6 to link7 { at: (0.393, 0.491, -0.186); turned: (pi, pi/2, pi); }

    body link8 {
        mass: 2.41;
        centroid: (0.0205, -0.0265, -0.0734);
        inertia: (0.12531459863170838, 0.09296756739138524, 0.06891783397690639,
            0.0007793331715911104, -0.0150584287969032, 0.006270074440792283);
    }
    /// From -1 to 1 rad; at most 10 N m and 2 rad/s.
    revolute joint8 = link7 to link8 {
        at: (-0.126, 0.0747, -0.696);
        turned: (-0.0874, 0.228, 1.33);
        axis: (1.77, 1.11, 0.863);
    }

    body link9 {
        mass: 0.97;
        centroid: (0.158, 0.022, 0.0295);
        inertia: (0.0899752572558828, 0.09461640246823018, 0.10540834027588697,
            -0.0021100455282130302, -0.0053048166033237525, -0.0028146512517848842);
    }
    /// From -1 to 1 rad; at most 10 N m and 2 rad/s.
    revolute joint9 = link8 to link9 { at: (0.587, -0.364, -0.163); turned: (-0.174, 1.42, -0.132); axis: (0, 1, 0); }

    body link10 { mass: 1.26; centroid: (0.03, 0.141, -0.00468); inertia: (0.1114, 0.066, 0.089); }
    weld link9 to link10 { at: (-0.269, 0.14, -0.103); turned: (0.525, -0.0162, -1.19); }

    body link11 {
        mass: 1.02;
        centroid: (0.0195, -0.123, -0.234);
        inertia: (0.03241627758539463, 0.04237479122572485, 0.04000893118888052,
            0.0005254909321853263, -0.001535194299275015, -0.004623933211759589);
    }
    /// From -1 to 1 rad; at most 10 N m and 2 rad/s.
    revolute joint11 = link9 to link11 { at: (-0.0118, -0.055, 0.149); turned: (-pi/2, pi/2, pi/2); }

    body link13 {
        mass: 2.38;
        centroid: (-0.00225, -0.0813, -0.112);
        inertia: (0.11875597038692909, 0.1201199876570269, 0.118124041956044,
            0.002015406298467741, 0.00012774233166677924, 0.00033347668499803147);
    }
    /// From -1 to 1 m; at most 10 N and 2 m/s.
    prismatic joint13 = link11 to link13 {
        at: (-0.368, -0.0429, 0.275);
        turned: (pi/2, -pi/2, -pi);
        axis: (-0.031, 0.298, 1.12);
    }

    body link15 {
        mass: 3.61;
        centroid: (-0.0563, -0.0443, 0.0656);
        inertia: (0.06879522192949956, 0.10940227200563168, 0.10180250606486875,
            0.017728170433980155, -0.008671623849684073, -0.013133543016561186);
    }
    weld link13 to link15 { at: (-0.0294, 0.409, -0.451); turned: (1.82, 0.223, 1.03); }

    body link19 {
        mass: 3.81;
        centroid: (0.0625, 0.157, 0.0188);
        inertia: (0.17071529947081984, 0.17495398558011482, 0.17913071494906532,
            0.006318155672028439, -0.0042336498365623185, 0.006208488301863678);
    }
    weld link15 to link19 { at: (0.294, -0.176, 0.148); turned: (1, 1.4, 1.82); }

    body link20 { mass: 1.2; centroid: (0.245, 0.0549, 0.0438); inertia: (0.1181, 0.1384, 0.0663); }
    /// At most 10 N m and 2 rad/s.
    revolute joint20 = link19 to link20 { at: (-0.175, 0.208, 0.292); turned: (pi, pi, pi/2); }

    body link21 {
        mass: 3.6;
        centroid: (0.0911, 0.0104, 0.0317);
        inertia: (0.10861847229699882, 0.10910494385926944, 0.11827658384373176,
            -0.0047503532807574005, -0.0017345471513063905, -0.006401538696448078);
    }
    /// From -1 to 1 rad; at most 10 N m and 2 rad/s.
    revolute joint21 = link20 to link21 { at: (-0.306, -0.199, -0.011); turned: (0, 0, -pi); axis: (0, 1, 0); }

    body link22 { mass: 2.77; centroid: (-0.00569, 0.0122, -0.0362); inertia: (0.1439, 0.1056, 0.1485); }
    /// From -1 to 1 rad; at most 10 N m and 2 rad/s.
    revolute joint22 = link21 to link22 { at: (-0.119, 0.351, -0.307); turned: (pi/2, pi, -pi); axis: (0, 1, 0); }

    body link25 {
        mass: 1.77;
        centroid: (-0.0669, -0.0606, -0.0883);
        inertia: (0.14125323521955332, 0.14444258975711904, 0.12630417502332764,
            -0.000542579892820777, 0.013531893349324177, -0.006068118111392278);
    }
    /// From -1 to 1 m; at most 10 N and 2 m/s.
    prismatic joint25 = link21 to link25 { at: (0.123, 0.144, 0.0283); turned: (-pi/2, -pi/2, 0); }

    body link24 {
        mass: 1.73;
        centroid: (-0.0656, 0.15, 0.0492);
        inertia: (0.08088885717054176, 0.07306793946903699, 0.09244320336042125,
            -0.0021622784838865733, 0.018320176416287394, 0.002692074991999527);
    }
    weld link20 to link24 { at: (0.547, -0.123, -0.235); turned: (-0.626, 0.671, 1.76); }

    body link27 {
        mass: 2.65;
        centroid: (0.0818, -0.156, 0.0719);
        inertia: (0.14802359223913172, 0.1928910229634787, 0.1512853847973896,
            -0.0013154916904243924, 0.002142234364483486, 0.003426541588238999);
    }
    weld link24 to link27 { at: (0.327, -0.0715, -0.433); turned: (-0.592, 1.11, 0.756); }

    body link28 {
        mass: 1.6;
        centroid: (-0.049, 0.146, -0.104);
        inertia: (0.14464211239566865, 0.14160478119539444, 0.1463531064089369,
            0.00023884980823851362, 0.00027795703774560407, 0.0009810428344769126);
    }
    /// From -1 to 1 rad; at most 10 N m and 2 rad/s.
    revolute joint28 = link24 to link28 { at: (0.0836, 0.299, -0.263); turned: (pi/2, -pi/2, pi); }

    body link29 { mass: 2.99; centroid: (0.0662, -0.114, -0.0948); inertia: (0.1206, 0.1256, 0.068); }
    /// From -1 to 1 rad; at most 10 N m and 2 rad/s.
    revolute joint29 = link28 to link29 {
        at: (0.068, -0.466, 0.0201);
        turned: (-0.184, -0.959, 0.138);
        axis: (-0.972, 0.186, -0.439);
    }

    body link23 {
        mass: 2.52;
        centroid: (-0.102, 0.0531, -0.0679);
        inertia: (0.10261918666420222, 0.14889511054356985, 0.09728570279222788,
            -0.0224647248715941, -0.0007395969090706728, 0.0022714403502376787);
    }
    /// From -1 to 1 rad; at most 10 N m and 2 rad/s.
    revolute joint23 = link19 to link23 { at: (0.0906, -0.765, -0.275); turned: (pi, -pi, -pi); axis: (1, 0, 0); }

    body link26 { mass: 2.98; centroid: (-0.0085, -0.0773, 0.0576); inertia: (0.1275, 0.141, 0.1393); }
    /// At most 10 N m and 2 rad/s.
    revolute joint26 = link23 to link26 {
        at: (-0.000468, 0.238, -0.174);
        turned: (0, pi/2, -pi);
        axis: (-1.5, 0.0424, -1.45);
    }

    body link17 {
        mass: 3.88;
        centroid: (-0.0394, 0.0737, 0.0404);
        inertia: (0.1167710748774591, 0.15047989398694828, 0.12454903113559262,
            0.01724245381163085, -0.012230484085402907, -0.02266166931192174);
    }
    /// From -1 to 1 rad; at most 10 N m and 2 rad/s.
    revolute joint17 = link13 to link17 { at: (-0.0643, 0.498, -0.249); turned: (-pi/2, -pi, -pi); axis: (1, 0, 0); }

    body link18 { mass: 1.81; centroid: (-0.104, -0.271, 0.0363); inertia: (0.0832, 0.1214, 0.1332); }
    weld link17 to link18 { at: (0.323, 0.25, 0.232); turned: (pi, pi/2, pi/2); }

    body link14 { mass: 2.22; centroid: (-0.00756, 0.0113, 0.165); inertia: (0.1215, 0.0749, 0.074); }
    /// From -1 to 1 rad; at most 10 N m and 2 rad/s.
    revolute joint14 = link11 to link14 { at: (0.144, 0.45, 0.388); turned: (-0.695, 0.018, 1.33); axis: (0, 1, 0); }

    body link12 {
        mass: 2.82;
        centroid: (-0.0313, -0.109, -0.057);
        inertia: (0.12202012087329625, 0.14250980177061862, 0.1416700773560851,
            0.00549796909211887, 0.012018179092630817, -0.005946725889307794);
    }
    weld link8 to link12 { at: (0.628, -0.42, 0.35); turned: (0.539, -0.133, -0.194); }

    body link16 { mass: 2.94; centroid: (-0.0758, -0.0963, -0.0816); inertia: (0.1434, 0.1733, 0.1389); }
    /// From -1 to 1 rad; at most 10 N m and 2 rad/s.
    revolute joint16 = link12 to link16 { at: (0.0233, 0.342, -0.558); turned: (-pi, pi/2, -pi); axis: (0, 1, 0); }

    input u_joint1, u_joint2, u_joint4, u_joint3, u_joint5, u_joint6, u_joint8, u_joint9, u_joint11, u_joint13,
         u_joint20, u_joint21, u_joint22, u_joint25, u_joint28, u_joint29, u_joint23, u_joint26, u_joint17, u_joint14,
         u_joint16;
    force joint1 = u_joint1;
    force joint2 = u_joint2;
    force joint4 = u_joint4;
    force joint3 = u_joint3;
    force joint5 = u_joint5;
    force joint6 = u_joint6;
    force joint8 = u_joint8;
    force joint9 = u_joint9;
    force joint11 = u_joint11;
    force joint13 = u_joint13;
    force joint20 = u_joint20;
    force joint21 = u_joint21;
    force joint22 = u_joint22;
    force joint25 = u_joint25;
    force joint28 = u_joint28;
    force joint29 = u_joint29;
    force joint23 = u_joint23;
    force joint26 = u_joint26;
    force joint17 = u_joint17;
    force joint14 = u_joint14;
    force joint16 = u_joint16;
}
