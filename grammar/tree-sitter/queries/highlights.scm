; No node is captured twice: editors disagree on which of two patterns wins.

(comment) @comment
(number) @number
(string) @string

; Keywords

[
  "param"
  "let"
  "profile"
  "sweep"
  "curve"
  "construction"
  "surface"
  "expect"
  "unit"
  "where"
  "in"
  "on"
] @keyword

"import" @keyword.import

; Signs

[
  "+"
  "-"
  "−"
  "*"
  "·"
  "×"
  "/"
  "^"
  "="
  "=="
  "!="
  "<"
  "<="
  ">"
  ">="
  (prime)
] @operator

(rectangle "x" @operator)

[
  "("
  ")"
  "["
  "]"
] @punctuation.bracket

[
  ","
  ":"
  "."
] @punctuation.delimiter

; Declared names

(param_declaration name: (name) @constant)
(let_declaration name: (name) @constant !parameters)
(let_declaration name: (name) @function parameters: (_))
(profile_declaration name: (name) @function)
(sweep_declaration name: (name) @function)
(curve_declaration name: (name) @function)
(construction_declaration name: (name) @function)
(surface_declaration name: (name) @type)
(binding name: (name) @variable)

(profile_declaration parameter: (name) @variable.parameter)
(sweep_declaration parameter: (name) @variable.parameter)
(curve_declaration parameter: (name) @variable.parameter)
(parameters (name) @variable.parameter)

(plane) @constant.builtin
(unit) @constant.builtin

; Names in expressions

(labelled_argument label: (name) @label)

; Parameters, unit vectors, and properties of the only profile and the only sweep curve, with a
; parenthesis behind them or without

([
  (reference !qualifier name: (name) @variable.parameter)
  (function !qualifier name: (name) @variable.parameter)
]
  (#any-of? @variable.parameter
    "u" "v"))

([
  (reference !qualifier name: (name) @constant.builtin)
  (function !qualifier name: (name) @constant.builtin)
]
  (#any-of? @constant.builtin
    "i" "j" "k"))

([
  (reference !qualifier name: (name) @property)
  (function !qualifier name: (name) @property)
]
  (#any-of? @property
    "x" "y" "z" "s" "t" "n"
    "σ" "sigma" "κ" "ϰ" "kappa" "ρ" "ϱ" "rho"))

(_ qualifier: (name) @variable name: (name) @property)
(component name: (name) @property)

; Constructors of curves

(function
  !qualifier
  name: (name) @constructor
  (#any-of? @constructor
    "arc" "bezier" "bspline" "circle" "envelope" "join" "line" "motion" "ph" "ph3" "ph_hermite"
    "ph_spline" "re_hermite" "rrmf" "solid"))

; Built-in functions, and what an expectation may ask for

(function
  !qualifier
  name: (name) @function.builtin
  (#any-of? @function.builtin
    "cross" "dot" "du" "dv" "end" "length" "matrix" "norm2" "normal" "offset" "sqrt" "start"
    "bidegree" "common_factor" "positive_weights" "rational_offset" "regular"))

; All others

(function
  !qualifier
  name: (name) @function.call
  (#not-any-of? @function.call
    "u" "v" "i" "j" "k"
    "x" "y" "z" "s" "t" "n"
    "σ" "sigma" "κ" "ϰ" "kappa" "ρ" "ϱ" "rho"
    "arc" "bezier" "bspline" "circle" "envelope" "join" "line" "motion" "ph" "ph3" "ph_hermite"
    "ph_spline" "re_hermite" "rrmf" "solid"
    "cross" "dot" "du" "dv" "end" "length" "matrix" "norm2" "normal" "offset" "sqrt" "start"
    "bidegree" "common_factor" "positive_weights" "rational_offset" "regular"))

(reference
  !qualifier
  name: (name) @variable
  (#not-any-of? @variable
    "u" "v" "i" "j" "k"
    "x" "y" "z" "s" "t" "n"
    "σ" "sigma" "κ" "ϰ" "kappa" "ρ" "ϱ" "rho"))
