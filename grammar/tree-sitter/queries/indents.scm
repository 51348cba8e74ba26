; Lines of a declaration behind its first one are indented, and so is what stands in brackets.

[
  (param_declaration)
  (let_declaration)
  (profile_declaration)
  (sweep_declaration)
  (curve_declaration)
  (construction_declaration)
  (surface_declaration)
  (expect_declaration)
  (arguments)
  (parameters)
  (group)
  (tuple)
  (list)
  (interval)
] @indent.begin

[
  ")"
  "]"
] @indent.branch @indent.end

(where_clause) @indent.begin

(comment) @indent.auto
