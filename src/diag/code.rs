use std::fmt;

/// How much a finding weighs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Severity {
    /// The input is wrong; nothing is written for it.
    Error,
    /// The input is odd, the result stands.
    Warning,
}

macro_rules! codes {
    ($($name:ident $title:literal,)*) => {
        /// The stable code of a diagnostic. A code is never given to another rule.
        ///
        /// `E00xx` text and syntax, `E01xx` names and types, `E02xx` curves and properties,
        /// `E03xx` surfaces and exactness, `E04xx` expectations, `E05xx` limits, `E06xx` files;
        /// `W1xxx` warnings.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum Code {
            $(#[doc = $title] $name,)*
        }

        impl Code {
            /// Every code, in order.
            pub const ALL: &'static [Code] = &[$(Code::$name,)*];

            /// The code as it is printed.
            #[must_use]
            pub fn as_str(self) -> &'static str {
                match self { $(Code::$name => stringify!($name),)* }
            }

            /// The rule in a few words.
            #[must_use]
            pub fn title(self) -> &'static str {
                match self { $(Code::$name => $title,)* }
            }

            /// The page on the code, in Markdown: the rule, its reason, a text that breaks it and
            /// one that keeps it.
            #[must_use]
            pub fn explanation(self) -> &'static str {
                match self {
                    $(Code::$name => include_str!(concat!("explain/", stringify!($name), ".md")),)*
                }
            }
        }
    };
}

codes! {
    // text and syntax
    E0001 "the text is not valid UTF-8",
    E0002 "a character that has no place in the language",
    E0003 "a character that looks like another",
    E0004 "a malformed number",
    E0005 "an unclosed bracket or string",
    E0006 "an unexpected token",
    E0007 "a decimal comma",
    E0008 "a number as the right factor of a juxtaposition",
    E0009 "an exponent of the wrong form",
    // names and types
    E0101 "an unknown name",
    E0102 "a name declared twice",
    E0103 "a reserved name",
    E0104 "definitions that need each other",
    E0105 "a property that needs its curve's name",
    E0106 "operands of the wrong type",
    E0107 "the wrong number or kind of arguments",
    E0108 "a constant is needed here",
    E0109 "a parameter that is not in scope",
    E0110 "not in this version",
    E0111 "an unknown component or property",
    E0112 "a parameter that the file does not declare",
    // curves and properties
    E0201 "not a Pythagorean hodograph",
    E0202 "the parametric speed is not rational: a factor of the hodograph changes sign",
    E0203 "the arc length is not rational",
    E0204 "a curve without motion",
    E0205 "an empty or reversed domain",
    E0206 "a property of plane curves only",
    E0207 "division by zero",
    E0208 "a malformed curve",
    E0210 "a square root that is not rational",
    E0211 "domains or units that differ",
    // surfaces and exactness
    E0301 "a pole on the domain",
    E0302 "not a surface",
    E0303 "nothing to build",
    E0304 "a weight that the format cannot carry",
    E0305 "a degree that the format cannot carry",
    E0306 "a number outside the range of the format",
    E0307 "the unit normal is not rational",
    E0308 "a mesh that the numbers of the format do not resolve",
    // expectations
    E0401 "an expectation that fails",
    E0402 "an expectation that is undecided",
    // limits
    E0501 "the source is too large",
    E0502 "too deeply nested",
    E0503 "a literal with too many digits",
    E0504 "an exponent that is too large",
    E0505 "a degree or a number of terms that is too large",
    E0506 "too many imports",
    E0507 "a coefficient that is too large",
    E0508 "a run that takes too much time or memory",
    E0509 "a field of too large a degree",
    E0510 "too many variants",
    E0511 "too many triangles",
    // files
    E0601 "a file that cannot be read",
    E0602 "a file that cannot be written",
    E0603 "an import outside the project folder",
    E0604 "files that import each other",
    E0605 "a malformed list of variants",
    // warnings
    W1001 "a quotient followed by a juxtaposed factor",
    W1002 "a construction of the standard library is replaced",
    W1003 "a cusp of a curve",
    W1004 "a zero that numerator and denominator share",
    W1005 "a number that becomes zero or subnormal as a double",
    W1006 "a large ratio of weights",
    W1007 "nothing to build",
    W1008 "control points that become equal as doubles",
    W1009 "a surface written without its edges",
    W1010 "a coordinate that is zero because of the curve's plane",
    W1011 "a surface that is not regular",
}

impl Code {
    /// Error or warning, as the first letter says.
    #[must_use]
    pub fn severity(self) -> Severity {
        if self.as_str().starts_with('E') {
            Severity::Error
        } else {
            Severity::Warning
        }
    }

    /// What the codes that begin with the same three letters are about.
    #[must_use]
    pub fn group(self) -> &'static str {
        match &self.as_str()[..3] {
            "E00" => "text and syntax",
            "E01" => "names and types",
            "E02" => "curves and properties",
            "E03" => "surfaces and exactness",
            "E04" => "expectations",
            "E05" => "limits",
            "E06" => "files",
            _ => "warnings",
        }
    }

    /// Whether the code is about text and syntax.
    #[must_use]
    pub fn is_syntax(self) -> bool {
        self.as_str().starts_with("E00")
    }

    /// Whether the code stands for a limit that was reached (exit status 4).
    #[must_use]
    pub fn is_limit(self) -> bool {
        self.as_str().starts_with("E05")
    }

    /// Whether the code stands for a file that could not be read or written (exit status 3).
    #[must_use]
    pub fn is_file(self) -> bool {
        matches!(self, Code::E0601 | Code::E0602)
    }
}

impl fmt::Display for Code {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.as_str())
    }
}
