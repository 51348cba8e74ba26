[
  (profile_declaration)
  (sweep_declaration)
  (curve_declaration)
  (let_declaration)
  (param_declaration)
  (construction_declaration)
  (surface_declaration)
  (expect_declaration)
  (arguments)
  (list)
  (comment)+
] @fold
