//! Which characters make up names, which are folded into one, and which only look right.

/// The one spelling under which a name is known.
///
/// `sigma`, `kappa`, `rho` become `σ`, `κ`, `ρ`; `µ` `ϰ` `ϱ` `ϵ` `ϕ` become `μ` `κ` `ρ` `ε` `φ`.
///
/// ```
/// use sweepc::syntax::canonical_name;
/// assert_eq!(canonical_name("sigma"), "σ");
/// assert_eq!(canonical_name("\u{b5}1"), "\u{3bc}1");
/// assert_eq!(canonical_name("sigma_1"), "sigma_1");
/// ```
#[must_use]
pub fn canonical_name(word: &str) -> String {
    match word {
        "sigma" => "σ".to_owned(),
        "kappa" => "κ".to_owned(),
        "rho" => "ρ".to_owned(),
        _ if word.is_ascii() => word.to_owned(),
        _ => word.chars().map(|c| folded(c).unwrap_or(c)).collect(),
    }
}

/// The letter that a variant form of a Greek letter stands for.
fn folded(c: char) -> Option<char> {
    Some(match c {
        '\u{B5}' => 'μ',
        'ϰ' => 'κ',
        'ϱ' => 'ρ',
        'ϵ' => 'ε',
        'ϕ' => 'φ',
        _ => return None,
    })
}

/// Whether a name may hold the character (an ASCII digit only behind its start).
pub(super) fn is_name_character(c: char) -> bool {
    match c {
        '\0'..='\x7F' => c == '_' || c.is_ascii_alphanumeric(),
        'Α'..='Ρ' | 'Σ'..='Ω' | 'α'..='ρ' | 'σ'..='ω' => true,
        _ => folded(c).is_some(),
    }
}

/// Whether a word goes on with this character, be it right or a look-alike.
pub(super) fn is_word_character(c: char) -> bool {
    is_name_character(c) || (!c.is_ascii() && looks_like_letter(c))
}

fn looks_like_letter(c: char) -> bool {
    is_invisible(c)
        || matches!(c, '\u{300}'..='\u{36F}')
        || c.is_alphabetic()
        || letter_meant(c).is_some()
}

/// Characters without width and those that reorder the line they stand in.
pub(super) fn is_invisible(c: char) -> bool {
    reorders(c)
        || matches!(c, '\u{AD}' | '\u{34F}' | '\u{61C}' | '\u{180E}' | '\u{200B}'..='\u{200F}'
            | '\u{2060}'..='\u{206F}' | '\u{FE00}'..='\u{FE0F}' | '\u{FEFF}' | '\u{E0000}'..='\u{E01EF}')
}

/// Characters that make a line look like another one, in comments and strings too.
pub(super) fn reorders(c: char) -> bool {
    matches!(c, '\u{202A}'..='\u{202E}' | '\u{2066}'..='\u{2069}')
}

/// The letter, digit or underscore that a foreign character looks like.
pub(super) fn letter_meant(c: char) -> Option<char> {
    match c {
        '\u{FF10}'..='\u{FF19}'
        | '\u{FF21}'..='\u{FF3A}'
        | '\u{FF41}'..='\u{FF5A}'
        | '\u{FF3F}' => char::from_u32(u32::from(c) - 0xFEE0),
        '\u{2080}'..='\u{2089}' => char::from_u32(u32::from(c) - 0x2080 + u32::from('0')),
        '\u{1D400}'..='\u{1D7FF}' => mathematical(u32::from(c)),
        '\u{400}'..='\u{52F}' => cyrillic(c),
        _ => letterlike(c),
    }
}

/// The mathematical alphanumeric symbols: 13 Latin alphabets, 5 Greek ones, 5 sets of digits.
fn mathematical(code: u32) -> Option<char> {
    const GREEK_TAIL: [char; 8] = ['ω', '∂', 'ε', 'θ', 'κ', 'φ', 'ρ', 'π'];
    let at = |start: char, index: u32| char::from_u32(u32::from(start) + index);
    match code {
        0x1D400..=0x1D6A3 => match (code - 0x1D400) % 52 {
            index @ 0..=25 => at('A', index),
            index => at('a', index - 26),
        },
        0x1D6A4 => Some('i'),
        0x1D6A5 => Some('j'),
        0x1D6A8..=0x1D7C9 => match (code - 0x1D6A8) % 58 {
            17 => Some('Θ'),
            25 | 51 => None,
            43 => Some('σ'),
            index @ 0..=24 => at('Α', index),
            index @ 26..=49 => at('α', index - 26),
            index => GREEK_TAIL.get(index as usize - 50).copied(),
        },
        0x1D7CE..=0x1D7FF => at('0', (code - 0x1D7CE) % 10),
        _ => None,
    }
}

fn cyrillic(c: char) -> Option<char> {
    const PAIRS: [(char, char); 40] = [
        ('а', 'a'),
        ('е', 'e'),
        ('о', 'o'),
        ('р', 'p'),
        ('с', 'c'),
        ('у', 'y'),
        ('х', 'x'),
        ('і', 'i'),
        ('ј', 'j'),
        ('ѕ', 's'),
        ('һ', 'h'),
        ('ԁ', 'd'),
        ('ԛ', 'q'),
        ('ԝ', 'w'),
        ('к', 'k'),
        ('т', 't'),
        ('п', 'n'),
        ('г', 'r'),
        ('ѵ', 'v'),
        ('в', 'b'),
        ('А', 'A'),
        ('В', 'B'),
        ('Е', 'E'),
        ('К', 'K'),
        ('М', 'M'),
        ('Н', 'H'),
        ('О', 'O'),
        ('Р', 'P'),
        ('С', 'C'),
        ('Т', 'T'),
        ('У', 'Y'),
        ('Х', 'X'),
        ('І', 'I'),
        ('Ј', 'J'),
        ('Ѕ', 'S'),
        ('Ԛ', 'Q'),
        ('Ԝ', 'W'),
        ('Ѵ', 'V'),
        ('Ү', 'Y'),
        ('Ԍ', 'G'),
    ];
    PAIRS.iter().find(|(from, _)| *from == c).map(|(_, to)| *to)
}

/// Variant Greek letters and single letters of other blocks.
fn letterlike(c: char) -> Option<char> {
    Some(match c {
        'ς' | 'ϲ' => 'σ',
        'ϑ' => 'θ',
        'ϖ' => 'π',
        'ϴ' => 'Θ',
        'ϒ' => 'Υ',
        '\u{2126}' => 'Ω',
        '\u{2206}' => 'Δ',
        '\u{220F}' => 'Π',
        '\u{2211}' => 'Σ',
        '\u{212A}' => 'K',
        'ɑ' => 'a',
        'ℬ' => 'B',
        'ℂ' | 'ℭ' => 'C',
        'ⅅ' => 'D',
        'ⅆ' => 'd',
        'ℰ' => 'E',
        'ℯ' | 'ⅇ' => 'e',
        'ℱ' => 'F',
        'ℊ' | 'ɡ' => 'g',
        'ℋ' | 'ℌ' | 'ℍ' => 'H',
        'ℎ' => 'h',
        'ℐ' | 'ℑ' => 'I',
        'ⅈ' | 'ı' => 'i',
        'ⅉ' | 'ȷ' | 'ϳ' => 'j',
        'ℒ' => 'L',
        'ℓ' => 'l',
        'ℳ' => 'M',
        'ℕ' => 'N',
        'ℴ' => 'o',
        'ℙ' => 'P',
        '℘' => 'p',
        'ℚ' => 'Q',
        'ℛ' | 'ℜ' | 'ℝ' => 'R',
        'ſ' => 's',
        'ℤ' | 'ℨ' => 'Z',
        _ => return None,
    })
}

/// The sign or space of the language that a foreign character looks like.
pub(super) fn sign_meant(c: char) -> Option<&'static str> {
    Some(match c {
        '\u{2010}'..='\u{2015}' | '\u{FE63}' | '\u{FF0D}' | '\u{2796}' => "-",
        '\u{FF0B}' | '\u{2795}' => "+",
        '\u{2217}' | '\u{22C5}' | '\u{2219}' | '\u{2022}' | '\u{FF0A}' | '\u{2715}'
        | '\u{2716}' => "*",
        '÷' | '\u{2044}' | '\u{2215}' | '\u{FF0F}' => "/",
        '\u{2C6}' | '\u{FF3E}' => "^",
        '\u{FF08}' => "(",
        '\u{FF09}' => ")",
        '\u{FF3B}' => "[",
        '\u{FF3D}' => "]",
        '\u{FF0C}' | '\u{201A}' | '\u{3001}' => ",",
        '\u{FF1A}' | '\u{2236}' => ":",
        '\u{FF1B}' | '\u{37E}' => ";",
        '\u{FF0E}' | '\u{3002}' => ".",
        '\u{FF1D}' => "=",
        '\u{2260}' => "!=",
        '\u{2264}' | '\u{2A7D}' => "<=",
        '\u{2265}' | '\u{2A7E}' => ">=",
        '\u{2261}' => "==",
        '\u{FF1C}' => "<",
        '\u{FF1E}' => ">",
        '`' | '\u{B4}' | '\u{2018}' | '\u{2B9}' | '\u{2BC}' | '\u{2035}' | '\u{FF07}' => "'",
        '\u{2034}' => "'''",
        '\u{201C}'..='\u{201F}' | '«' | '»' | '\u{FF02}' => "\"",
        '\u{FF03}' => "#",
        _ if !c.is_ascii() && c.is_whitespace() => " ",
        _ => return None,
    })
}

/// The digit or sign of an exponent that is written raised.
pub(super) fn superscript_meant(c: char) -> Option<char> {
    Some(match c {
        '⁰' => '0',
        '¹' => '1',
        '²' => '2',
        '³' => '3',
        '⁴' => '4',
        '⁵' => '5',
        '⁶' => '6',
        '⁷' => '7',
        '⁸' => '8',
        '⁹' => '9',
        '⁻' => '-',
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_greek_letter_but_the_final_sigma_is_a_name_character() {
        for c in ('\u{391}'..='\u{3C9}').filter(|c| c.is_alphabetic()) {
            let variant = matches!(c, 'ς' | '\u{3AA}'..='\u{3B0}');
            assert_eq!(is_name_character(c), !variant, "{c}");
            assert!(is_word_character(c), "{c}");
        }
    }

    #[test]
    fn mathematical_alphabets_are_understood() {
        for (look, meant) in [
            ('𝐀', 'A'),
            ('𝜎', 'σ'),
            ('𝝈', 'σ'),
            ('𝜍', 'σ'),
            ('𝑥', 'x'),
            ('𝟬', '0'),
            ('𝟿', '9'),
            ('𝚉', 'Z'),
            ('𝛩', 'Θ'),
            ('𝜔', 'ω'),
            ('𝜅', 'κ'),
            ('𝜘', 'κ'),
            ('𝜖', 'ε'),
            ('𝚨', 'Α'),
        ] {
            assert_eq!(letter_meant(look), Some(meant), "{look}");
        }
        assert_eq!(letter_meant('𝛁'), None);
        assert_eq!(letter_meant('𝛛'), None);
    }

    #[test]
    fn no_look_alike_is_a_name_character_itself() {
        for c in ('\u{80}'..='\u{1FFFF}').filter(|c| is_name_character(*c)) {
            assert_eq!(letter_meant(c), None, "{c}");
            assert_eq!(sign_meant(c), None, "{c}");
        }
    }
}
