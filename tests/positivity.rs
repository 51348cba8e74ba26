//! Weights that become positive: by one patch, by elevation, by cuts, or not.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    missing_docs,
    reason = "tests state facts"
)]

mod nets;

use nets::{number, sum};
use sweepc::check::Positivity;
use sweepc::net::{ControlNet, Part};
use sweepc::number::{Field, Real};
use sweepc::poly::{BiDegree, BiPoly};
use sweepc::sweep::Domain;

fn positivity(weight: &BiPoly<Real>, degree: BiDegree) -> Result<Positivity, &'static str> {
    Positivity::of(weight, degree, &Domain::unit())
}

/// The surface (u, v, W)/W as a net of a bidegree that is not lower than that of (u, v).
fn net(weight: &BiPoly<Real>, degree: BiDegree) -> ControlNet {
    let (zero, one) = (number("0"), number("1"));
    let (u, v) = (sum(&[("0 1", "1")]), sum(&[("1", "0 1")]));
    let net = ControlNet::bezier([weight, &u, &v, weight], (&zero, &one), (&zero, &one));
    net.unwrap().elevated(degree).unwrap()
}

/// The number of patches, after the weights of each were computed once more by the polar form of
/// the whole net, and the rectangles were seen to fill the domain.
fn patches(weight: &BiPoly<Real>, degree: BiDegree) -> usize {
    let found = positivity(weight, degree).unwrap();
    let net = net(weight, degree);
    let mut area = Real::zero();
    for own in &found.rectangles {
        let (u, v) = ((own.u.start(), own.u.end()), (own.v.start(), own.v.end()));
        let part = net.restricted(u, v).unwrap();
        assert!(part.elevated(found.degree).unwrap().all_positive());
        area = area.plus(&u.1.minus(u.0).times(&v.1.minus(v.0)));
    }
    assert_eq!(area, Real::one());
    // Disjoint rectangles within the domain with its area fill it.
    for (index, one) in found.rectangles.iter().enumerate() {
        for other in &found.rectangles[..index] {
            let apart_u = one.u.start() >= other.u.end() || other.u.start() >= one.u.end();
            let apart_v = one.v.start() >= other.v.end() || other.v.start() >= one.v.end();
            assert!(apart_u || apart_v);
        }
    }
    let part = Part::of_net("R", net);
    let written = part.patches().unwrap();
    assert!(written.iter().all(|own| own.net.all_positive()));
    assert_eq!(written.len(), found.rectangles.len());
    found.rectangles.len()
}

fn cuts(weight: &BiPoly<Real>, degree: BiDegree) -> [Vec<String>; 2] {
    let found = positivity(weight, degree).unwrap();
    let cuts = found.cuts().unwrap();
    cuts.map(|own| own.iter().map(ToString::to_string).collect())
}

#[test]
fn positive_weights_need_nothing() {
    let weight = sum(&[("1 0 1", "2 -1")]);
    let degree = BiDegree::new(2, 3);
    assert_eq!(patches(&weight, degree), 1);
    assert_eq!(positivity(&weight, degree).unwrap().degree, degree);
}

#[test]
fn a_small_elevation_is_better_than_a_cut() {
    // Weights 2, -1/2, 2; in degree 3: 2, 1/3, 1/3, 2.
    let weight = sum(&[("2 -5 5", "1")]);
    let degree = BiDegree::new(2, 1);
    assert_eq!(patches(&weight, degree), 1);
    assert_eq!(
        positivity(&weight, degree).unwrap().degree,
        BiDegree::new(3, 1)
    );
    // In degree 25 there is no room for it; there these weights are positive anyway.
    let high = BiDegree::new(25, 1);
    assert_eq!(positivity(&weight, high).unwrap().degree, high);
}

#[test]
fn a_product_is_cut_in_each_direction_by_itself() {
    // 1 - 3t + 3t^2 has the weights 1, -1/2, 1 and is not positive up to degree 4.
    let degree = BiDegree::new(2, 2);
    let weight = sum(&[("1 -3 3", "1")]);
    assert_eq!(patches(&weight, degree), 2);
    assert_eq!(cuts(&weight, degree), [vec!["1/2".to_owned()], vec![]]);
    let weight = sum(&[("1 -3 3", "1 -3 3")]);
    assert_eq!(patches(&weight, degree), 4);
    // Both factors negative on the domain: the product is positive.
    let weight = sum(&[("-1 3 -3", "-1 3 -3")]);
    assert_eq!(patches(&weight, degree), 4);
}

#[test]
fn cuts_are_few_and_simple() {
    let degree = BiDegree::new(2, 1);
    // (3t - 1)^2 + 1/100: the half is of no use, only a place very near to 1/3 is.
    let weight = sum(&[("101/100 -6 9", "1")]);
    assert_eq!(patches(&weight, degree), 2);
    let [u, _] = cuts(&weight, degree);
    let [cut] = u.as_slice() else {
        panic!("one cut");
    };
    let cut = number(cut);
    let denominator = cut.denominator().clone();
    let coarser = (1..64).map(|own| Real::ratio(own.into(), 64.into()));
    let coarser = coarser.filter(|own| *own.denominator() < denominator);
    // No fraction with a smaller power of two would do.
    for other in coarser {
        let both = [(&number("0"), &other), (&other, &number("1"))];
        let net = net(&weight, degree);
        let (from, to) = (number("0"), number("1"));
        let sound = both
            .iter()
            .all(|u| net.restricted(*u, (&from, &to)).unwrap().all_positive());
        assert!(!sound, "{other}");
    }
}

#[test]
fn other_weights_are_halved() {
    // 1 - 3uv + 3u^2v^2 is positive and no product.
    let weight = sum(&[("1", "1"), ("0 -3", "0 1"), ("0 0 3", "0 0 1")]);
    let count = patches(&weight, BiDegree::new(2, 2));
    assert!((2..=8).contains(&count), "{count}");
}

#[test]
fn what_cannot_be_positive_is_said() {
    let degree = BiDegree::new(4, 1);
    // W = 0 at u = 1, and W < 0 there.
    for weight in [sum(&[("1 -1", "1")]), sum(&[("1 -2", "1")])] {
        let reason = positivity(&weight, degree).unwrap_err();
        assert!(reason.contains("corner"), "{reason}");
    }
    // (u^2 - 1/2)^2 + 10^-40 is positive, and all but 0 at an irrational place.
    let tiny = format!("{} 0 -1 0 1", number("1/4").plus(&number("1e-40")));
    let reason = positivity(&sum(&[(&tiny, "1")]), degree).unwrap_err();
    assert!(reason.contains("64"), "{reason}");
    // 10^-3 instead of 10^-40 needs a few cuts only.
    let small = format!("{} 0 -1 0 1", number("1/4").plus(&number("1e-3")));
    let count = patches(&sum(&[(&small, "1")]), degree);
    assert!((2..=5).contains(&count), "{count}");
}
