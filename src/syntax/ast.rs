//! The tree of a file. It keeps every comment and the place of every node, and decides nothing
//! that depends on the meaning of names: whether `a (b)` applies `a` or multiplies by it is left
//! to the floor that knows what `a` is.

use crate::diag::{FileId, Span};

/// One parsed file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Document {
    /// The file.
    pub file: FileId,
    /// Its declarations, in the order of the text. Those that could not be parsed are missing.
    pub items: Vec<Item>,
    /// Its comments, from `#` to the end of the line, in the order of the text.
    pub comments: Vec<Span>,
    /// What the declarations would declare that could not be parsed, so that a use of it need not
    /// be reported as unknown.
    pub broken: Vec<Broken>,
}

/// What a declaration that could not be parsed would declare, as far as that is known.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Broken {
    /// The name.
    pub name: Name,
    /// What kind of curve it stands for, if it stands for one. Its properties may be used without
    /// its name.
    pub role: Option<Role>,
}

/// A declaration and the text it spans.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Item {
    /// From the keyword to the last token, or to the first one behind it that has no place there.
    pub span: Span,
    /// What is declared.
    pub declaration: Declaration,
}

/// An identifier.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Name {
    /// The canonical spelling: `sigma` is `σ`, `kappa` is `κ`, `rho` is `ρ`, look-alikes are folded.
    pub text: String,
    /// Where it stands.
    pub span: Span,
}

/// A coordinate plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Plane {
    /// e₁ = i, e₂ = j
    Xy,
    /// e₁ = i, e₂ = k
    Xz,
    /// e₁ = j, e₂ = k
    Yz,
}

/// A closed interval `[a, b]` of constant expressions.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Interval {
    /// The lower end.
    pub start: Expr,
    /// The upper end.
    pub end: Expr,
    /// Both brackets included.
    pub span: Span,
}

/// What a curve is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Role {
    /// `profile`, in `u`
    Profile,
    /// `sweep`, in `v`
    Sweep,
    /// `curve`, in either
    Further,
}

/// One declaration.
#[allow(
    clippy::large_enum_variant,
    reason = "a file has few declarations, and the tree reads better without boxes"
)]
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Declaration {
    /// `param NAME = CONST`
    Param {
        /// Its name.
        name: Name,
        /// The value unless the command line gives another.
        value: Expr,
    },
    /// `let NAME = CONST`, `let NAME(u) = EXPR`, …
    Let {
        /// Its name.
        name: Name,
        /// `u`, `v`, both, or none for a constant.
        parameters: Vec<Name>,
        /// Its value.
        value: Expr,
    },
    /// `profile`, `sweep`, `curve`
    Curve {
        /// Which keyword.
        role: Role,
        /// Its name.
        name: Name,
        /// `u` or `v`
        parameter: Name,
        /// `in PLANE`
        plane: Option<(Plane, Span)>,
        /// `on [a, b]`
        domain: Option<Interval>,
        /// An expression or a constructor such as `line(P, Q)`.
        value: Expr,
    },
    /// `construction NAME(p, c) = EXPR where q = EXPR, …`
    Construction {
        /// Its name.
        name: Name,
        /// What it is given.
        parameters: Vec<Name>,
        /// The surface.
        body: Expr,
        /// The names after `where`.
        bindings: Vec<(Name, Expr)>,
    },
    /// `surface NAME on [a, b] x [c, d] = EXPR`
    Surface {
        /// Its name.
        name: Name,
        /// The domain in u and in v.
        domain: Option<(Interval, Interval)>,
        /// The surface.
        value: Expr,
    },
    /// `expect A == B`, `expect PREDICATE`
    Expect {
        /// The left side or the predicate.
        left: Expr,
        /// The relation and the right side.
        relation: Option<(Relation, Expr)>,
    },
    /// `import "file.sweep"`
    Import {
        /// What stands between the quotes.
        path: String,
        /// Quotes included.
        path_span: Span,
    },
    /// `unit mm`
    Unit {
        /// The word.
        name: Name,
    },
}

/// How two sides of an expectation compare.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Relation {
    /// `==`
    Equal,
    /// `!=`
    NotEqual,
    /// `<`
    Less,
    /// `<=`
    LessOrEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterOrEqual,
}

/// An expression and the text it spans.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Expr {
    /// From its first to its last token.
    pub span: Span,
    /// What it is.
    pub kind: ExprKind,
}

/// The sign of a term of a sum.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Sign {
    /// `+`, or none before the first term
    Plus,
    /// `-`
    Minus,
}

/// How a factor joins the factors before it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ProductOp {
    /// `*`, and the first factor
    Times,
    /// `/`
    Divide,
    /// nothing between them
    Juxtapose,
}

/// A name with what may stand around it: `c`, `c.σ`, `f'`, `c.σ'`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Reference {
    /// `c` of `c.σ`
    pub qualifier: Option<Box<Name>>,
    /// `σ` of `c.σ`
    pub name: Name,
    /// How many primes follow.
    pub primes: u32,
    /// All of it.
    pub span: Span,
}

impl Reference {
    /// The name that stands first: `c` of `c.σ`, `f` of `f'`.
    #[must_use]
    pub fn first(&self) -> &Name {
        self.qualifier.as_deref().unwrap_or(&self.name)
    }
}

/// An argument, with its label if it has one: `branch: best`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Argument {
    /// `branch`
    pub label: Option<Name>,
    /// `best`
    pub value: Expr,
}

/// The forms of an expression.
///
/// Sums and products are flat lists, so a chain of a million terms needs no recursion.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ExprKind {
    /// A number as it is written: `7`, `0.8`, `1.5e-3`.
    Number(String),
    /// A string, without its quotes; only constructor arguments take one.
    Text(String),
    /// Terms with their signs; at least one. A single term has the sign minus.
    Sum(Vec<(Sign, Expr)>),
    /// Two factors or more; the first joins by `Times`.
    Product(Vec<(ProductOp, Expr)>),
    /// Unary minus inside a product, `2 * -x`.
    Negate(Box<Expr>),
    /// `base ^ exponent`; the exponent is a number, a negated number, a reference, a group or a power.
    Power(Box<Expr>, Box<Expr>),
    /// A name on its own.
    Reference(Reference),
    /// A name with a parenthesis behind it: an application or a product.
    Apply {
        /// What stands before the parenthesis.
        function: Reference,
        /// What stands in it; may be empty.
        arguments: Vec<Argument>,
        /// The parenthesis, brackets included.
        parenthesis: Span,
    },
    /// `(…).x`, `c(v).x`
    Component(Box<Expr>, Name),
    /// `(a, b)`, `(a, b, c)`; two entries or more.
    Tuple(Vec<Expr>),
    /// `[P, …]`; only constructor arguments take one.
    List(Vec<Expr>),
    /// `(a)`
    Group(Box<Expr>),
}
