use super::GROUP;
use crate::program::{Builder, Op, Program, ValueId};
use crate::series::{Groups, SeriesPrograms, Slot};
use lagrange_expr::symbol::Role;

/// Products of each point: x x, y y, r r, r x, r y.
const ROLES: [[usize; 2]; 5] = [[0, 0], [1, 1], [2, 2], [0, 2], [1, 2]];

/// Returns the programs of distances r from x² + y², of this number of points. The kept values of a
/// point are x, y and r.
fn distances(points: usize) -> SeriesPrograms {
    let (mut builder, mut slots, mut sums) = (Builder::new(), Vec::new(), Vec::new());
    let mut input = |builder: &mut Builder, slot: Slot| -> ValueId {
        slots.push(slot);
        builder.push(Op::Input(Role::Placeholder(slots.len() as u32 - 1)))
    };
    let mut kept = Vec::new();
    for point in 0..points {
        let products = ROLES.map(|role| {
            sums.push(role.map(|factor| 3 * point + factor));
            input(&mut builder, Slot::Sum(sums.len() - 1))
        });
        let [xx, yy, rr, rx, ry] = products;
        kept.extend([rx, ry].map(|of| builder.add(of, rr)));
        let square = builder.add(xx, yy);
        let rest = builder.subtract(square, rr);
        let reciprocal = input(&mut builder, Slot::Initial(point));
        kept.push(builder.multiply(reciprocal, rest));
    }
    let none = || Builder::new().finish(&[]);
    SeriesPrograms {
        initial: none(),
        expansion: builder.finish(&kept),
        correction: None::<Program>,
        sums,
        carried: Vec::new(),
        slots,
        arguments: Vec::new(),
        initials: points,
        kept: 3 * points,
        blocks: Vec::new(),
    }
}

#[test]
fn the_lanes_of_every_group_belong_to_the_same_points() {
    for points in [8, 11, 20] {
        let groups = Groups::new(&distances(points));
        let mut lane_of = vec![None; points];
        let mut roles = vec![Vec::new(); groups.groups.len()];
        for product in 0..points * ROLES.len() {
            let [group, lane] = groups.of_product[product];
            let (point, role) = (product / ROLES.len(), product % ROLES.len());
            assert_eq!(*lane_of[point].get_or_insert(lane), lane, "point {point} of {points}");
            roles[group].push(role);
        }
        assert!(roles.iter().all(|roles| roles.iter().all(|role| *role == roles[0])), "{roles:?}");
        assert_eq!(groups.groups.len(), ROLES.len() * points.div_ceil(GROUP));
    }
}

/// A single point, more than can be in registers.
#[test]
fn parts_that_do_not_repeat_are_grouped_by_loads() {
    let programs =
        SeriesPrograms { sums: (0..9).flat_map(|a| (a..9).map(move |b| [a, b])).collect(), ..distances(3) };
    let groups = Groups::new(&programs);
    assert!(groups.groups.len() + groups.shared.len() <= 24, "{groups:?}");
}
