use std::str::FromStr;

use crate::number::{Field, Rational};

/// Where a picture is seen from: the direction to the viewer, in degrees.
///
/// The azimuth counts in the xy-plane from x to y, the elevation from there to z.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct View {
    azimuth: Rational,
    elevation: Rational,
}

/// The views that have a name, with azimuth and elevation.
const NAMED: &[(&str, i64, i64)] = &[
    ("iso", -60, 30),
    ("front", -90, 0),
    ("back", 90, 0),
    ("left", 180, 0),
    ("right", 0, 0),
    ("top", -90, 90),
    ("bottom", -90, -90),
];

impl View {
    /// How a view is written, for messages.
    pub const FORMS: &'static str =
        "`iso`, `front`, `back`, `left`, `right`, `top`, `bottom` or AZIMUTH,ELEVATION in degrees";

    /// The azimuth, at least 0 and less than 360.
    #[must_use]
    pub fn azimuth(&self) -> &Rational {
        &self.azimuth
    }

    /// The elevation, from −90 to 90.
    #[must_use]
    pub fn elevation(&self) -> &Rational {
        &self.elevation
    }

    /// A view by its angles; none if the elevation is not from −90 to 90.
    fn new(azimuth: &Rational, elevation: Rational) -> Option<Self> {
        let turn = Rational::from(360);
        let turns = azimuth.times(&turn.inverse()?).into_parts();
        let whole = turns.0.div_floor(&turns.1);
        let azimuth = azimuth.minus(&turn.times(&Rational::new(whole, 1.into())));
        let limit = Rational::from(90);
        let is_upright = elevation <= limit && elevation.negated() <= limit;
        is_upright.then_some(Self { azimuth, elevation })
    }
}

/// `iso`: from the front, the right and above.
impl Default for View {
    fn default() -> Self {
        Self {
            azimuth: Rational::from(300),
            elevation: Rational::from(30),
        }
    }
}

impl FromStr for View {
    type Err = String;

    /// A name, or two numbers with a comma between them.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let named = NAMED.iter().find(|(name, ..)| *name == text);
        let angles = named.map_or_else(
            || {
                let (azimuth, elevation) = text.split_once(',')?;
                let read = |own: &str| own.trim().parse::<Rational>().ok();
                Some((read(azimuth)?, read(elevation)?))
            },
            |(_, azimuth, elevation)| Some(((*azimuth).into(), (*elevation).into())),
        );
        angles
            .and_then(|(azimuth, elevation)| Self::new(&azimuth, elevation))
            .ok_or_else(|| format!("a view is {}", Self::FORMS))
    }
}
