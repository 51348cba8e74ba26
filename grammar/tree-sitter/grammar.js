/**
 * @file The Sweep language for tree-sitter, after `../sweep.ebnf`, which is normative.
 *
 * Two things are simpler than there: a number has no components (`2.x` is never sound), and what
 * a name with a parenthesis behind it means is left open: it is always an `application`.
 *
 * @license MIT OR Apache-2.0
 */

/// <reference types="tree-sitter-cli/dsl" />
// @ts-check

const KEYWORDS = [
  'param',
  'let',
  'profile',
  'sweep',
  'curve',
  'construction',
  'surface',
  'expect',
  'import',
  'unit',
  'where',
  'in',
  'on',
];

const LETTER = 'A-Za-z_Α-ΡΣ-Ωα-ρσ-ωµϕϰϱϵ';
/** What may stand neither in a comment nor in a string: marks that reorder a line, and the BOM. */
const DECEPTIVE = '\\u202A-\\u202E\\u2066-\\u2069\\uFEFF';

const PLUS_OR_MINUS = ['+', '-', '−'];
const MINUS = ['-', '−'];
const TIMES = ['*', '·', '×'];
const RELATIONS = ['==', '!=', '<', '<=', '>', '>='];

/** @param {RuleOrLiteral} item */
const commaSeparated = item => seq(item, repeat(seq(',', item)));

/** `name(u) in xz on [0, 1] = …`, behind the keyword of a curve. */
const curve = (/** @type {GrammarSymbols<string>} */ $) =>
  seq(
    field('name', $.name),
    '(',
    field('parameter', $.name),
    ')',
    optional(seq('in', field('plane', $.plane))),
    optional(seq('on', field('domain', $.interval))),
    '=',
    field('value', $._expression),
  );

module.exports = grammar({
  name: 'sweep',

  word: $ => $.name,
  extras: $ => [/[\t\n\r ]/, $.comment],
  reserved: { global: () => KEYWORDS },
  supertypes: $ => [$.declaration],

  rules: {
    document: $ => repeat($.declaration),

    comment: () => token(new RegExp(`#[^\\n\\r${DECEPTIVE}]*`)),

    // Declarations

    declaration: $ =>
      choice(
        $.param_declaration,
        $.let_declaration,
        $.profile_declaration,
        $.sweep_declaration,
        $.curve_declaration,
        $.construction_declaration,
        $.surface_declaration,
        $.expect_declaration,
        $.import_declaration,
        $.unit_declaration,
      ),

    param_declaration: $ =>
      seq('param', field('name', $.name), '=', field('value', $._expression)),

    let_declaration: $ =>
      seq(
        'let',
        field('name', $.name),
        optional(field('parameters', $.parameters)),
        '=',
        field('value', $._expression),
      ),

    profile_declaration: $ => seq('profile', curve($)),
    sweep_declaration: $ => seq('sweep', curve($)),
    curve_declaration: $ => seq('curve', curve($)),

    construction_declaration: $ =>
      seq(
        'construction',
        field('name', $.name),
        field('parameters', $.parameters),
        '=',
        field('value', $._expression),
        optional($.where_clause),
      ),

    where_clause: $ => seq('where', commaSeparated($.binding)),
    binding: $ => seq(field('name', $.name), '=', field('value', $._expression)),

    surface_declaration: $ =>
      seq(
        'surface',
        field('name', $.name),
        optional(seq('on', field('domain', $.rectangle))),
        '=',
        field('value', $._expression),
      ),

    expect_declaration: $ =>
      seq(
        'expect',
        field('left', $._expression),
        optional(seq(field('relation', choice(...RELATIONS)), field('right', $._expression))),
      ),

    import_declaration: $ => seq('import', field('path', $.string)),
    unit_declaration: $ => seq('unit', field('unit', alias($.name, $.unit))),

    parameters: $ => seq('(', commaSeparated($.name), ')'),
    plane: () => choice('xy', 'xz', 'yz'),
    interval: $ =>
      seq('[', field('start', $._expression), ',', field('end', $._expression), ']'),
    rectangle: $ => seq(field('u', $.interval), choice('x', '×'), field('v', $.interval)),

    // Expressions. The sign in front of an expression covers its first product, that in front of
    // a factor only the power behind it; so a product that may begin with a sign and one that may
    // not are told apart.

    _expression: $ => choice($.sum, $._term),

    sum: $ =>
      seq(
        field('left', choice($.sum, $._term)),
        field('operator', choice(...PLUS_OR_MINUS)),
        field('right', $._product),
      ),

    _term: $ => choice(alias($._negated_product, $.negation), $._unsigned_product),
    _negated_product: $ => seq(choice(...MINUS), field('value', $._product)),

    _product: $ => choice($._factor, $.product, $.quotient),
    product: $ => product($._product, $),
    quotient: $ => quotient($._product, $),

    _unsigned_product: $ =>
      choice(
        $._power,
        alias($._unsigned_product_of_two, $.product),
        alias($._unsigned_quotient, $.quotient),
      ),
    _unsigned_product_of_two: $ => product($._unsigned_product, $),
    _unsigned_quotient: $ => quotient($._unsigned_product, $),

    _factor: $ => choice($.negation, $._power),
    negation: $ => seq(choice(...MINUS), field('value', $._factor)),

    _power: $ => choice($.number, alias($._power_of_number, $.power), $._beside),
    _power_of_number: $ => power($.number, $),

    // What may multiply by standing beside another factor: anything but a number.
    _beside: $ => choice($._operand, $.power),
    power: $ => power($._operand, $),

    _exponent: $ =>
      choice(
        $._exponent_base,
        alias($._power_in_exponent, $.power),
        alias($._negated_number, $.negation),
      ),
    _exponent_base: $ => choice($.number, $.group, alias($._plain_reference, $.reference)),
    _power_in_exponent: $ => power($._exponent_base, $),
    _negated_number: $ => seq(choice(...MINUS), field('value', $.number)),
    _plain_reference: $ => field('name', $.name),

    _operand: $ => choice($.reference, $.application, $.component, $.group, $.tuple),

    // The longest match: in `a.x.y` the `x` is qualified by `a`, and `y` is a component of that.
    reference: $ =>
      prec.right(
        1,
        seq(
          choice(
            field('name', $.name),
            seq(field('qualifier', $.name), '.', field('name', $.name)),
          ),
          repeat($.prime),
        ),
      ),

    application: $ =>
      prec(
        1,
        seq(
          field('function', alias($.reference, $.function)),
          field('arguments', $.arguments),
        ),
      ),
    arguments: $ => seq('(', optional(commaSeparated($._argument)), ')'),
    _argument: $ => choice($.labelled_argument, $._argument_value),
    labelled_argument: $ =>
      seq(field('label', $.name), ':', field('value', $._argument_value)),
    _argument_value: $ => choice($._expression, $.list, $.string),
    list: $ => seq('[', optional(commaSeparated($._expression)), ']'),

    component: $ => seq(field('value', $._operand), '.', field('name', $.name)),
    group: $ => seq('(', $._expression, ')'),
    tuple: $ => seq('(', $._expression, repeat1(seq(',', $._expression)), ')'),

    // Words

    name: () => token(new RegExp(`[${LETTER}][${LETTER}0-9]*`)),
    number: () => token(/[0-9]+(\.[0-9]+)?(e[+\-−]?[0-9]+)?/),
    string: () => token(new RegExp(`"[^"\\n\\r${DECEPTIVE}]*"`)),
    prime: () => choice("'", '’', '′', '″'),
  },
});

/**
 * A product of two factors, `a * b` or `a b`.
 *
 * @param {RuleOrLiteral} left
 * @param {GrammarSymbols<string>} $
 */
function product(left, $) {
  return choice(
    seq(field('left', left), field('operator', choice(...TIMES)), field('right', $._factor)),
    seq(field('left', left), field('right', $._beside)),
  );
}

/**
 * `a / b`
 *
 * @param {RuleOrLiteral} left
 * @param {GrammarSymbols<string>} $
 */
function quotient(left, $) {
  return seq(field('left', left), field('operator', '/'), field('right', $._factor));
}

/**
 * `a^b`, where the exponent may be a power again.
 *
 * @param {RuleOrLiteral} base
 * @param {GrammarSymbols<string>} $
 */
function power(base, $) {
  return seq(field('base', base), '^', field('exponent', $._exponent));
}
