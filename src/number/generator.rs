use std::fmt;
use std::sync::{Arc, Mutex, OnceLock};

use super::enclosure::refine;
use super::{Enclosure, Integer, Leading, Modulus, Place, Ring, SurdInteger};

/// How many primes that have a place one level down are tried for the next [`Place`]. About half
/// of them have one.
const PRIMES: usize = 64;

/// A generator √a of a tower of real fields: the positive root of a radicand a that lies in the
/// levels below, is positive, and is no square there.
///
/// It knows the generators below it, so an element of the tower knows its field.
#[derive(Clone)]
pub struct Generator(Arc<Inner>);

struct Inner {
    square: SurdInteger,
    below: Option<Generator>,
    level: usize,
    /// √a at the greatest precision that was needed so far.
    enclosure: Mutex<Option<Enclosure>>,
    leading: OnceLock<Option<Leading>>,
    places: Mutex<Places>,
}

/// The places that were found so far, at most one over each prime.
#[derive(Default)]
struct Places {
    found: Vec<Place>,
    /// How many of the primes were tried.
    tried: usize,
    /// The primes in turn, for the first level only; those above take the primes from below.
    primes: Option<Box<dyn Iterator<Item = Modulus> + Send>>,
}

impl Generator {
    /// √a over the field of the generators up to `below`.
    ///
    /// The radicand lies in that field, is positive and is no square there.
    pub(super) fn new(square: SurdInteger, below: Option<Self>) -> Self {
        let level = below.as_ref().map_or(0, Self::level) + 1;
        Self(Arc::new(Inner {
            square,
            below,
            level,
            enclosure: Mutex::new(None),
            leading: OnceLock::new(),
            places: Mutex::default(),
        }))
    }

    /// a
    #[must_use]
    pub fn square(&self) -> &SurdInteger {
        &self.0.square
    }

    /// The generator of the next level below; none on the ground.
    #[must_use]
    pub fn below(&self) -> Option<&Self> {
        self.0.below.as_ref()
    }

    /// The number of generators up to this one: 1 for the first.
    #[must_use]
    pub fn level(&self) -> usize {
        self.0.level
    }

    /// This generator and those below it, from the ground up.
    #[must_use]
    pub fn chain(&self) -> Vec<Self> {
        let mut chain = vec![self.clone()];
        let mut next = self.below();
        while let Some(own) = next {
            chain.push(own.clone());
            next = own.below();
        }
        chain.reverse();
        chain
    }

    /// An interval around √a of at most four steps at the precision.
    #[must_use]
    pub fn enclose(&self, precision: u32) -> Enclosure {
        let Ok(mut known) = self.0.enclosure.lock() else {
            return self.enclose_anew(precision);
        };
        match known.as_ref() {
            Some(own) if own.precision() >= precision => own.coarser(precision),
            _ => {
                // Somewhat more, as the next question will ask for more.
                let own = self.enclose_anew(precision + 64);
                known.insert(own).coarser(precision)
            }
        }
    }

    fn enclose_anew(&self, precision: u32) -> Enclosure {
        refine(|guard| {
            let root = self.0.square.enclose(precision + guard).square_root();
            let root = root.coarser(precision);
            (root.width() <= Integer::from(3)).then_some(root)
        })
    }

    /// The leading digits of √a; none for roots below 2⁻³⁸⁴⁰ or so.
    pub(super) fn leading(&self) -> Option<Leading> {
        let precisions = || (0..6).map(|step| 128_u32 << step);
        let find = || precisions().find_map(|own| Leading::of_enclosure(&self.enclose(own)));
        *self.0.leading.get_or_init(find)
    }

    /// A homomorphism of the numerators up to this level to a prime field; none if none was found
    /// among the primes that were tried.
    #[must_use]
    pub fn place(&self) -> Option<Place> {
        self.place_at(0)
    }

    /// The places in turn, each over a prime of its own.
    pub(super) fn places(&self) -> impl Iterator<Item = Place> + '_ {
        (0..).map_while(|index| self.place_at(index))
    }

    /// Primes with a place are not rare: each has one on average. (Chebotarev's density theorem)
    /// A place lies over one of the level below.
    fn place_at(&self, index: usize) -> Option<Place> {
        let mut places = self.0.places.lock().ok()?;
        let chain = self.chain();
        let mut failures = 0;
        while places.found.len() <= index && failures < PRIMES {
            let modulus = match self.below() {
                Some(below) => *below.place_at(places.tried)?.modulus(),
                None => places.primes.get_or_insert_with(primes).next()?,
            };
            places.tried += 1;
            match roots_modulo(&chain, modulus, &mut Vec::new()) {
                Some(place) => places.found.push(place),
                None => failures += 1,
            }
        }
        places.found.get(index).cloned()
    }
}

/// The primes in the order in which they are tried.
fn primes() -> Box<dyn Iterator<Item = Modulus> + Send> {
    let first = std::iter::once(Modulus::mersenne());
    Box::new(first.chain(Modulus::descending()))
}

/// Completes the images of the first generators to those of all; either sign of a root may lead
/// on.
fn roots_modulo(chain: &[Generator], modulus: Modulus, roots: &mut Vec<u64>) -> Option<Place> {
    let Some(next) = chain.get(roots.len()) else {
        return Some(Place::new(modulus, roots.clone()));
    };
    let image = next.square().image(&Place::new(modulus, roots.clone()));
    let root = modulus.square_root(image)?;
    if root == 0 {
        return None;
    }
    for own in [root, modulus.minus(0, root)] {
        roots.push(own);
        if let Some(place) = roots_modulo(chain, modulus, roots) {
            return Some(place);
        }
        roots.pop();
    }
    None
}

/// Equal radicands over equal towers.
impl PartialEq for Generator {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
            || (self.0.level == other.0.level
                && self.0.square == other.0.square
                && self.0.below == other.0.below)
    }
}

impl Eq for Generator {}

/// `√2`, `√(-35 + 40*√2)`
impl fmt::Display for Generator {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.0.square {
            SurdInteger::Rational(own) => write!(formatter, "√{own}"),
            own @ SurdInteger::Irrational(_) => write!(formatter, "√({own})"),
        }
    }
}

impl fmt::Debug for Generator {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, formatter)
    }
}
